// Numbers and names as the report words them.

const REGIONS = {
  skull_forehead: "skull",
  back_shoulders: "back or shoulders",
  neck_front: "front of the neck",
};

const WALKS = {
  stop: "stands still",
  forward: "walks straight ahead",
  left45: "turns left by 45° and walks",
  left90: "turns left by 90° and walks",
  right45: "turns right by 45° and walks",
  right90: "turns right by 90° and walks",
};

const POSTURES = {
  upright: "upright",
  "bend-forward": "bent forward",
  "bend-left": "bent to the left",
  "bend-right": "bent to the right",
  "bend-forward-left": "bent forward and to the left",
  "bend-forward-right": "bent forward and to the right",
};

/** A body region in words. */
export const region = (id) => REGIONS[id] ?? String(id).replaceAll("_", " ");

/** A ratio, as in "1.33x". */
export const ratio = (value) => `${value.toFixed(2)}x`;

/** A force in whole newtons. */
export const force = (value) => `${value.toFixed(0)} N`;

/** A speed. */
export const speed = (value) => `${value.toFixed(2)} m/s`;

/** A time. */
export const time = (value) => `${value.toFixed(2)} s`;

/** A point. */
export const point = (values) => `(${values.map((value) => value.toFixed(2)).join(", ")}) m`;

/** A whole number with its thousands set apart; takes decimal strings too, which may be longer than a number holds. */
export const grouped = (digits) => String(digits).replace(/\B(?=(\d{3})+(?!\d))/g, ",");

/** A count with its noun. */
export const count = (number, noun) => `${grouped(number)} ${noun}${Number(number) === 1 ? "" : "s"}`;

/** A small share, with its percentage. */
export const share = (value) => (value === 0 ? "0" : `${value.toExponential(2)} (${(100 * value).toPrecision(2)} %)`);

/** An action in words: "walks straight ahead, bent forward". */
export function action(name) {
  const [walk, posture] = name.split("/");
  return posture === undefined ? name : `${WALKS[walk] ?? walk}, ${POSTURES[posture] ?? posture}`;
}

/** Whether no moving robot may touch the region: the head, and the front of the neck. */
export const permitsNoContact = (region) => ["skull_forehead", "face", "neck_front"].includes(region);

/** The speed below which the force stays within the limit; no speed is safe for a head or a throat. */
export function safeBelow(hazard) {
  return permitsNoContact(hazard.body_region) ? "none" : speed(hazard.safe_below_m_s);
}

/** Force and limit of a hazard; a moving robot may not touch a head or a throat at all, whatever the force. */
export function forceOfLimit(hazard) {
  return `${force(hazard.force_n)} / ${hazard.class === "head_contact" ? "none allowed" : force(hazard.limit_n)}`;
}

/** Whether a fresh instance gave the same contact. */
export function confirmed(value) {
  return value === null || value === undefined ? "not tried" : value ? "yes" : "NO";
}

/** Sensors at a contact. */
export function sensors(states) {
  return states.map((s) => `${s.name}: ${s.person_detected ? "person" : "clear"}`).join(", ") || "no sensor";
}

/** How often a hazard was found, and how that is counted. */
export function found(hazard) {
  return hazard.sequences === null || hazard.sequences === undefined
    ? count(hazard.times_found, "time")
    : count(hazard.sequences, "sequence");
}
