// The facts of one hazard as a definition list.

import { command, definitions, h } from "./dom.js";
import * as words from "./words.js";

/** "F = v √(μ k)" with the numbers of this contact; √(μ k) follows from the speed at which the limit is met. */
function formula(hazard) {
  const { speed_m_s: v, safe_below_m_s: safe, limit_n: limit, force_n: f, effective_mass_kg: mass } = hazard;
  const factor = safe > 0 ? `${words.speed(v)} × ${(limit / safe).toFixed(0)} N/(m/s) = ` : "";
  return `F = v √(μ k) = ${factor}${words.force(f)}; limit ${words.force(limit)}, met at ${words.speed(safe)}. Effective mass of the robot ${mass.toFixed(2)} kg; v is the absolute speed of the robot point.`;
}

function sequence(actions) {
  return h("ol", { class: "sequence" }, actions.map((name) => h("li", { title: words.action(name) }, name)));
}

function what(hazard) {
  const text = `The robot's ${hazard.robot_link} meets the ${words.region(hazard.body_region)} at ${words.speed(hazard.speed_m_s)} after ${words.time(hazard.time_s)}: ${words.ratio(hazard.ratio)} the limit.`;
  return words.permitsNoContact(hazard.body_region) ? `${text} A moving robot may not touch it at all, whatever the force.` : text;
}

/** The facts about a hazard. */
export function facts(hazard) {
  const same = hazard.shortest.actions.join() === hazard.actions.join();
  const bend = hazard.bend_fraction < 1 ? `, bent as far as obstacles leave it (${(100 * hazard.bend_fraction).toFixed(0)} %)` : "";
  const list = definitions([
    ["what", what(hazard)],
    ["where", `contact at ${words.point(hazard.contact_point_m)}; the person stands at ${words.point(hazard.person_xy_m)}, looks to ${(((hazard.person_heading_deg % 360) + 360) % 360).toFixed(0)}°${bend}`],
    ["force", formula(hazard)],
    ["approach", `${words.speed(hazard.approach_m_s)} along the contact normal; with this speed alone ${words.force(hazard.directed_force_n)}`],
    ["arm", hazard.arm ? `${hazard.arm.side} arm. An arm pose is searched at every instant; the one shown is that at the contact.` : ""],
    ["way of the arm", hazard.through.map((plane) => `past ${plane.sensor} ${words.time(plane.since_s)} before the contact${plane.until_s > 0 ? ", ahead of the body" : ""}; the robot is where it is when that reports it`).join("; ")],
    ["sensors", `at the contact: ${words.sensors(hazard.sensors)}`],
    ["programme phase", hazard.phase === null ? "" : String(hazard.phase)],
    ["found", `${words.found(hazard)}; earliest contact at ${words.time(hazard.earliest_time_s)}${hazard.first_iteration > 0 ? `; first in iteration ${hazard.first_iteration}` : ""}`],
    ["confirmed", `by a fresh instance without any restore: ${words.confirmed(hazard.confirmed)}`],
    ["worst sequence", sequence(hazard.actions)],
    [
      "shortest and calmest",
      same ? "the same sequence" : [`${words.ratio(hazard.shortest.ratio)}, ${words.force(hazard.shortest.force_n)} at ${words.time(hazard.shortest.time_s)}; confirmed: ${words.confirmed(hazard.shortest.confirmed)}`, sequence(hazard.shortest.actions)],
    ],
    ["reproduce", [command(`fmi-hazard replay scan.json ${hazard.id}`), " in the folder with this report"]],
  ]);
  list.setAttribute("data-test", "facts");
  return list;
}
