// The facts of one hazard as a definition list.

import { command, definitions, h } from "./dom.js";
import * as words from "./words.js";

/** "F = v √(μ k)" with the numbers of this contact; √(μ k) follows from the speed at which the limit is met. */
function formula(hazard) {
  const { speed_m_s: v, safe_below_m_s: safe, limit_n: limit, force_n: f, effective_mass_kg: mass } = hazard;
  const factor = safe > 0 ? `${words.speed(v)} × ${(limit / safe).toFixed(0)} N/(m/s) = ` : "";
  return `F = v √(μ k) = ${factor}${words.force(f)}; limit ${words.force(limit)}, met at ${words.speed(safe)}. Effective mass of the robot ${mass.toFixed(2)} kg; v is the robot's own speed.`;
}

/** Both forces, which one decides, and a word where they are far apart. */
function bothForces(hazard, settings) {
  const { own, approach, decides, apart } = words.forces(hazard, settings);
  const line = (one) => h("li", { class: one === decides ? "decides" : null }, `${one.name}, ${words.speed(one.speed)}: ${words.force(one.force)}, ${words.ratio(one.ratio)} the limit`, one === decides ? h("b", {}, " (decides)") : null);
  return h(
    "div",
    { "data-test": "forces" },
    h("ul", { class: "plain-list" }, line(own), line(approach)),
    apart ? h("p", { class: "flag", "data-test": "apart" }, `${words.APART_TEXT} ${own.ratio > approach.ratio ? "Most of the robot's speed is not towards the person." : "Most of the speed is the person's own walking."}`) : null,
  );
}

const sequence = (actions, each) => h("ol", { class: "sequence" }, words.sequence(actions, each).map((text) => h("li", {}, text)));

function what(hazard, settings) {
  if (!words.byForce(hazard)) {
    return `The robot's ${hazard.robot_link}, which moves at ${words.speed(hazard.speed_m_s)}, ${words.deed(hazard)} after ${words.time(hazard.time_s)}.`;
  }
  const { decides } = words.forces(hazard, settings);
  const text = `The robot's ${hazard.robot_link} ${words.deed(hazard)} at ${words.speed(hazard.speed_m_s)} after ${words.time(hazard.time_s)}: ${words.ratio(decides.ratio)} the limit.`;
  return words.permitsNoContact(hazard.body_region) ? `${text} A moving robot may not touch it at all, whatever the force.` : text;
}

/** What is broken by another criterion, and, for information, the force that it would be on somebody who can give way. */
function otherCriterion(hazard) {
  const [times, sizes] = words.severity(hazard);
  return h(
    "div",
    { "data-test": "forces" },
    h("p", {}, h("b", {}, times), ` ${sizes}`, h("b", {}, " (decides)")),
    hazard.class === "separation" ? null : h("p", { class: "note" }, `On somebody who can give way: ${words.force(hazard.force_n)}, ${words.ratio(hazard.force_n / hazard.limit_n)} the limit.`),
  );
}

/** With the numbers of this contact, as far as a formula has it. */
function otherFormula({ judged, effective_mass_kg: mass }) {
  const { clamping, pressure, separation, limit: by } = judged ?? {};
  if (separation) {
    const stops = typeof separation.stops_after_s === "number" ? `Stopped at that instant the robot stands after ${words.time(separation.stops_after_s)}, up to ${separation.travel_m.toFixed(3)} m farther` : "The robot does not stop";
    return `${stops}, as the FMU shows.`;
  }
  if (clamping && by === "force") {
    const { closing_m_s: c, gap_m: gap, travel_m: travel, force_n: f, limit_n: limit } = clamping;
    const on = travel > 0 ? `; after a contact the link goes on by ${(1000 * travel).toFixed(0)} mm` : "";
    return `${(1000 * gap).toFixed(0)} mm of room${on}. F = c √(m k) = ${words.force(f)} with c = ${words.speed(c)}, at which the gap closes, and the robot's effective mass m = ${mass.toFixed(2)} kg; quasi-static limit ${words.force(limit)}.`;
  }
  return pressure ? `By what the cell file says of how small the surface is that touches${pressure.clamped ? "; the part cannot give way" : ""}.` : "";
}

/** The facts about a hazard; in short those that a printed page has room for. */
export function facts(hazard, settings, { short = false } = {}) {
  const each = settings.action_s;
  const same = hazard.shortest.actions.join() === hazard.actions.join();
  const bend = hazard.bend_fraction < 1 ? `, bent as far as obstacles leave it (${(100 * hazard.bend_fraction).toFixed(0)} %)` : "";
  const list = definitions([
    ["what", what(hazard, settings)],
    ["where", `${hazard.class === "separation" ? "nearest point of the robot" : "contact"} at ${words.point(hazard.contact_point_m)}; ${hazard.person ?? "the person"} stands at ${words.point(hazard.person_xy_m)}, looks to ${(((hazard.person_heading_deg % 360) + 360) % 360).toFixed(0)}°${bend}`],
    ["begins", hazard.begins ? `at ${words.point(hazard.begins.xy_m)}, looking to ${hazard.begins.heading_deg.toFixed(0)}°, ${words.begun(hazard.begins)}; times count from then` : ""],
    ["force", words.byForce(hazard) ? bothForces(hazard, settings) : ""],
    ["broken", words.byForce(hazard) ? "" : otherCriterion(hazard)],
    ["how computed", short ? "" : words.byForce(hazard) ? formula(hazard) : otherFormula(hazard)],
    ["arm", hazard.arm && !short ? `${hazard.arm.side} arm. An arm pose is searched at every instant; the one shown is that at the contact.` : ""],
    ["way of the arm", hazard.through.map((plane) => `past ${plane.sensor} ${words.time(plane.since_s)} before the contact${plane.until_s > 0 ? ", ahead of the body" : ""}; the robot is where it is when that reports it`).join("; ")],
    ["sensors", `${hazard.class === "separation" ? "then" : "at the contact"}: ${words.sensors(hazard.sensors)}`],
    ["programme phase", hazard.phase === null || short ? "" : String(hazard.phase)],
    ["found", short ? "" : `${words.found(hazard)}; earliest contact at ${words.time(hazard.earliest_time_s)}${hazard.first_iteration > 0 ? `; first in iteration ${hazard.first_iteration}` : ""}`],
    ["confirmed", `by a fresh instance without any restore: ${words.confirmed(hazard.confirmed)}`],
    ["worst sequence", sequence(hazard.actions, each)],
    [
      "shortest and calmest",
      short ? "" : same ? "the same sequence" : [`${words.ratio(hazard.shortest.ratio)}${hazard.judged?.limit === "force" || words.byForce(hazard) ? `, ${words.force(hazard.shortest.force_n)}` : ""} at ${words.time(hazard.shortest.time_s)}; confirmed: ${words.confirmed(hazard.shortest.confirmed)}`, sequence(hazard.shortest.actions, each)],
    ],
    ["replay it", short ? "" : [command(`fmi-hazard replay scan.json ${hazard.id}`), " in the folder with this report"]],
  ]);
  if (!short) {
    list.setAttribute("data-test", "facts");
  }
  return list;
}
