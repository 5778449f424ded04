// The area that robots sweep, from above: their shapes at the frames of all replays, as one outline of small squares.

import { hullCorners, linkAt } from "./instant.js";
import { hull, inside } from "./plan.js";

/** Side of a square, m. */
const CELL_M = 0.025;
/** About so many frames are drawn; what lies between them is near. */
const FRAMES = 1000;
/** Directions, in which some corner of a shape reaches farthest; a few dozen tell its outline. */
const DIRECTIONS = [-1, 0, 1].flatMap((i) => [-1, 0, 1].flatMap((j) => [-1, 0, 1].map((k) => [i, j, k])));

/** A link with only those of its corners that reach farthest in some direction. */
function coarse(link) {
  if (!link.points_m) {
    return link;
  }
  const along = ([x, y, z], [i, j, k]) => i * x + j * y + k * z;
  const farthest = DIRECTIONS.map((d) => link.points_m.reduce((a, b) => (along(b, d) > along(a, d) ? b : a)));
  return { ...link, points_m: [...new Set(farthest)] };
}

/** Outline of a link from above at a frame: a convex polygon, or a segment with a radius. */
export function footprint(replay, cell, frame, index, link = cell.links[index]) {
  const pose = linkAt(replay, cell, frame, index);
  if (pose.position) {
    return { polygon: hull(hullCorners(link, pose).map(([x, y]) => [x, y])), radius: 0 };
  }
  return { polygon: [pose.a.slice(0, 2), pose.b.slice(0, 2)], radius: pose.radius };
}

function nearSegment([px, py], [[ax, ay], [bx, by]], radius) {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
  return (px - ax - t * dx) ** 2 + (py - ay - t * dy) ** 2 <= radius * radius;
}

/** Rectangles, as corner, width and height in metres, of all that the robots sweep within the bounds. */
export function swept(replays, cell, [[left, right], [low, high]]) {
  const [columns, rows] = [right - left, high - low].map((size) => Math.ceil(size / CELL_M));
  const filled = new Uint8Array(columns * rows);
  const links = cell.links.map(coarse);
  const step = Math.max(1, Math.ceil(replays.reduce((sum, replay) => sum + replay.frames, 0) / FRAMES));

  function mark({ polygon, radius }) {
    const span = (axis, from, count) => {
      const values = polygon.map((p) => p[axis]);
      const first = Math.floor((Math.min(...values) - radius - from) / CELL_M);
      return [Math.max(0, first), Math.min(count - 1, Math.floor((Math.max(...values) + radius - from) / CELL_M))];
    };
    const [[c0, c1], [r0, r1]] = [span(0, left, columns), span(1, low, rows)];
    for (let row = r0; row <= r1; row++) {
      for (let column = c0; column <= c1; column++) {
        const at = row * columns + column;
        const middle = [left + (column + 0.5) * CELL_M, low + (row + 0.5) * CELL_M];
        filled[at] ||= radius > 0 ? nearSegment(middle, polygon, radius) : inside(middle, polygon);
      }
    }
  }

  for (const replay of replays) {
    for (let frame = 0; frame < replay.frames; frame += step) {
      links.forEach((link, index) => mark(footprint(replay, cell, frame, index, link)));
    }
  }
  const runs = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const from = column;
      while (column < columns && filled[row * columns + column]) {
        column += 1;
      }
      if (column > from) {
        // A little higher than a square, so that no seam shows between the rows.
        runs.push({ x: left + from * CELL_M, y: low + row * CELL_M, width: (column - from) * CELL_M, height: 1.2 * CELL_M });
      }
    }
  }
  return runs;
}
