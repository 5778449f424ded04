// The floor: a grid of metres, its two axes with metre marks, and the pedestals of robots that stand high.

import { BufferGeometry, Color, CylinderGeometry, Float32BufferAttribute, GridHelper, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, PlaneGeometry, ShadowMaterial } from "three";
import { linkPoints } from "./instant.js";
import { inside, outline } from "./plan.js";

const GRID_M = 20;
const TICK_M = 0.08;
/** A robot whose base is not above this stands on the floor. */
const STANDS_HIGH_M = 0.05;
const PEDESTAL_RADIUS_M = 0.11;
/** Links that begin as near to the axis of the base, and no higher above it, stand on it. */
const NEAR_BASE_M = 0.2;
const HIGHEST_BASE_M = 0.7;
const PEDESTAL = new MeshLambertMaterial({ color: "#59636f" });

/** What shadows fall on. */
export function ground() {
  const floor = new Mesh(new PlaneGeometry(GRID_M, GRID_M), new ShadowMaterial({ opacity: 0.18 }));
  floor.receiveShadow = true;
  floor.position.z = 0.002;
  return floor;
}

/** The grid in the colours of a theme. */
export function grid({ axis, grid: line }) {
  const helper = new GridHelper(GRID_M, GRID_M, axis, line);
  helper.rotation.x = Math.PI / 2;
  return helper;
}

/** The two axes along the edges of what is seen,, with a mark at each metre. */
export class Axes extends LineSegments {
  constructor() {
    super(new BufferGeometry(), new LineBasicMaterial());
  }

  set colour(value) {
    this.material.color = new Color(value);
  }

  /** Marks each whole metre along the two edges away from the camera, where most is seen; returns texts and places. */
  fit(bounds, camera) {
    const [[x0, x1], [y0, y1]] = bounds.map(([low, high]) => [low - 0.05, high + 0.05]);
    const whole = (low, high) => Array.from({ length: Math.max(0, Math.floor(high) - Math.ceil(low) + 1) }, (_, index) => Math.ceil(low) + index);
    // The mark nearest to the corner in which the axes meet tells which axis it is.
    const text = (axis, marks, at, corner) => (marks.every((other) => Math.abs(other - corner) >= Math.abs(at - corner)) ? `${axis} ${at} m` : `${at}`);
    const [alongX, alongY] = [whole(x0, x1), whole(y0, y1)];
    const far = (low, high, from) => (Math.abs(high - from) > Math.abs(low - from) ? [high, 1] : [low, -1]);
    const [[x, out], [y, on]] = [far(x0, x1, camera.x), far(y0, y1, camera.y)];
    const z = 0.014;
    const corners = [x0, y, z, x1, y, z, x, y0, z, x, y1, z];
    const marks = [];
    for (const at of alongX) {
      corners.push(at, y, z, at, y + on * TICK_M, z);
      marks.push({ text: text("x", alongX, at, x), at: [at, y + 2.6 * on * TICK_M, 0] });
    }
    for (const at of alongY) {
      corners.push(x, at, z, x + out * TICK_M, at, z);
      marks.push({ text: text("y", alongY, at, y), at: [x + 2.6 * out * TICK_M, at, 0] });
    }
    this.geometry.dispose();
    this.geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners, 3));
    return marks;
  }
}

/** Height on which a robot's pedestal stands: the floor, or an obstacle under it; null where it needs none. */
function stands([x, y, z], obstacles) {
  let from = 0;
  for (const obstacle of obstacles) {
    const half = obstacle.size_m[2] / 2;
    const [low, top] = [obstacle.centre_m[2] - half, obstacle.centre_m[2] + half];
    if (inside([x, y], outline(obstacle)) && low < z) {
      from = Math.max(from, Math.min(top, z));
    }
  }
  return z - from > STANDS_HIGH_M ? from : null;
}

/** A column from one height to another. */
function column([x, y], from, to, radius, name) {
  const mesh = new Mesh(new CylinderGeometry(radius, 1.2 * radius, to - from, 28), PEDESTAL);
  mesh.rotation.x = Math.PI / 2;
  mesh.position.set(x, y, (from + to) / 2);
  mesh.castShadow = true;
  mesh.userData.name = `${name} (drawn by the report; not in the cell file)`;
  return mesh;
}

/** A plain column under each robot that stands high on nothing that the cell file tells of. */
export function pedestals({ robots, obstacles }) {
  return (robots ?? []).flatMap(({ name, base_m: base, upright }) => {
    const from = base && upright ? stands(base, obstacles) : null;
    if (from === null) {
      return [];
    }
    return [column(base, from, base[2], PEDESTAL_RADIUS_M, `below ${name}`)];
  });
}

/** Between a robot's base and its lowest link nothing may be given; a column fills that, so that no robot floats. */
export function robotBases(cell, replay) {
  return (cell.robots ?? []).flatMap(({ name, base_m: base, upright }) => {
    if (!base || !upright) {
      return [];
    }
    const near = cell.links.flatMap((link, index) => (link.robot === name ? linkPoints(replay, cell, 0, index).map((p) => ({ p, radius: link.radius_m ?? 0 })) : []));
    const above = near.filter(({ p }) => Math.hypot(p[0] - base[0], p[1] - base[1]) < NEAR_BASE_M);
    const lowest = Math.min(...above.map(({ p, radius }) => p[2] - radius));
    const gap = lowest - base[2];
    return gap > 0.01 && gap < HIGHEST_BASE_M ? [column(base, base[2], lowest + 0.02, 0.8 * PEDESTAL_RADIUS_M, `base of ${name}`)] : [];
  });
}
