// Which names stand over the scene: the link that hits, zones and obstacles near the contact, the metres of the axes.

import { hullCorners, linkAt } from "./instant.js";
import { outline } from "./plan.js";
import { toOutline } from "./subject.js";

/** More obstacles than this are not named: the names would hide the picture. */
const OBSTACLES = 8;

const middle = (points) => [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);

const nearest = (points, to) => [...points].sort((a, b) => Math.hypot(a[0] - to[0], a[1] - to[1]) - Math.hypot(b[0] - to[0], b[1] - to[1]));

/** Edges' middles and corners of a polygon at a height, those near the contact first. */
function along(polygon, z, contact) {
  const middles = polygon.map((p, index) => middle([[...p, z], [...polygon[(index + 1) % polygon.length], z]]));
  return nearest([...middles, ...polygon.map((p) => [...p, z])], contact);
}

/** The names for a replay; `frame` tells which frame is shown. */
export function namesFor({ replay, cell, hazard, hitting, marks, colours, frame }) {
  const contact = replay.contact_m;
  const still = (points) => () => points;
  const link = () => {
    const pose = linkAt(replay, cell, frame(), hitting);
    const points = pose.position ? hullCorners(cell.links[hitting], pose) : [pose.a, pose.b];
    const [x, y] = middle(points);
    const top = Math.max(...points.map((p) => p[2])) + (pose.radius ?? 0);
    return [[x, y, top], middle(points)];
  };
  const zones = cell.zones.map((zone) => {
    const upright = zone.kind === "curtain" || zone.kind === "door";
    const points = along(zone.polygon_m, upright ? zone.z_m[1] : Math.max(...zone.z_m), contact);
    return { text: zone.title, kind: "zone", colour: colours[zone.kind], anchors: still(points) };
  });
  const obstacles = cell.obstacles
    .map((item, index) => ({ item, index, polygon: outline(item), distance: toOutline(contact, outline(item)) }))
    .sort((a, b) => a.distance - b.distance)
    .slice(0, OBSTACLES)
    .map(({ item, index, polygon }) => {
      const moved = (replay.moved ?? []).find(({ obstacle }) => obstacle === index);
      if (moved) {
        // Where it is now, if it is there.
        const now = () => [...moved.centre_m.slice(3 * frame(), 3 * frame() + 3)];
        return { text: item.name, kind: "obstacle", anchors: () => (moved.there[frame()] === "1" ? [now()] : []) };
      }
      const heights = [0.5, 0, -0.45].map((part) => item.centre_m[2] + part * item.size_m[2]);
      const points = heights.flatMap((z) => along(polygon, z, contact));
      return { text: item.name, kind: "obstacle", anchors: still([[...item.centre_m.slice(0, 2), heights[0]], ...points]) };
    });
  const ticks = marks.map(({ text, at }) => ({ text, kind: "tick", anchors: still([at]) }));
  return [{ text: hazard.robot_link, kind: "hitting", anchors: link }, ...zones, ...obstacles, ...ticks];
}
