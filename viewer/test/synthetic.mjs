// Invented reports for the tests: a robot that sweeps over a table, and a person who walks up to it and bends.

const STEP_S = 0.02;
const FRAMES = 81;
const LIMITS = { skull_forehead: 130, face: 65, chest: 280, hand: 280, lower_arm: 320, upper_arm: 300 };
const ARM = { upper_arm_radius_m: 0.055, forearm_radius_m: 0.045, hand_radius_m: 0.23 };
/** Of each kind of hazard a few regions, so that causes have several lines. */
const REGIONS = { body: ["skull_forehead", "face", "skull_forehead"], arm: ["hand", "lower_arm", "hand", "upper_arm"] };

const add = (...all) => [0, 1, 2].map((i) => all.reduce((sum, v) => sum + v[i], 0));
const scaled = (v, s) => v.map((value) => value * s);
const base64 = (numbers) => Buffer.from(new Float32Array(numbers.flat(Infinity)).buffer).toString("base64");
const rounded = (v) => v.map((value) => Number(value.toFixed(4)));

/** Pseudo-random numbers in 0..1, the same for the same seed. */
function random(seed) {
  let state = seed >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 2 ** 32;
  };
}

const BODY = [
  ["head", 0.11], ["neck", 0.06], ["upper_chest", 0.13], ["lower_chest", 0.14], ["abdomen", 0.13],
  ["pelvis", 0.14], ["left_thigh", 0.08], ["right_thigh", 0.08], ["left_shank", 0.055], ["right_shank", 0.055],
];

/** Capsules of a person who stands at `xy`, looks to `heading` and bends forward by `bend`. */
function body([x, y], heading, bend) {
  const forward = [Math.cos(heading), Math.sin(heading), 0];
  const left = [-Math.sin(heading), Math.cos(heading), 0];
  const hip = [x, y, 0.92];
  const trunk = (up, out = 0) => add(hip, scaled(forward, up * Math.sin(bend)), [0, 0, up * Math.cos(bend)], scaled(left, out));
  const leg = (out, z) => add([x, y, z], scaled(left, out));
  const parts = [
    [trunk(0.73), trunk(0.73)],
    [trunk(0.52), trunk(0.62)],
    [trunk(0.4, 0.08), trunk(0.4, -0.08)],
    [trunk(0.25, 0.08), trunk(0.25, -0.08)],
    [trunk(0.12), trunk(0.12)],
    [add([x, y, 0.95], scaled(left, 0.07)), add([x, y, 0.95], scaled(left, -0.07))],
    [leg(0.09, 0.85), leg(0.09, 0.49)],
    [leg(-0.09, 0.85), leg(-0.09, 0.49)],
    [leg(0.09, 0.49), leg(0.09, 0.055)],
    [leg(-0.09, 0.49), leg(-0.09, 0.055)],
  ];
  return { parts, shoulders: [trunk(0.48, 0.19), trunk(0.48, -0.19)], forward };
}

/** An arm that hangs from its shoulder, a little bent. */
function hanging(shoulder, forward) {
  const elbow = add(shoulder, [0, 0, -0.3], scaled(forward, -0.01));
  return [shoulder, elbow, add(elbow, [0, 0, -0.31], scaled(forward, 0.07))];
}

const between = (a, b, t) => a.map((value, i) => value + t * (b[i] - value));

/** Triangles of the gripper: its corners go round below and above. */
const GRIPPER = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], ...[0, 1, 2, 3].flatMap((i) => [[i, (i + 1) % 4, 4 + ((i + 1) % 4)], [i, 4 + ((i + 1) % 4), 4 + i]])];

const LINKS = (hitting) => [
  { name: "base", robot: "r1", shape: "hull", points_m: [[-0.15, -0.15, 0], [0.15, -0.15, 0], [0.15, 0.15, 0], [-0.15, 0.15, 0], [-0.1, -0.1, 0.2], [0.1, -0.1, 0.2], [0.1, 0.1, 0.2], [-0.1, 0.1, 0.2]] },
  { name: "shoulder", robot: "r1", shape: "capsule", radius_m: 0.09 },
  { name: "upper_arm", robot: "r1", shape: "capsule", radius_m: 0.075 },
  { name: "forearm", robot: "r1", shape: "capsule", radius_m: 0.06 },
  { name: hitting, robot: "r1", shape: "capsule", radius_m: 0.06 },
  { name: "gripper", robot: "r1", shape: "mesh", triangles: GRIPPER, points_m: [[-0.06, -0.1, -0.05], [0.06, -0.1, -0.05], [0.06, 0.1, -0.05], [-0.06, 0.1, -0.05], [-0.04, -0.08, 0.08], [0.04, -0.08, 0.08], [0.04, 0.08, 0.08], [-0.04, 0.08, 0.08]] },
];

const BASE = [0, 0.75, 0.9];
const SIDES = ["left", "right"];

/** Links of a robot whose tool is at `tip`. */
function robot(tip) {
  const shoulder = add(BASE, [0, 0, 0.3]);
  const half = scaled(add(shoulder, tip), 0.5);
  const elbow = add(half, [0, 0, 0.35]);
  const wrist = add(tip, [0, 0, 0.16]);
  const turn = Math.atan2(tip[1] - BASE[1], tip[0] - BASE[0]) / 2;
  return [
    [BASE, 0, 0, 0, 1],
    [add(BASE, [0, 0, 0.15]), shoulder, 0],
    [shoulder, elbow, 0],
    [elbow, wrist, 0],
    [wrist, tip, 0],
    [add(tip, [0, 0, -0.08]), 0, 0, Math.sin(turn), Math.cos(turn)],
  ];
}

function sensors(xy) {
  return { mat: xy[1] > -1.1 && Math.abs(xy[0]) < 0.8, field: xy[1] > -0.9, curtain: xy[1] > -0.55 };
}

/** A drawing as plain as it gets; the real ones come from the Rust side. */
function topView(id, xy, contact) {
  const at = ([x, y]) => `cx="${(200 + 100 * x).toFixed(1)}" cy="${(200 - 100 * y).toFixed(1)}"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400" viewBox="0 0 400 400"><rect width="400" height="400" fill="#fff"/><text x="10" y="20">${id}</text><rect x="120" y="105" width="160" height="95" fill="#a9b4c2"/><circle ${at(xy)} r="22" fill="#3182ce"/><circle ${at(contact)} r="6" fill="#c00"/></svg>`;
}

const ACTIONS = ["forward/upright", "left45/upright", "right45/bend-left", "forward/upright", "stop/upright", "right45/bend-forward", "left45/bend-forward", "forward/bend-forward-right"];

/** One hazard and its replay. */
function episode(index, next, { arm, hitting }) {
  const id = `H-${(0xa00001 + index * 40503).toString(16).slice(0, 6)}`;
  const withArm = arm === "all" || (arm === "some" && index % 3 === 1);
  const contactFrame = 60 + Math.floor(20 * next());
  const goal = [1.1 * (next() - 0.5), -0.42 - 0.1 * next()];
  const from = [1.6, -2.2];
  const place = (frame) => {
    const t = Math.min(1, frame / 50);
    return [from[0] + t * (goal[0] - from[0]) + 0.15 * Math.sin(Math.PI * t), from[1] + t * (goal[1] - from[1])];
  };
  const heading = (frame) => (frame < 50 ? Math.atan2(goal[1] - from[1], goal[0] - from[0]) : Math.PI / 2);
  const bend = (frame) => (withArm ? 0.2 : 0.75) * Math.max(0, Math.min(1, (frame - 50) / 10));
  const poses = Array.from({ length: FRAMES }, (_, frame) => body(place(frame), heading(frame), bend(frame)));

  const touched = poses[contactFrame];
  const head = touched.parts[0][0];
  const [shoulder] = touched.shoulders;
  const armPose = withArm ? { side: "left", points_m: [shoulder, add(shoulder, [0.1, 0.2, -0.2]), add(shoulder, [0.04, 0.46, -0.06])].map(rounded) } : null;
  const kind = withArm ? "arm" : "body";
  const region = REGIONS[kind][index % REGIONS[kind].length];
  const [, elbow, wrist] = armPose?.points_m ?? [];
  const bodyPoint = {
    hand: () => add(wrist, [0.03, 0.16, 0.02]),
    lower_arm: () => add(between(elbow, wrist, 0.6), [0, 0, ARM.forearm_radius_m]),
    upper_arm: () => add(between(shoulder, elbow, 0.7), [0, 0, ARM.upper_arm_radius_m]),
    face: () => add(head, [0, 0.1, -0.03]),
    skull_forehead: () => add(head, [0, 0.09, 0.06]),
  }[region]();
  const contact = add(bodyPoint, [0, 0.01, 0]);
  const tip = (frame) => add(contact, [0.9 * Math.sin((frame - contactFrame) * 0.03), 0.07 + 0.15 * (1 - Math.cos((frame - contactFrame) * 0.05)), 0]);
  /** Both arms hang; the one that touches comes up in the last 0.4 s. */
  const arms = (frame) =>
    SIDES.map((side, at) => {
      const { shoulders, forward } = poses[frame];
      const down = hanging(shoulders[at], forward);
      const raised = armPose?.side === side ? Math.max(0, Math.min(1, 1 - ((contactFrame - frame) * STEP_S) / 0.4)) : 0;
      return down.map((joint, i) => (raised > 0 ? between(joint, armPose.points_m[i], raised) : joint));
    });

  const limit = LIMITS[region];
  const slow = index % 7 === 6 && !withArm;
  const stops = index % 4 === 0;
  const ratio = slow ? 0.55 : 1.05 + 1.2 * next();
  const speed = 0.2 + next();
  const timeS = contactFrame * STEP_S;
  const now = place(contactFrame);
  const reports = Object.entries(sensors(now)).map(([name, on]) => ({ name, person_detected: on, since_s: on && name !== "curtain" ? 0.2 + 0.02 * index : null }));
  const directed = (index % 5 === 2 ? 0.3 : 0.8) * ratio;
  const hazard = {
    id, confirmed: index % 11 === 10 ? null : true, class: slow ? "head_contact" : "force", body_region: region, robot_link: index % 2 ? "gripper" : hitting,
    force_n: ratio * limit, limit_n: limit, ratio, directed_force_n: directed * limit, directed_ratio: directed, speed_m_s: speed, approach_m_s: 0.9 * speed,
    safe_below_m_s: speed / ratio, effective_mass_kg: 11.85, time_s: timeS, contact_point_m: rounded(contact), body_point_m: rounded(bodyPoint),
    distance_m: 0, person_xy_m: now, person_heading_deg: 90, bend_fraction: withArm ? 1 : 0.9375,
    arm: armPose && { side: "left", shoulder_m: armPose.points_m[0], elbow_m: armPose.points_m[1], wrist_m: armPose.points_m[2] },
    sensors: reports, phase: 1, through: withArm ? [{ sensor: "curtain", since_s: 0.12, until_s: 0 }] : [], actions: ACTIONS.slice(0, Math.ceil(timeS / 0.2)),
    first_iteration: index + 1, times_found: 1 + Math.floor(40 * next()), earliest_time_s: timeS - 0.1, sequences: null,
    shortest: { actions: ACTIONS.slice(0, 7).map((name) => name.replace("bend-left", "upright")), time_s: timeS - 0.1, force_n: ratio * limit, ratio, confirmed: true },
  };
  const frames = [...poses.keys()];
  const distance = (frame) => Math.hypot(...[0, 1, 2].map((i) => tip(frame)[i] - (withArm ? poses[frame].parts[2][0] : poses[frame].parts[0][0])[i])) - 0.16;
  const replay = {
    id, frames: FRAMES, contact_frame: contactFrame,
    links: base64(frames.map((frame) => robot(tip(frame)))),
    body: base64(poses.map(({ parts }) => parts)),
    arms: base64(frames.map(arms)),
    arm: armPose, contact_m: rounded(contact),
    time_s: base64(frames.map((frame) => frame * STEP_S)),
    distance_m: base64(frames.map((frame) => (frame >= contactFrame ? 0 : Math.max(0, distance(frame))))),
    speed_m_s: base64(frames.map((frame) => (stops && frame > contactFrame + 3 ? 0 : speed * (1 - 0.01 * Math.abs(frame - contactFrame))))),
    force_ratio: base64(frames.map((frame) => (Math.abs(frame - contactFrame) > 25 ? NaN : ratio * (1 - 0.015 * Math.abs(frame - contactFrame))))),
    sensors: reports.map(({ name }) => ({ name, detected: frames.map((frame) => (sensors(place(frame))[name] ? "1" : "0")).join("") })),
    actions: ACTIONS.map((name, action) => ({ name, frame: 10 * action })),
    top_view: topView(id, now, contact),
  };
  return { hazard, replay };
}

const exact = { result: "exact" };

/** Causes: what hits the body, and what hits an arm; of arms hit by the gripper and by another link one each. */
function causes(hazards, exhaustive) {
  const groups = new Map();
  for (const hazard of hazards) {
    const part = hazard.arm ? "arm" : "body";
    const key = part === "arm" ? `arm ${hazard.robot_link}` : part;
    groups.set(key, [...(groups.get(key) ?? []), hazard]);
  }
  return [...groups.values()].map((group, index) => {
    const [worst] = group;
    const part = worst.arm ? "arm" : "body";
    const lines = new Map();
    for (const { body_region, robot_link, ratio, id } of group) {
      const key = `${body_region} ${robot_link}`;
      const line = lines.get(key) ?? { body_region, robot_link, ratio, hazards: [] };
      line.hazards.push(id);
      lines.set(key, line);
    }
    const share = [0.00997, 0.0000431, 0.0012][index % 3];
    return {
      id: `C-${(0xb00001 + index * 70001).toString(16).slice(0, 6)}`,
      sentence:
        part === "body"
          ? `field has reported the person for 0.24 s; the ${worst.robot_link} goes on at ${worst.speed_m_s.toFixed(2)} m/s and hits the head.`
          : `No sensor has reported the person: past the curtain an arm reaches the ${worst.robot_link}, which moves at ${worst.speed_m_s.toFixed(2)} m/s.`,
      robot: "r1", part, worst: worst.id, ratio: worst.ratio, force_n: worst.force_n, limit_n: worst.limit_n, class: worst.class,
      earliest_time_s: Math.min(...group.map((z) => z.earliest_time_s)),
      sequences: exhaustive ? String(Math.round(share * 2821109907456)) : null, share: exhaustive ? share : null,
      confirmed: group.filter((z) => z.confirmed).length, hazards: group.map((z) => z.id), lines: [...lines.values()],
      advice: index % 3 === 2 ? null : {
        changes: part === "body" ? [
          { change: "zone of field 0.45 m larger (sensor.field.zone)", checked: "all 2,821,109,907,456 sequences of 8 actions; 24 known sequences and 20 new ones", complete: true, removes_all: index === 0 && groups.size === 1, less: "One step less: 1.02x face <- gripper after 1.40 s." },
          { change: "speed of r1 0.05 m/s while field reports the person (robot.r1.slow_speed)", checked: "24 known sequences and 20 new ones", complete: false, removes_all: false, less: "" },
        ] : [],
        note: "Tried 14 changes; each was held against the known sequences and some new ones. No proof: a changed cell must be scanned again.",
      },
    };
  });
}

function scan(hazards, { exhaustive, faults }) {
  const residual = {
    holds_for: "uniformly random sequences of these actions, horizon and start in this model; not how likely a person is hurt",
    random_sequences: 400, hazardous: 3, not_evaluated: 0, hazardous_share_interval: [0.0015, 0.0218], hazardous_share_below: 0.0193,
    unlisted: hazards.length ? { checked: 300, met_others: 0, probability_below: 0.00994, good_turing_estimate: 0.002 } : null,
  };
  const certificate = {
    complete: true, reasons: [], sequences: "2821109907456", covered: "2821109907456", hazardous: hazards.length ? "41953532688" : "0",
    harmless: hazards.length ? "2680999615728" : "2722953148416", excluded: "98156759040", not_evaluated: "0", hazardous_share: hazards.length ? 0.014871 : 0,
    states: 13750, levels: [[1, 0], [6, 0]], complete_for_actions: 8, fmu_transitions: 8, questions: 2526076, merged_by: "serialised states, byte for byte",
    merged: 12, merges_tried_out: 12, run_again: { transitions: 90, compared: 30, merges: 12, merges_compared: 4 }, actions: 36, horizon: 8, random_search: { iterations: 320, mean_iterations: 66.7, sigma: 64, miss_probability: 0.0083 },
  };
  return {
    schema_version: 3, tool: "fmi-hazard 0.1.0", verdict: hazards.length ? "hazards_found" : exhaustive ? "none_found" : "inconclusive",
    headline: {
      says: hazards.length ? "2 causes of 5 possible hazards, all confirmed by a fresh replay." : exhaustive ? "No sequence of actions is hazardous, in this model." : "Nothing was found; not shown because 320 sequences were tried.",
      covers: exhaustive ? "From the start in the cell file, for 1.6 s. Complete: all sequences are accounted for." : "From the start in the cell file, for 1.6 s. Not complete.",
    },
    obligations: [
      { need: "searched", says: "Everything was looked at", ...(exhaustive ? { standing: "shown", figure: "all sequences of 8 actions" } : { standing: "open", why: "320 sequences were tried, which shows nothing of the others" }) },
      { need: "heeds", says: "Which sensors a robot heeds", about: "R2", standing: "assumed", by: "A. B.", because: "wired so", tried: "392 runs" },
      { need: "presses", says: "Controls are worked as often as people like", standing: "open", why: "controls are worked once at most", accept: "[[accept]]\nwhat = \"presses\"\nat_most = 1" },
    ],
    subject: {
      cell: "invented-cell", cell_found: "cells/invented/cell.toml", cell_sha256: "5b7abcfb551913fec788e2d71a3460021982a57de0505ad8a1c8dab2a7c04800", path: "cells/invented/cell.toml",
      fmus: [{ unit: "", sha256: "b9897c6cc788e402dd5e2a71e3065e2c4113bb2d497b08557f4decde4045b00b", fmi_version: "2.0", model_name: "invented", generation_tool: "by hand" }], couplings: [],
    },
    settings: {
      strategy: exhaustive ? "exhaustive" : "hybrid", seed: 1, iterations: 320, stop_at_first: false, posture_sweep: true, actions_per_sequence: 8, action_s: 0.2,
      contact_check_interval_s: STEP_S, reach_tolerance_m: 0.02, speed_criterion: "absolute",
    },
    hazards,
    causes: causes(hazards, exhaustive),
    certificate: exhaustive ? certificate : null,
    residual: exhaustive ? null : residual,
    coverage: {
      episodes: 320, episodes_not_evaluated: faults, actions: 2470, contact_checks: 8787, arm_checks: 36, arm_checks_incomplete: 1, arm_runs_not_evaluated: 2, arm_boxes: 5000, closest_approach_m: -0.12,
      checks_with_robot_in_arm_reach: 1423, contacts_within_limits: 3, highest_ratio_within_limits: 0.24, robot_top_speed_m_s: 1.3, sensor_actions: [78, 64, 12], walks_blocked: 1,
    },
    spent: { iterations: 320, actions: 2470, fmu_steps: 810, fmu_states: 82, contact_checks: 8787, arm_checks: 36 },
    faults: Array.from({ length: faults }, () => ({ message: "the FMU returned fmi2Error from fmi2DoStep at 0.84 s:\n  solver: no convergence", actions: ACTIONS.slice(0, 5) })),
    self_test: {
      steps: 80, step_s: STEP_S, inputs: 2, outputs: 80, deterministic: exact, second_instance: exact, restore: exact, fork: exact, fresh_process: exact,
      reset: { result: "differs", largest: 0.00031 }, serialize: { result: "not_offered" }, bytes_per_state: 286, output_range: 3.14,
    },
    standard_edition: "ISO/TS 15066:2016 Annex A (contents now in ISO 10218-2:2025)",
    tables: [
      { id: "iso_ts_15066_force_limits", title: "ISO/TS 15066:2016, Table A.2: quasi-static force limits, and the transient factor 2 (none for the head)", source: "public secondary sources that quote Table A.2", confidence: "two independent public sources agree on every force except lower legs", verified: false },
      { id: "ansur_ii", title: "ANSUR II 2012: body measures of men and women", source: "percentiles computed from the public per-subject data", confidence: "two public copies of the data agree", verified: true },
    ],
    warnings: faults > 0 ? ["2 sequences could not be evaluated, as the FMU failed"] : [],
  };
}

/** What the page says: as short as it gets, the real sentences come from the Rust side. */
function words({ hazards, causes, coverage, certificate, residual, faults, settings, self_test: test }, sensors) {
  const pairs = (object) => Object.entries(object).map(([key, value]) => [key.replaceAll("_", " "), String(value?.result ?? value)]);
  const by = (all, of) => Object.fromEntries(all.map((one) => [one.id, of(one)]));
  const times = (value) => `${value.toFixed(2)}x`;
  const newtons = (value) => `${value.toFixed(0)} N`;
  const names = (all) => Object.fromEntries(all.map((name) => [name, name.replaceAll("_", " ")]));
  const size = ({ body_region: region, ratio }) => (ratio < 1 ? `${region} untouchable (${times(ratio)})` : `${region} ${times(ratio)}`);
  const regions = ({ lines }) => [...new Map([...lines].reverse().map((line) => [line.body_region, size(line)]))].reverse();
  const lines = (z) => [`with the robot's own speed: ${newtons(z.force_n)}`, `with the speed of approach: ${newtons(z.directed_force_n)}`];
  const apart = (z) => Math.max(z.ratio, z.directed_ratio) > 2 * Math.min(z.ratio, z.directed_ratio);
  const hazard = (z) => ({
    deed: `${z.robot_link} hits ${z.body_region}`,
    way: `${times(z.ratio)} after ${z.time_s.toFixed(2)} s`,
    row: [times(z.ratio), newtons(z.force_n), newtons(z.directed_force_n), newtons(z.limit_n), "", String(z.speed_m_s), String(z.safe_below_m_s), String(z.time_s), String(z.times_found), "mat", z.confirmed === null ? "not tried" : "yes"],
    what: `${z.robot_link} hits ${z.body_region}.`,
    person: "looks on",
    forces: [lines(z), 0],
    ...(apart(z) ? { apart: "They differ." } : {}),
    computed: "F = v",
    ...(z.through.length > 0 ? { through: z.through.map(({ sensor }) => `Past ${sensor}.`) } : {}),
    sensors: z.sensors.map(({ name }) => name).join(", "),
    found: "found",
    shortest: "shorter",
    event: "contact",
    rests: `${z.robot_link} rests`,
  });
  const cause = (one) => ({
    severity: one.class === "head_contact" ? ["a moving robot may not touch it", newtons(one.force_n)] : [`${times(one.ratio)} too much`, newtons(one.force_n)],
    ...(typeof one.share === "number" ? { share: `${(100 * one.share).toFixed(4)} % of all sequences` } : {}),
    earliest: `from ${one.earliest_time_s.toFixed(2)} s on`,
    ways: `${one.hazards.length} ways`,
    lines: one.lines.map((line) => [line.body_region, times(line.ratio)]),
    regions: regions(one),
    changes: (one.advice?.changes ?? []).map(({ checked }) => ["It helps.", `Checked: ${checked}.`]),
    ...(one.advice?.changes.length > 0 ? {} : { no_change: "none" }),
  });
  const part = (id, title, says, rows) => ({ id, title, ...(says ? { says } : {}), ...(rows ? { rows: Object.entries(rows) } : {}) });
  return {
    hazard_is: "A hazard is what was found.",
    nothing_found: "None was found.",
    people: { who: "the person", heading: "the person", reports: "reports the person", report: "report the person", unseen: "no sensor reports the person", begins: "reports" },
    actions: names([...ACTIONS, ...hazards.flatMap((z) => z.shortest.actions)]),
    regions: names(["skull_forehead", "face", "neck", "neck_front", "back_shoulders", "chest", "abdomen", "pelvis", "upper_arm", "lower_arm", "hand", "thigh", "lower_leg"]),
    hazards: by(hazards, hazard),
    causes: by(causes, cause),
    not_allowed: "untouchable",
    table_notes: ["Forces.", "Limits."],
    arm: "An arm.",
    confirmed: "again",
    searched: [
      part("certificate", certificate ? "Complete" : "Not complete", certificate ? "" : "Not all.", certificate ? { sequences: certificate.sequences, "run again": "30 FMU transitions run again from the start" } : null),
      ...(residual ? [part("residual", "Residual", "", { share: "below 2 %" })] : []),
      part("seen", "Coverage", "", { sensors: sensors.map((name, index) => `${name} in ${coverage.sensor_actions[index]} actions`).join(", ") }),
      part("faults", "Faults", `${faults.length} faults.`),
    ],
    to_accept: "To accept:",
    settings: pairs(settings),
    self_test: pairs(test),
    limits: "Tables.",
    commands: { explain: ["Try:", "fmi-hazard explain . "], replay: ["Here:", "fmi-hazard replay scan.json "], report: ["To get it:", "fmi-hazard report . --hazard "] },
  };
}

const QUARTER = Math.SQRT1_2;
const SENSORS = ["mat", "field", "curtain"];

/** The floor in front of the table: who stands there is hit twice, later the farther off they are; beside it only who walks in. */
function whole(hazards) {
  const squares = [];
  for (let i = -8; i < 8; i++) {
    for (let j = -9; j < -2; j++) {
      const far = Math.hypot(i + 0.5, j + 2) / 10;
      const first = Math.round(4 + 10 * far);
      const ratio = 2.3 - 1.6 * far;
      squares.push({ xy_m: [(i + 0.5) / 10, (j + 0.5) / 10], ratio, unseen: i < 5, earliest_s: first / 10 + 0.04, spans: [[first, ratio], [first + 3, 0.9 * ratio]] });
    }
  }
  return {
    said: "On 0.9 m² of the floor somebody whom no sensor sees can be hit harder than allowed within 2.0 s of the start.",
    until_s: 2, cell_m: 0.1, span_s: 0.1, followed: true,
    floor: squares,
    open_m: [[-0.85, -0.45], [-0.85, -0.55], [0.85, -0.45]],
    not_looked_at_m: [],
    looked_at: true,
    ground: { unseen_m: [[-3, -3, 3, -0.15]], watched_m: [[-0.6, 1, 0.6, 1.6]], swept_m: [[-0.7, -0.4, 0.7, 0.9]] },
    places: hazards.map(({ id, body_region, robot_link, ratio, time_s, person_xy_m }, index) => ({
      id, body_region, robot_link, ratio, time_s, confirmed: index < 7, xy_m: person_xy_m, posture: "bent forward", walks_in: index % 2 === 1, start_m: index % 2 === 1 ? [1.4, -1.2] : person_xy_m,
    })),
  };
}

/** Data of a report with so many hazards, of which the first `replays` can be replayed. */
export function report({ hazards = 8, replays = 50, arm = "some", hitting = "tool", exhaustive = false, faults = 0, pedestal = false, looks = [], floor = false, assessments = {}, name = "invented-cell" } = {}) {
  const next = random(7 + hazards);
  const episodes = Array.from({ length: hazards }, (_, index) => episode(index, next, { arm, hitting }));
  episodes.sort((a, b) => b.hazard.ratio - a.hazard.ratio);
  const scanned = scan(episodes.map(({ hazard }) => hazard), { exhaustive, faults });
  return {
    format: 3,
    scan: scanned,
    words: words(scanned, SENSORS),
    ...(floor ? { whole: whole(episodes.map(({ hazard }) => hazard)) } : {}),
    reproduce: "fmi-hazard scan cell.toml --strategy hybrid --seed 1 --iterations 320",
    assumptions: [
      "The person walks at 1.6 m/s and does not run, jump, fall or climb; arms are posed at once, not swung.",
      "The force is that of a free impact with the absolute speed of the robot point; pressures and clamping are not looked at.",
      "The robot is the shapes and the mass that the cell file gives it.",
    ],
    assessments,
    cell: {
      name,
      step_s: STEP_S,
      obstacles: [
        { name: "table", centre_m: [0, 0.475, 0.45], size_m: [1.6, 0.95, 0.9], quaternion: [0, 0, 0, 1] },
        { name: "fence left", centre_m: [-1.9, 0, 1], size_m: [1.6, 0.02, 2], quaternion: [0, 0, 0, 1] },
        { name: "fence right", centre_m: [1.9, 0, 1], size_m: [2, 0.02, 1.6], quaternion: [0, QUARTER, 0, QUARTER] },
      ],
      sensors: SENSORS,
      zones: [
        { name: "mat", kind: "mat", title: "mat", polygon_m: [[-0.8, -1.1], [0.8, -1.1], [0.8, -0.05], [-0.8, -0.05]], z_m: [0, 0] },
        { name: "field", kind: "field", title: "field", polygon_m: [[-1.4, -0.9], [1.4, -0.9], [1.1, 1.6], [-1.1, 1.6]], z_m: [0.2, 0.2] },
        { name: "curtain", kind: "curtain", title: "curtain", polygon_m: [[-1.1, -0.55], [1.1, -0.55]], z_m: [0.3, 1.8] },
      ],
      links: LINKS(hitting),
      looks,
      arm: ARM,
      robots: [{ name: "r1", base_m: pedestal ? [0.4, 1.3, 0.9] : BASE, upright: true }],
      body: BODY.map(([region, radius_m]) => ({ region, name: region.replaceAll("_", " "), radius_m })),
      start: { xy_m: [1.6, -2.2], heading_deg: 135 },
    },
    replays: episodes.slice(0, replays).map(({ replay }) => replay),
  };
}
