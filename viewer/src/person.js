// The person in three dimensions: the model's capsules and arms, with hands, feet, nose and cap so that one sees a person.

import { Group, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from "three";
import { armAt, bodyAt, headingAt, headPart, limbOf, shanks, SIDES, touchedPart } from "./instant.js";
import { BALL, Capsule } from "./shapes.js";

/** Colours of the person; `touched` is told apart from all others. */
export const PERSON = { skin: "#e9bd97", shirt: "#8f8467", trousers: "#4b5058", shoes: "#3f352c", cap: "#8a5a2b", touched: "#c2185b" };

/** Half axes of hand and foot, m: along, thick, across. */
const HAND = [0.095, 0.018, 0.043];
const FOOT = [0.145, 0.05, 0.06];
const HAND_LENGTHS_M = [0.13, 0.22];
/** A thing that is held: where in the hand it begins, from the wrist, and its radius, m. */
const HELD = { from: 0.08, radius: 0.014 };
/** Time before the contact in which the arm that touches comes up, s. */
const RAISED_IN_S = 0.4;

const MATERIALS = Object.fromEntries(Object.entries(PERSON).map(([key, color]) => [key, new MeshLambertMaterial({ color })]));
const AROUND = new MeshBasicMaterial({ color: PERSON.touched, transparent: true, opacity: 0.1, depthWrite: false });
const DOME = new SphereGeometry(1, 28, 12, 0, 2 * Math.PI, 0, Math.PI / 2);
const ALONG = new Vector3(1, 0, 0);

const vector = (p) => new Vector3(...p);

function ellipsoid(axes, material) {
  const mesh = new Mesh(BALL, material);
  mesh.scale.set(...axes);
  mesh.castShadow = true;
  return mesh;
}

function materialOf(region) {
  if (/head|skull|face|neck/.test(region)) {
    return MATERIALS.skin;
  }
  return /thigh|shank|pelvis|leg/.test(region) ? MATERIALS.trousers : MATERIALS.shirt;
}

/** Nose and cap, made for a head of radius 1 that looks along x with y up. */
function face() {
  const dome = new Mesh(DOME, MATERIALS.cap);
  dome.scale.setScalar(1.07);
  dome.position.y = 0.16;
  const brim = ellipsoid([0.72, 0.09, 0.74], MATERIALS.cap);
  brim.position.set(0.86, 0.3, 0);
  const nose = ellipsoid([0.2, 0.24, 0.15], MATERIALS.skin);
  nose.position.set(1, -0.08, 0);
  const group = new Group();
  group.add(dome, brim, nose);
  return Object.assign(group, { hat: [dome, brim], nose });
}

/** The person; `name` gives an object the name that is shown when it is pointed at. */
export class Person extends Group {
  constructor(cell, name) {
    super();
    this.cell = cell;
    const { upper_arm_radius_m: upper, forearm_radius_m: forearm, hand_radius_m: around } = cell.arm;
    this.parts = cell.body.map((part) => name(new Capsule(part.radius_m, materialOf(part.region)), part.name));
    this.arms = SIDES.map((side) => [
      name(new Capsule(upper, MATERIALS.shirt), `${side} upper arm`),
      name(new Capsule(forearm, MATERIALS.skin), `${side} lower arm`),
      name(ellipsoid(HAND, MATERIALS.skin), `${side} hand`),
    ]);
    this.legs = shanks(cell);
    this.feet = this.legs.map(() => name(ellipsoid(FOOT, MATERIALS.shoes), "foot"));
    this.face = name(face(), "head");
    const holds = cell.arm.held_m > 0;
    this.around = name(new Mesh(BALL, AROUND), `the hand${holds ? ", or what it holds," : ""} may be anywhere in this sphere`);
    this.around.scale.setScalar(around);
    this.held = name(new Capsule(HELD.radius, MATERIALS.trousers), "what the hand holds");
    this.held.visible = false;
    this.add(...this.parts, ...this.arms.flat(), ...this.feet, this.face, this.around, this.held);
  }

  /** Takes the person beside the one who is hit, or hides if there is none. */
  loadOther(replay, hazard) {
    this.visible = Boolean(replay.beside);
    if (this.visible) {
      const own = { ...replay, body: replay.beside, arms: replay.beside_arms, arm: null };
      Object.assign(this, { replay: own, hazard, head: headPart(own, this.cell), touching: null });
      this.face.scale.setScalar(this.cell.body[this.head].radius_m);
    }
  }

  /** Takes the person of another replay, and colours what is touched. */
  load(replay, hazard) {
    Object.assign(this, { replay, hazard, head: headPart(replay, this.cell) });
    const side = replay.arm ? SIDES.indexOf(replay.arm.side) : -1;
    const limb = limbOf(hazard.body_region);
    this.touching = side >= 0 && limb !== undefined ? { side, limb } : null;
    this.held.visible = Boolean(hazard.arm?.held_m);
    const touched = replay.arm ? -1 : touchedPart(replay, this.cell, hazard);
    const colour = (on, usual) => (on ? MATERIALS.touched : usual);
    this.parts.forEach((part, index) => (part.material = colour(index === touched, materialOf(this.cell.body[index].region))));
    this.arms.forEach((arm, index) =>
      arm.forEach((part, at) => (part.material = colour(index === side && at === limb, at === 0 ? MATERIALS.shirt : MATERIALS.skin))),
    );
    const skull = touched === this.head && hazard.body_region === "skull_forehead";
    this.face.hat.forEach((part) => (part.material = colour(skull, MATERIALS.cap)));
    this.face.nose.material = colour(touched === this.head, MATERIALS.skin);
    this.face.scale.setScalar(this.cell.body[this.head].radius_m);
  }

  /** Moves everything to a frame. */
  place(frame) {
    const { replay, cell, touching } = this;
    this.parts.forEach((part, index) => {
      const { a, b } = bodyAt(replay, cell, frame, index);
      part.place(a, b);
    });
    const joints = SIDES.map((_, side) => armAt(replay, frame, side));
    this.arms.forEach(([upper, forearm, hand], side) => {
      const [shoulder, elbow, wrist] = joints[side];
      upper.place(shoulder, elbow);
      forearm.place(elbow, wrist);
      this.placeHand(hand, elbow, wrist, frame, touching?.limb === 2 && touching.side === side);
    });
    const front = vector(headingAt(replay, this.hazard, frame));
    this.feet.forEach((foot, index) => {
      const { a, b } = bodyAt(replay, cell, frame, this.legs[index]);
      const low = a[2] < b[2] ? a : b;
      foot.position.set(low[0], low[1], FOOT[1]).addScaledVector(front, 0.06);
      foot.quaternion.setFromUnitVectors(ALONG, front);
    });
    this.placeFace(joints, front, frame);
    this.around.visible = touching?.limb === 2 && frame >= replay.contact_frame;
    if (this.around.visible) {
      this.around.position.set(...joints[touching.side][2]);
    }
  }

  /** A hand goes on as the forearm does; the one that touches turns to the contact while the arm comes up. */
  placeHand(hand, elbow, wrist, frame, touches) {
    const { replay } = this;
    const from = vector(wrist);
    const direction = from.clone().sub(vector(elbow)).normalize();
    let length = 2 * HAND[0];
    if (touches) {
      const at = vector(armAt(replay, replay.contact_frame, this.touching.side)[2]);
      const to = vector(replay.contact_m).sub(at);
      const reach = to.length();
      const turned = Math.max(0, Math.min(1, 1 - ((replay.contact_frame - frame) * replay.step) / RAISED_IN_S));
      if (reach > 0.02) {
        direction.lerp(to.divideScalar(reach), turned).normalize();
        length += turned * (Math.max(HAND_LENGTHS_M[0], Math.min(HAND_LENGTHS_M[1], reach)) - length);
      }
    }
    if (touches && this.held.visible) {
      const far = vector(replay.contact_m).sub(vector(armAt(replay, replay.contact_frame, this.touching.side)[2])).length();
      const along = (by) => from.clone().addScaledVector(direction, by).toArray();
      this.held.place(along(HELD.from), along(far));
    }
    hand.scale.x = length / 2;
    hand.position.copy(from).addScaledVector(direction, length / 2);
    hand.quaternion.setFromUnitVectors(ALONG, direction);
  }

  /** The head looks to where the shoulders and its own bend turn it. */
  placeFace([[left], [right]], front, frame) {
    const { a, b } = bodyAt(this.replay, this.cell, frame, this.head);
    const centre = vector(a).add(vector(b)).multiplyScalar(0.5);
    const across = vector(left).sub(vector(right));
    const up = centre.clone().sub(vector(left).add(vector(right)).multiplyScalar(0.5));
    if (across.lengthSq() < 1e-4 || up.lengthSq() < 1e-4) {
      up.set(0, 0, 1);
      across.crossVectors(up, front);
    }
    const ahead = across.cross(up).normalize();
    up.normalize();
    this.face.position.copy(centre);
    this.face.quaternion.copy(new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(ahead, up, new Vector3().crossVectors(ahead, up))));
  }

  /** From the person's own eyes the head would hide everything. */
  set headless(on) {
    this.parts[this.head].visible = !on;
    this.face.visible = !on;
  }

  /** Middle of the head at a frame. */
  eye(frame) {
    return bodyAt(this.replay, this.cell, frame, this.head).a;
  }

  /** Points of the person at a frame that no name should hide. */
  spots(frame) {
    return this.parts.map((_, part) => bodyAt(this.replay, this.cell, frame, part).a);
  }

  /** What is drawn, for tests. */
  get drawn() {
    const [upper, forearm] = this.arms[0].map((part) => part.radius);
    return { upper_arm_radius_m: upper, forearm_radius_m: forearm, hand_sphere_m: this.around.visible ? this.around.scale.x : null, touched: this.touching ?? "body" };
  }
}
