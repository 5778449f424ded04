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
  back: "steps back",
  run: "runs straight ahead",
};

const POSTURES = {
  upright: "upright",
  "bend-forward": "bent forward",
  "bend-left": "bent to the left",
  "bend-right": "bent to the right",
  "bend-forward-left": "bent forward and to the left",
  "bend-forward-right": "bent forward and to the right",
  kneel: "kneeling",
  crouch: "crouching",
  crawl: "crawling",
};

/** A body region in words. */
export const region = (id) => REGIONS[id] ?? String(id).replaceAll("_", " ");

/** A ratio, as in "1.33x". */
export const ratio = (value) => `${value.toFixed(2)}x`;

/** A force in whole newtons. */
export const force = (value) => `${value.toFixed(0)} N`;

/** A pressure. */
const pressed = (value) => `${value.toFixed(0)} N/cm²`;

/** A length. */
const metres = (value) => `${value.toFixed(2)} m`;

/** A speed. */
export const speed = (value) => `${value.toFixed(2)} m/s`;

/** A time. */
export const time = (value) => `${value.toFixed(2)} s`;

/** When somebody begins who does not where the scan did. */
export const begun = ({ begins_s: at }) => `${time(at)} after the FMU's start`;

/** A point. */
export const point = (values) => `(${values.map((value) => value.toFixed(2)).join(", ")}) m`;

/** A whole number with its thousands set apart; takes decimal strings too, which may be longer than a number holds. */
export const grouped = (digits) => String(digits).replace(/\B(?=(\d{3})+(?!\d))/g, ",");

/** A count with its noun. */
export const count = (number, noun) => `${grouped(number)} ${noun}${Number(number) === 1 ? "" : "s"}`;

/**
 * A share as a percentage that nobody has to decode: "12.3 %", "1.0 %", "0.52 %", "0.004 %". `to` rounds: up for a bound
 * from above, down for one from below.
 */
export function share(value, to = Math.round) {
  const percent = 100 * value;
  if (percent === 0) {
    return "0 %";
  }
  if (percent < 1e-6) {
    return "less than 0.000001 %";
  }
  const digits = percent >= 0.995 ? 1 : Math.min(7, 1 - Math.floor(Math.log10(percent)));
  const part = 10 ** digits;
  const rounded = to(percent * part) / part;
  // What is not all must not read as all.
  const shown = rounded >= 100 && value < 1 ? 99.9 : rounded;
  return `${shown.toFixed(digits).replace(/(\.\d*?[1-9])0+$/, "$1")} %`;
}

const WORKS = { momentary: "presses", held: "holds", toggled: "switches" };

/** The controls of the cell, in the order in which actions number them. */
let controls = [];

/** Actions are told with the names of these controls from now on. */
export function nameControls(all) {
  controls = all;
}

/** What two people are called, the one after the other; none where there is one person. */
let people = [];

/** Actions are told with the names of these people from now on. */
export function namePeople(names) {
  people = names ?? [];
}

/** Who works a control, and how: "the person presses reset". */
export function worked({ name, by, kind, opens, by_either: either }) {
  const does = opens === undefined ? WORKS[kind] : opens ? "opens" : "closes";
  const person = either ? "one of the people" : "the person";
  return `${by === "anyone" ? "a colleague" : person} ${does} ${name}`;
}

/** What is worked in an action: "presses reset", "a colleague presses reset". */
function press(text) {
  const control = controls[Number(text) - 1];
  const who = control?.by === "anyone" ? "a colleague " : "";
  return control ? `${who}${control.door ? "opens or closes" : WORKS[control.kind]} ${control.name}` : `works control ${text}`;
}

/** An action in words: "walks straight ahead, bent forward, presses reset"; of two people what each does. */
export function action(name) {
  const [moves, ...presses] = name.split("+press");
  const does = moves.split("&").map((one, index) => {
    const [walk, posture] = one.split("/");
    const who = people[index] === undefined ? "" : `${people[index]} `;
    return posture === undefined ? one : `${who}${WALKS[walk] ?? walk}, ${POSTURES[posture] ?? posture}`;
  });
  return [does.join("; "), ...presses.map(press)].join(", ");
}

/** Whom a sensor reports: it does not tell who it is. */
export const somebody = () => (people.length > 0 ? "somebody" : "the person");

/** Who acts, for a heading. */
export const whose = () => (people.length > 0 ? "both people" : "the person");

/** The same with who does it. */
export const does = (name) => (people.length > 0 ? action(name) : `the person ${action(name)}`);

/** Actions in words, equal ones in a row as one: "3 x walks straight ahead, upright, 0.6 s"; `each` is how long one takes. */
export function sequence(actions, each) {
  const groups = [];
  for (const name of actions) {
    if (groups.at(-1)?.name === name) {
      groups.at(-1).times += 1;
    } else {
      groups.push({ name, times: 1 });
    }
  }
  return groups.map(({ name, times }) => `${times > 1 ? `${times} x ` : ""}${action(name)}, ${+(times * each).toFixed(2)} s`);
}

/** Whether a hazard or a cause is one of the transient force, on somebody who can give way. */
export const byForce = ({ class: kind }) => kind === "force" || kind === "head_contact";

/** What is hit where a hand holds it. */
export const HELD = "thing in the hand";

/** What the robot does to the part of the body: "clamps the hand against table". */
export function deed({ class: kind, judged, body_region: part, person, arm }) {
  const hit = `${arm?.held_m ? HELD : region(part)}${person === undefined ? "" : ` of ${person}`}`;
  switch (kind) {
    case "clamping":
      return `clamps the ${hit}${judged?.clamping ? ` against ${judged.clamping.against}` : ""}`;
    case "pressure":
      return `presses the ${hit}`;
    case "moving_contact":
      return `touches the ${hit} while it moves`;
    case "separation":
      return `is too near the ${hit}`;
    default:
      return `hits the ${hit}`;
  }
}

/** How bad a hazard or a cause is by another criterion, in two parts; `speed_m_s` is that of the point that touches. */
function otherSeverity({ class: kind, judged, ratio: times, force_n: newtons, limit_n: most }, speed_m_s) {
  const { clamping, pressure, separation, limit: by } = judged ?? {};
  if (kind === "separation" && separation) {
    const { distance_m: is, required_m: needed } = separation;
    return typeof needed === "number"
      ? [`${metres(needed - is)} too near`, `${metres(is)} away, ${metres(needed)} needed`]
      : ["too near", `${metres(is)} away from a robot that does not stop`];
  }
  if (kind === "moving_contact") {
    return ["no contact allowed", `touched at ${speed(speed_m_s)}`];
  }
  if (by === "pressure" && pressure) {
    return [`${ratio(times)} the limit`, `${pressed(pressure.n_cm2)}, limit ${pressed(pressure.limit_n_cm2)}`];
  }
  const [is, may] = clamping ? [clamping.force_n, clamping.limit_n] : [newtons, most];
  return [`${ratio(times)} the limit`, `${force(is)}, limit ${force(may)} for what cannot give way`];
}

/** Whether no moving robot may touch the region: the head, and the front of the neck. */
export const permitsNoContact = (region) => ["skull_forehead", "face", "neck_front"].includes(region);

/** The speed below which the force stays within the limit; no speed is safe for a head or a throat. */
export function safeBelow(hazard) {
  const { clamping, limit: by } = hazard.judged ?? {};
  if (hazard.class === "clamping" && by === "force" && clamping) {
    return speed((clamping.closing_m_s * clamping.limit_n) / clamping.force_n);
  }
  if (!byForce(hazard)) {
    return hazard.class === "moving_contact" ? "none" : "-";
  }
  return permitsNoContact(hazard.body_region) ? "none" : speed(hazard.safe_below_m_s);
}

/** What a contact may have at most, and has; a moving robot may not touch a head or a throat at all. */
export const limit = (hazard) => (hazard.class === "head_contact" ? "none allowed" : force(hazard.limit_n));

/** What is broken, in one cell of a table. */
export const measure = (hazard) => (byForce(hazard) ? `${force(hazard.force_n)} / ${limit(hazard)}` : otherSeverity(hazard, hazard.speed_m_s).join(": "));

/** Forces further apart than this are worth a second look. */
const APART = 2;

/** What is said where they are. */
export const APART_TEXT = `The two differ by more than a factor of ${APART}.`;

/** Both forces of a hazard: by the robot's own speed and by the speed of approach, and which of them decides, where none of them does by what ratio another criterion is broken. */
export function forces(hazard, { speed_criterion: criterion }) {
  const byApproach = criterion === "approach";
  const own = { name: "with the robot's own speed", force: hazard.force_n, ratio: hazard.force_n / hazard.limit_n, speed: hazard.speed_m_s, decides: !byApproach };
  const approach = {
    name: "with the speed of approach (the person's walking included)",
    force: hazard.directed_force_n,
    ratio: hazard.directed_ratio,
    speed: hazard.approach_m_s,
    decides: byApproach,
  };
  if (!byForce(hazard)) {
    return { own, approach, decides: { ratio: hazard.ratio }, apart: false };
  }
  const [less, more] = [own.ratio, approach.ratio].sort((a, b) => a - b);
  return { own, approach, decides: byApproach ? approach : own, apart: more > APART * less };
}

/** A ratio of a region; below 1 it would read as harmless where no contact is allowed. */
export const ratioOf = (region, times) => (times < 1 && permitsNoContact(region) ? `no contact allowed (${ratio(times)})` : ratio(times));

/** Which force decides, in words. */
export const criterion = ({ speed_criterion: name }) =>
  name === "approach" ? "the speed of approach (the person's walking included)" : "the robot's own speed";

/** How bad a cause or a hazard is, in two parts: as many times the limit, and the force beside it. `worst` is the worst hazard of the cause. */
export function severity(of, worst = of) {
  const { class: kind, ratio: times, force_n: newtons, limit_n: most } = of;
  if (!byForce(of)) {
    return otherSeverity(of, worst.speed_m_s);
  }
  const sizes = `${force(newtons)}, limit ${force(most)}`;
  return kind === "head_contact" ? ["no contact allowed", `${sizes} (${ratio(times)})`] : [`${ratio(times)} the limit`, sizes];
}

/** Whether a fresh instance gave the same contact. */
export function confirmed(value) {
  return value === null || value === undefined ? "not tried" : value ? "yes" : "NO";
}

/** Sensors at a contact. */
export function sensors(states) {
  const state = (s) => (s.person_detected ? `reports ${somebody()}${typeof s.since_s === "number" ? ` for ${time(s.since_s)}` : ""}` : `does not report ${somebody()}`);
  return states.map((s) => `${s.name} ${state(s)}`).join(", ") || "no sensor";
}

/** Sensors that report the person at a contact, and for how long they have. */
export function reporting(states) {
  const names = states.filter((s) => s.person_detected).map((s) => (typeof s.since_s === "number" ? `${s.name} ${time(s.since_s)}` : s.name));
  return names.join(", ") || "none";
}

/** How often a hazard was found, and how that is counted. */
export function found(hazard) {
  return hazard.sequences === null || hazard.sequences === undefined
    ? count(hazard.times_found, "time")
    : count(hazard.sequences, "sequence");
}
