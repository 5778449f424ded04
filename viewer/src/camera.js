// Where the camera stands: presets, and a default from which person, robot and contact are seen well.

import { Vector3 } from "three";
import { between } from "./near.js";

const UP = new Vector3(0, 0, 1);
const DEG = Math.PI / 180;

/** Unit vector from the scene to the camera. */
function direction(azimuth, elevation) {
  return new Vector3(Math.cos(azimuth) * Math.cos(elevation), Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation));
}

/** Camera position and target from which all points are seen along a direction, as near as possible. */
function fit(points, towards, camera) {
  // Seen straight from above there is no upright axis on the picture; the cell's y axis takes its place.
  const hint = Math.abs(towards.z) > 0.999 ? new Vector3(0, 1, 0) : UP;
  const right = new Vector3().crossVectors(hint, towards).normalize();
  const above = new Vector3().crossVectors(towards, right);
  const axes = [right, above];
  const centre = new Vector3();
  for (const axis of [right, above, towards]) {
    const along = points.map(({ p }) => axis.dot(p));
    centre.addScaledVector(axis, (Math.min(...along) + Math.max(...along)) / 2);
  }
  const tangent = Math.tan((camera.fov * DEG) / 2);
  const tangents = [tangent * camera.aspect, tangent];
  let distance = 0.3;
  for (const { p, radius } of points) {
    const offset = p.clone().sub(centre);
    axes.forEach((axis, index) => {
      const needed = (Math.abs(axis.dot(offset)) + radius) / tangents[index] + towards.dot(offset) + radius;
      distance = Math.max(distance, needed);
    });
  }
  return { position: centre.clone().addScaledVector(towards, 1.06 * distance), target: centre, distance };
}

/** How much farther away the camera may go to show a thing that is not the person, the robot or the contact. */
const FARTHER = 1.25;

/** The same with those of the other things of the subject, in their order, that do not make the persons tiny. */
function fitWithOthers({ points, others }, towards, camera) {
  let view = fit(points, towards, camera);
  const farthest = FARTHER * view.distance;
  let shown = points;
  for (const other of others) {
    const wider = fit([...shown, ...other], towards, camera);
    if (wider.distance <= farthest) {
      shown = [...shown, ...other];
      view = wider;
    }
  }
  return view;
}

/** Whether the way from `from` to `to` goes through an upright wall. */
function crosses(from, to, { a, b, top }) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const [ex, ey] = [b[0] - a[0], b[1] - a[1]];
  const area = dx * ey - dy * ex;
  const t = ((a[0] - from[0]) * ey - (a[1] - from[1]) * ex) / area;
  const s = ((a[0] - from[0]) * dy - (a[1] - from[1]) * dx) / area;
  return area !== 0 && t > 0 && t < 1 && s > 0 && s < 1 && from[2] + t * (to[2] - from[2]) < top;
}

/** The 3/4 view: person and robot beside each other, little between camera and contact, as near as may be. */
function overview(subject, camera) {
  const { points, capsules, walls, contact, person, robot } = subject;
  const across = Math.atan2(robot[1] - person[1], robot[0] - person[0]);
  const elevation = 24 * DEG;
  const views = [];
  for (let turn = -175; turn <= 180; turn += 5) {
    const towards = direction(across + turn * DEG, elevation);
    const view = fit(points, towards, camera);
    const eye = view.position.toArray();
    const hidden = capsules.filter((capsule) => between(eye, contact, capsule)).length;
    const dimmed = walls.filter((wall) => wall.some((edge) => crosses(eye, contact, edge) || crosses(eye, [...person, 1], edge))).length;
    // 90 degrees would show the two side by side; a little from behind the person is easier to read.
    const aside = Math.abs(Math.abs(turn) - 115) / 60;
    views.push({ towards, distance: view.distance, cost: hidden + 0.6 * Math.min(dimmed, 2) + aside });
  }
  const nearest = Math.min(...views.map((view) => view.distance));
  const cost = (view) => view.cost + 1.5 * (view.distance / nearest - 1);
  const best = views.reduce((a, b) => (cost(b) < cost(a) ? b : a));
  return fitWithOthers(subject, best.towards, camera);
}

/** Camera position and target of a preset. */
export function viewpoint(name, subject, camera) {
  const { contact, person, robot } = subject;
  const across = Math.atan2(robot[1] - person[1], robot[0] - person[0]);
  switch (name) {
    case "top":
      return fitWithOthers(subject, direction(-Math.PI / 2, 89.9 * DEG), camera);
    case "front":
      return fitWithOthers(subject, direction(-Math.PI / 2, 6 * DEG), camera);
    case "side":
      return fitWithOthers(subject, direction(0, 6 * DEG), camera);
    case "contact": {
      const whole = overview(subject, camera);
      const target = new Vector3(...contact);
      const towards = whole.position.clone().sub(whole.target).normalize();
      return { position: target.clone().addScaledVector(towards, 1.1), target };
    }
    case "eye": {
      const eye = new Vector3(...subject.head);
      const target = new Vector3(...contact);
      if (eye.distanceTo(target) < 0.4) {
        // What hits the head is too near to look at: the eye looks to where the robot comes from.
        target.copy(eye).add(new Vector3(Math.cos(across), Math.sin(across), -0.2));
      }
      return { position: eye, target };
    }
    default:
      return overview(subject, camera);
  }
}
