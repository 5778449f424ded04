// The facts of one hazard as a definition list.

import { command, definitions, h } from "./dom.js";

/** Both forces, which one decides, and a word where they are far apart. */
function bothForces({ forces: [lines, decides], apart }) {
  const line = (text, index) => h("li", { class: index === decides ? "decides" : null }, text, index === decides ? h("b", {}, " (decides)") : null);
  return h(
    "div",
    { "data-test": "forces" },
    h("ul", { class: "plain-list" }, lines.map(line)),
    apart ? h("p", { class: "flag", "data-test": "apart" }, apart) : null,
  );
}

/** What is broken by another criterion, and, for information, the force that it would be on somebody who can give way. */
function otherCriterion([worst, figures, beside]) {
  return h(
    "div",
    { "data-test": "forces" },
    h("p", {}, h("b", {}, worst), ` ${figures}`, h("b", {}, " (decides)")),
    beside ? h("p", { class: "note" }, beside) : null,
  );
}

/** Actions, equal ones in a row as one: "3 x walks straight ahead, upright, 0.6 s"; `each` is how long one takes. */
function sequence(names, words, each) {
  const groups = [];
  for (const name of names) {
    if (groups.at(-1)?.name === name) {
      groups.at(-1).times += 1;
    } else {
      groups.push({ name, times: 1 });
    }
  }
  const line = ({ name, times }) => `${times > 1 ? `${times} x ` : ""}${words.actions[name]}, ${+(times * each).toFixed(2)} s`;
  return h("ol", { class: "sequence" }, groups.map((group) => h("li", {}, line(group))));
}

/** The facts about a hazard; in short those that a printed page has room for. */
export function facts({ scan, words }, hazard, { short = false } = {}) {
  const each = scan.settings.action_s;
  const said = words.hazards[hazard.id];
  const same = hazard.shortest.actions.join() === hazard.actions.join();
  const [, replay] = words.commands.replay;
  const list = definitions([
    ["what", said.what],
    ["person", said.person],
    ["begins", said.begins],
    ["force", said.forces ? bothForces(said) : ""],
    ["broken", said.broken ? otherCriterion(said.broken) : ""],
    ["how computed", short ? "" : said.computed],
    ["arm", hazard.arm && !short ? words.arm : ""],
    ["way of the arm", said.through?.join(" ")],
    ["sensors", said.sensors],
    ["programme phase", hazard.phase === null || short ? "" : String(hazard.phase)],
    ["found", short ? "" : said.found],
    ["confirmed", `${words.confirmed}: ${said.row.at(-1)}`],
    ["worst sequence", sequence(hazard.actions, words, each)],
    ["shortest way", short ? "" : [said.shortest, same ? "" : sequence(hazard.shortest.actions, words, each)]],
    ["replay it", short ? "" : [words.commands.replay[0], command(`${replay}${hazard.id}`)]],
  ]);
  if (!short) {
    list.setAttribute("data-test", "facts");
  }
  return list;
}
