// Shapes of the scene: capsules that follow two end points, hulls and meshes, boxes, zones, the way of the person.

import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Shape,
  ShapeGeometry,
  SphereGeometry,
  Vector2,
  Vector3,
} from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";

/** A ball of radius 1. */
export const BALL = new SphereGeometry(1, 28, 18);
const TUBE = new CylinderGeometry(1, 1, 1, 28, 1, true);
const TUBE_AXIS = new Vector3(0, 1, 0);

/** A capsule; `place` moves it. */
export class Capsule extends Group {
  constructor(radius, material) {
    super();
    this.tube = new Mesh(TUBE, material);
    this.ends = [new Mesh(BALL, material), new Mesh(BALL, material)];
    this.ends.forEach((end) => end.scale.setScalar(radius));
    this.radius = radius;
    this.add(this.tube, ...this.ends);
    this.children.forEach((mesh) => (mesh.castShadow = true));
  }

  place(a, b) {
    const [from, to] = [new Vector3(...a), new Vector3(...b)];
    const axis = to.clone().sub(from);
    const length = axis.length();
    this.ends[0].position.copy(from);
    this.ends[1].position.copy(to);
    this.tube.visible = length > 1e-6;
    if (this.tube.visible) {
      this.tube.position.copy(from).addScaledVector(axis, 0.5);
      this.tube.scale.set(this.radius, length, this.radius);
      this.tube.quaternion.setFromUnitVectors(TUBE_AXIS, axis.divideScalar(length));
    }
  }

  set material(material) {
    this.children.forEach((mesh) => (mesh.material = material));
  }
}

/** A convex hull of points, or the triangles between them: each with its own corners, so that edges stay sharp. */
export class Hull extends Mesh {
  constructor(points, triangles, material) {
    if (triangles) {
      const corners = triangles.flatMap((triangle) => triangle.flatMap((corner) => points[corner]));
      super(new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners, 3)), material);
      this.geometry.computeVertexNormals();
    } else {
      super(new ConvexGeometry(points.map((p) => new Vector3(...p))), material);
    }
    this.castShadow = true;
  }

  place(position, quaternion) {
    this.position.set(...position);
    this.quaternion.set(...quaternion);
  }
}

/** An obstacle: a translucent box with its edges. */
export function obstacle({ centre_m: centre, size_m: size, quaternion }, material, edge) {
  const box = new BoxGeometry(...size);
  const mesh = new Mesh(box, material);
  mesh.add(new LineSegments(new EdgesGeometry(box), edge));
  mesh.position.set(...centre);
  mesh.quaternion.copy(new Quaternion(...quaternion));
  return mesh;
}

/** Upright faces along the edges of a polygon, or along the one edge of a line. */
function walls(polygon, low, high) {
  const corners = [];
  polygon.slice(polygon.length === 2 ? 1 : 0).forEach((q, index) => {
    const p = polygon.at(polygon.length === 2 ? 0 : index - 1);
    corners.push(...p, low, ...q, low, ...q, high, ...p, low, ...q, high, ...p, high);
  });
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners, 3));
}

function loop(polygon, z, material) {
  return new LineLoop(new BufferGeometry().setFromPoints(polygon.map(([x, y]) => new Vector3(x, y, z))), material);
}

/** How opaque a zone is: clear, and lit while its sensor reports the person. */
const CLEAR = { mat: 0.16, field: 0.07, curtain: 0.1, door: 0.1, post: 0.07, button: 0.6 };
const LIT = { mat: 0.55, field: 0.3, curtain: 0.26, door: 0.26, post: 0.3, button: 1 };

/** A sensor zone: flat on the floor or at its height; a curtain and a door stand upright. So does a button, at its own height. */
export class Zone extends Group {
  constructor({ kind, polygon_m: polygon, z_m: [low, high] }, colour) {
    super();
    this.kind = kind;
    this.fill = new MeshBasicMaterial({ color: colour, transparent: true, opacity: CLEAR[kind] ?? 0.1, side: DoubleSide, depthWrite: false });
    this.edge = new LineBasicMaterial({ color: colour });
    // A mat lies just above the floor's grid; equal heights would flicker.
    const floor = Math.max(low, 0.006);
    if (kind === "curtain" || kind === "door" || kind === "button") {
      this.add(new Mesh(walls(polygon, low, high), this.fill), loop(polygon, floor, this.edge), loop(polygon, high, this.edge));
    } else {
      const height = kind === "field" ? Math.max(high, floor) : floor;
      const flat = new Mesh(new ShapeGeometry(new Shape(polygon.map(([x, y]) => new Vector2(x, y)))), this.fill);
      flat.position.z = height;
      this.add(flat, loop(polygon, height, this.edge));
    }
  }

  set lit(on) {
    const opacities = on ? LIT : CLEAR;
    this.fill.opacity = opacities[this.kind] ?? 0.2;
  }
}

/** The person's way as a ribbon on the floor. */
export function ribbon(points, width, material) {
  const corners = [];
  for (let index = 1; index < points.length; index++) {
    const [[x, y], [u, v]] = [points[index - 1], points[index]];
    const length = Math.hypot(u - x, v - y);
    if (length > 1e-6) {
      const [nx, ny] = [((y - v) / length) * (width / 2), ((u - x) / length) * (width / 2)];
      const z = 0.012;
      corners.push(x + nx, y + ny, z, x - nx, y - ny, z, u - nx, v - ny, z, x + nx, y + ny, z, u - nx, v - ny, z, u + nx, v + ny, z);
    }
  }
  return new Mesh(new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners, 3)), material);
}
