// What the camera has to show of a replay: person, robot and contact from the first frame to the contact, and what is near.

import { Vector3 } from "three";
import { armAt, bodyAt, linkAt, linkPoints, SIDES } from "./instant.js";
import { toSegment } from "./near.js";
import { outline } from "./plan.js";

/** So many frames tell where all moves. */
const FRAMES = 10;
/** Zones and obstacles are shown as far as this around person and robot, m. */
const AROUND_M = 0.8;

const range = (points, axis) => [Math.min(...points.map(({ p }) => p.getComponent(axis))), Math.max(...points.map(({ p }) => p.getComponent(axis)))];

/** Points that are in the picture in any case, each with a radius. */
function necessary(replay, cell) {
  const points = [];
  const take = (list, radius) => list.forEach((p) => points.push({ p: new Vector3(...p), radius }));
  const last = replay.contact_frame;
  const frames = new Set(Array.from({ length: FRAMES + 1 }, (_, i) => Math.round((i * last) / FRAMES)));
  for (const frame of frames) {
    cell.body.forEach((_, part) => {
      const { a, b, radius } = bodyAt(replay, cell, frame, part);
      take([a, b], radius);
    });
    SIDES.forEach((_, side) => take(armAt(replay, frame, side), 0.06));
    cell.links.forEach((link, index) => take(linkPoints(replay, cell, frame, index), link.radius_m ?? 0));
  }
  take([replay.contact_m], 0.1);
  return points;
}

/** Corners of a zone and of an obstacle, as far as they lie near. */
function corners(polygon, heights, [xs, ys]) {
  const near = ([low, high], value) => Math.max(low - AROUND_M, Math.min(high + AROUND_M, value));
  return polygon.flatMap(([x, y]) => heights.map((z) => ({ p: new Vector3(near(xs, x), near(ys, y), z), radius: 0.03 })));
}

/** Distance in the plane from a point to an outline's nearest edge. */
export function toOutline([x, y], polygon) {
  const edges = polygon.map((p, index) => [[...p, 0], [...polygon[(index + 1) % polygon.length], 0]]);
  return Math.min(...edges.map(([a, b]) => toSegment([x, y, 0], a, b)));
}

/** What one sees through only badly: upright zones and obstacles, as edges from above with the height of their top. */
function walls({ zones, obstacles }) {
  const edges = (polygon, top) => polygon.map((p, index) => ({ a: p, b: polygon[(index + 1) % polygon.length], top }));
  return [
    ...zones.filter(({ kind }) => kind === "curtain" || kind === "door").map((zone) => edges(zone.polygon_m, zone.z_m[1])),
    ...obstacles.map((item) => edges(outline(item), item.centre_m[2] + item.size_m[2] / 2)),
  ];
}

/** The subject of a replay for the camera. */
export function subjectOf(replay, cell, hazard) {
  const points = necessary(replay, cell);
  const bounds = [0, 1].map((axis) => range(points, axis));
  const at = replay.contact_frame;
  const links = [...cell.links.keys()];
  const capsules = [...cell.body.keys()].map((part) => bodyAt(replay, cell, at, part)).concat(links.map((index) => linkAt(replay, cell, at, index)).filter((pose) => !pose.position));
  const reporting = cell.zones.filter((zone) => replay.sensors.find(({ name }) => name === zone.name)?.detected.includes("1"));
  const obstacles = cell.obstacles.map((item) => ({ item, distance: toOutline(replay.contact_m, outline(item)) })).sort((a, b) => a.distance - b.distance);
  const robot = [0, 1].map((axis) => links.reduce((sum, index) => sum + linkPoints(replay, cell, at, index)[0][axis], 0) / links.length);
  return {
    points,
    bounds,
    others: [
      ...reporting.map((zone) => corners(zone.polygon_m, zone.z_m, bounds)),
      ...obstacles.slice(0, 1).map(({ item }) => corners(outline(item), [-0.5, 0.5].map((half) => item.centre_m[2] + half * item.size_m[2]), bounds)),
    ],
    // The touching shapes themselves always lie at the contact; they do not count as hiding it.
    capsules: capsules.filter(({ a, b, radius }) => toSegment(replay.contact_m, a, b) > radius + 0.03),
    contact: replay.contact_m,
    person: hazard.person_xy_m,
    robot,
    walls: walls(cell),
  };
}
