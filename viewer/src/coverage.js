// What the search covered and what that is worth: certificate, residual figures, coverage, faults, notes.

import { definitions, h, section } from "./dom.js";
import { restsOn } from "./rests_on.js";
import { fromAnywhere, lookedAt } from "./verdict.js";
import { count, grouped, ratio, share, speed } from "./words.js";

const ms = (seconds) => `${(1000 * seconds).toFixed(0)} ms`;

/** What of the FMU was run again from the start: all of it, or which part. */
function again({ transitions, compared, merges, merges_compared: gone }) {
  const part = (done, of) => (done === of ? `all ${grouped(of)}` : `${grouped(done)} of ${grouped(of)}`);
  const merged = merges > 0 ? `, and ${part(gone, merges)} merges gone on with` : "";
  const sample = compared === transitions && gone === merges ? "" : "; a sample, chosen by a key";
  return compared > 0 ? `${part(compared, transitions)} FMU transitions, by fresh instances from the start${merged}${sample}` : "";
}

function certificate(scan) {
  const { certificate: c, settings } = scan;
  if (fromAnywhere(scan)) {
    return [h("h3", {}, "From anywhere"), h("p", { "data-test": "anywhere" }, `Looked at: ${lookedAt(scan)}. What is not known is told under what this result rests on.`)];
  }
  if (!c) {
    return [
      h("h3", {}, "Not complete"),
      h(
        "p",
        { "data-test": "incomplete" },
        "There is no certificate of completeness: not every sequence of actions was looked at, so there may be hazards that are not listed. ",
        "A complete search of the same cell: ",
        h("code", {}, "--strategy exhaustive"),
        ".",
      ),
    ];
  }
  const random = c.random_search;
  return [
    h("h3", {}, c.complete ? "Certificate: complete" : "Not complete"),
    c.complete || c.complete_for_actions >= c.horizon
      ? null
      : h("p", { "data-test": "incomplete" }, `Only the beginnings of ${c.complete_for_actions} of ${c.horizon} actions were all looked at; hazards that need more actions may be missing.`),
    definitions([
      ["within", `${c.actions} actions, ${c.horizon} in a row, ${ms(settings.action_s)} each; contact checked every ${ms(settings.contact_check_interval_s)}; reach tolerance ${(1000 * settings.reach_tolerance_m).toFixed(0)} mm`],
      ["sequences", `${grouped(c.covered)} of ${grouped(c.sequences)} accounted for`],
      ["hazardous", `${grouped(c.hazardous)}: ${share(c.hazardous_share)}`],
      ["harmless", grouped(c.harmless)],
      ["too far away", `${grouped(c.excluded)} cannot meet the robot any more in the time that is left`],
      ["not evaluated", c.not_evaluated === "0" ? "" : `${grouped(c.not_evaluated)}: the FMU could not finish them`],
      ["distinct states", `${grouped(c.states)}; equal FMU states told by ${c.merged_by}${c.merged > 0 ? ` (${grouped(c.merged)} histories merged, ${grouped(c.merges_tried_out)} of the merges tried out)` : ""}`],
      ["run again", again(c.run_again)],
      ["random search", random && c.hazardous_share > 0 ? `one in ${grouped((1 / c.hazardous_share).toFixed(0))} random sequences is hazardous, so it needs that many iterations on average; within ${random.iterations} it finds nothing in ${share(random.miss_probability)} of runs` : ""],
    ]),
  ];
}

function residual(r) {
  if (!r) {
    return [];
  }
  const bounds =
    r.hazardous === 0
      ? `below ${share(r.hazardous_share_below, Math.ceil)}, one-sided`
      : `${share(r.hazardous_share_interval[0], Math.floor)} to ${share(r.hazardous_share_interval[1], Math.ceil)}, Clopper-Pearson`;
  const u = r.unlisted;
  return [
    h("h3", {}, "Residual: what is left, by random sequences alone"),
    definitions([
      ["random sequences", `${grouped(r.random_sequences)}, of these ${grouped(r.hazardous)} hazardous${r.not_evaluated > 0 ? `, ${grouped(r.not_evaluated)} not evaluated` : ""}`],
      ["hazardous share", `of all sequences: ${bounds}`],
      ["not listed here", u ? `one more random sequence ends in a hazard not listed with probability below ${share(u.probability_below, Math.ceil)} (${grouped(u.met_others)} of ${grouped(u.checked)} later ones did; Good-Turing estimate ${share(u.good_turing_estimate)})` : ""],
      ["confidence", `95 % each; for ${r.holds_for}`],
    ]),
  ];
}

const approach = (closest) => (closest < 1e6 ? `${closest.toFixed(2)} m${closest < 0 ? " (shapes overlap)" : ""}` : "never near");

/** What was seen of each of several robots; of a single one the rows of all robots say it. */
function ofRobots(robots = []) {
  if (robots.length < 2) {
    return [];
  }
  return robots.map(({ name, moved, top_speed_m_s: top, instants_in_reach: near, closest_approach_m: closest }) => {
    const moves = moved || top >= 1e-3 ? `up to ${speed(top)}` : "never moved";
    // Too slow to harm whenever somebody was near: its distance was not asked for.
    const distance = near > 0 && closest >= 1e6 ? "" : `; closest approach of the body ${approach(closest)}`;
    return [name, `${moves}${distance}; near enough to touch at ${count(near, "instant")}`];
  });
}

function seen(scan, cell) {
  const { coverage: c, spent, certificate: complete } = scan;
  if (fromAnywhere(scan)) {
    const cost = `${count(spent.fmu_steps, "FMU step")}, ${count(spent.fmu_states, "FMU state")}, ${count(spent.contact_checks, "set")} of poses, ${count(spent.arm_checks, "arm search").replace("searchs", "searches")}`;
    return [h("h3", {}, "Coverage"), definitions([["spent", cost]])];
  }
  const names = cell.sensors;
  const fired = c.sensor_actions.map((times, index) => `${names[index]} in ${count(times, "action")}`).join(", ");
  return [
    h("h3", {}, "Coverage"),
    definitions([
      ["sequences", complete ? "" : `${grouped(spent.iterations)}, ${grouped(c.episodes_not_evaluated)} not evaluated`],
      ["spent", `${count(c.actions, "action")}, ${count(spent.fmu_steps, "FMU step")}, ${count(spent.fmu_states, "FMU state")}, ${count(c.contact_checks, "contact check")}, ${count(c.arm_checks, "arm search").replace("searchs", "searches")}${c.arm_checks_incomplete > 0 ? ` (${grouped(c.arm_checks_incomplete)} ended early)` : ""}${c.arm_runs_not_evaluated > 0 ? `; ${grouped(c.arm_runs_not_evaluated)} runs in which a plane tells of an arm could not be finished by the FMU` : ""}`],
      ["robot", `moved at up to ${speed(c.robot_top_speed_m_s)}; within arm's reach at ${count(c.checks_with_robot_in_arm_reach, "instant")}`],
      ["closest approach", `of the body: ${approach(c.closest_approach_m)}`],
      ...ofRobots(c.robots),
      ["within the limits", `${count(c.contacts_within_limits, "contact")}${c.contacts_within_limits > 0 ? `, highest ${ratio(c.highest_ratio_within_limits)}` : ""}`],
      ["walks", `obstacles stopped the person ${count(c.walks_blocked, "time")}`],
      ["sensors", fired ? `reported the person: ${fired}` : "none in this cell: the safeguard is the guarding itself"],
    ]),
  ];
}

function faults(all) {
  if (all.length === 0) {
    return [h("h3", {}, "Faults of the FMU"), h("p", {}, "None: the FMU finished every action that it was asked for.")];
  }
  return [
    h("h3", {}, "Faults of the FMU"),
    h("p", {}, `${count(all.length, "action")} could not be finished; what would come after is not evaluated.`),
    h("ul", { class: "faults" }, all.map((fault) => h("li", {}, h("p", { class: "message" }, fault.message), h("p", { class: "note" }, fault.actions.join(", "))))),
  ];
}

/** The section about coverage. */
export function coverage({ scan, cell }) {
  const notes = scan.warnings.map((warning) => h("li", {}, warning));
  return section(
    "coverage",
    "What the search covered",
    restsOn(scan),
    notes.length > 0 ? h("ul", { class: "warnings", "data-test": "warnings" }, notes) : null,
    h(
      "div",
      { class: "columns" },
      h("div", {}, certificate(scan), residual(scan.residual)),
      h("div", {}, seen(scan, cell), faults(scan.faults)),
    ),
  );
}
