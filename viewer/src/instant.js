// What a replay says about one frame: capsules of the person, shapes of the robot, and which of them touch.

import { toSegment } from "./near.js";
import { turned } from "./plan.js";

const three = (array, at) => [array[at], array[at + 1], array[at + 2]];

/** Capsule of a part of the body at a frame. */
export function bodyAt(replay, cell, frame, part) {
  const at = 6 * (frame * cell.body.length + part);
  return { a: three(replay.body, at), b: three(replay.body, at + 3), radius: cell.body[part].radius_m };
}

/** The sides of the arms, in their order in the replays. */
export const SIDES = ["left", "right"];

/** Shoulder, elbow and wrist of an arm at a frame; 0 is the left one. */
export function armAt(replay, frame, side) {
  const at = 9 * (2 * frame + side);
  return [0, 3, 6].map((joint) => three(replay.arms, at + joint));
}

/** Where the person looks at a frame, in the plane: across the shoulders. */
export function headingAt(replay, hazard, frame) {
  const [[left], [right]] = SIDES.map((_, side) => armAt(replay, frame, side));
  const [x, y] = [left[0] - right[0], left[1] - right[1]];
  const length = Math.hypot(x, y);
  if (length < 0.02) {
    // Shoulders above each other tell nothing.
    const angle = (hazard.person_heading_deg * Math.PI) / 180;
    return [Math.cos(angle), Math.sin(angle), 0];
  }
  return [y / length, -x / length, 0];
}

/** Limb of an arm that a region names: 0 is the upper arm, 1 the forearm, 2 the hand; undefined for the rest of the body. */
export const limbOf = (region) => ({ upper_arm: 0, lower_arm: 1, hand: 2 })[region];

/** A link at a frame: end points of a capsule, or the pose of a hull or mesh. */
export function linkAt(replay, cell, frame, index) {
  const at = 7 * (frame * cell.links.length + index);
  const link = cell.links[index];
  if (link.shape === "capsule") {
    return { a: three(replay.links, at), b: three(replay.links, at + 3), radius: link.radius_m };
  }
  return { position: three(replay.links, at), quaternion: [...replay.links.slice(at + 3, at + 7)] };
}

/** Corners of a hull or mesh at a frame in the world. */
export function hullCorners(link, { position, quaternion }) {
  return link.points_m.map((corner) => turned(quaternion, corner).map((value, i) => value + position[i]));
}

/** Points that a link reaches to, without its radius. */
export function linkPoints(replay, cell, frame, index) {
  const pose = linkAt(replay, cell, frame, index);
  return pose.position ? hullCorners(cell.links[index], pose) : [pose.a, pose.b];
}

function nearest(indices, distance) {
  return indices.reduce((best, index) => (distance(index) < distance(best) ? index : best), indices[0]);
}

/** Index of the part of the body that is touched; a region may share its shape with others, so the place tells. */
export function touchedPart(replay, cell, hazard) {
  const distance = (part) => {
    const { a, b, radius } = bodyAt(replay, cell, replay.contact_frame, part);
    return toSegment(hazard.body_point_m, a, b) - radius;
  };
  return nearest([...cell.body.keys()], distance);
}

/** Index of the link that hits; several shapes may bear the same name. */
export function hittingLink(replay, cell, hazard) {
  const named = [...cell.links.keys()].filter((index) => {
    const { name, robot } = cell.links[index];
    return name === hazard.robot_link || `${robot}/${name}` === hazard.robot_link;
  });
  const distance = (index) => {
    const pose = linkAt(replay, cell, replay.contact_frame, index);
    const p = hazard.contact_point_m;
    if (pose.position) {
      return Math.min(...hullCorners(cell.links[index], pose).map((corner) => toSegment(p, corner, corner)));
    }
    return toSegment(p, pose.a, pose.b) - pose.radius;
  };
  return nearest(named.length > 0 ? named : [...cell.links.keys()], distance);
}

/** Indices of the lower legs; without any, of the last part. */
export function shanks(cell) {
  const legs = [...cell.body.keys()].filter((part) => cell.body[part].region.endsWith("shank"));
  return legs.length > 0 ? legs : [cell.body.length - 1];
}

/** Middle of the feet at each frame. */
export function path(replay, cell) {
  const parts = shanks(cell);
  return Array.from({ length: replay.frames }, (_, frame) => {
    const feet = parts.map((part) => bodyAt(replay, cell, frame, part).b);
    return [0, 1].map((axis) => feet.reduce((sum, foot) => sum + foot[axis], 0) / feet.length);
  });
}

/** Index of the highest part of the body: the head. */
export function headPart(replay, cell) {
  const height = (part) => -bodyAt(replay, cell, 0, part).a[2];
  return nearest([...cell.body.keys()], height);
}
