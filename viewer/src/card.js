// The card of one cause: what is wrong, how bad it is, where on the body, what to change, and its ways folded below.

import { bodyOutline } from "./body.js";
import { command, current, h } from "./dom.js";
import { requiredLevel } from "./assessments.js";
import { count } from "./words.js";

/** Changes that are shown in full; more of them are folded. */
const IN_FULL = 3;

/** Sentences longer than this are set smaller, so that what to change stays on the first screen. */
const LONG = 120;

/** Colours by which causes are told apart on cards and map; beyond these the numbers tell. */
const COLOURS = ["#c2410c", "#1d6fb8", "#7c3aed", "#15803d", "#a16207", "#0e7490", "#be185d", "#57606a"];

/** Colour of a cause. */
export const colourOf = ({ number }) => COLOURS[(number - 1) % COLOURS.length];

/** Number of a cause in its colour. */
export const badge = (cause) => h("span", { class: "badge", style: `background:${colourOf(cause)}` }, String(cause.number));

/** How often, how early, how many, as pairs of a key and a text. */
export const figures = ({ share, earliest, ways }) => Object.entries({ share, earliest, ways }).filter(([, text]) => text);

function change({ change: what, removes_all: all, less }, [effect, checked]) {
  return h(
    "li",
    { "data-test": "change", class: all ? "all" : null },
    h("b", {}, what),
    h("p", {}, effect),
    h("p", { class: "note" }, checked),
    less ? h("p", { class: "note" }, less) : null,
  );
}

/** The force that does not decide, where it is far from the one that does. */
export const otherForce = ({ other }) => (other ? h("p", { class: "flag" }, other) : null);

/** What to change, as far as it is known. */
export function remedy({ id, advice }, words) {
  const title = h("h4", {}, "What to change");
  if (!advice) {
    const [when, explain] = words.commands.explain;
    return h("div", { class: "remedy" }, title, h("p", { "data-test": "no-advice" }, when), command(`${explain}${id}`));
  }
  const { changes, no_change: none } = words.causes[id];
  const items = advice.changes.map((one, index) => change(one, changes[index]));
  const more = items.slice(IN_FULL);
  return h(
    "div",
    { class: "remedy" },
    title,
    items.length > 0 ? h("ol", { class: "changes" }, items.slice(0, IN_FULL)) : h("p", { "data-test": "no-change" }, none),
    more.length > 0 ? h("details", {}, h("summary", {}, count(more.length, "other change")), h("ol", { class: "changes", start: IN_FULL + 1 }, more)) : null,
    advice.note ? h("p", { class: "note" }, advice.note) : null,
  );
}

/** The card; `choose` selects an id, `assess` leads to the form. */
export function causeCard(data, cause, { choose, assess, assessments }) {
  const { words } = data;
  const said = words.causes[cause.id];
  const [worst, sizes] = said.severity;
  const outline = bodyOutline(cause, words);
  const decision = h("p", { class: "decided", "data-test": "cause-decision" });
  const chosen = (id) => (event) => {
    // A new window or a part of the text that is marked is not a choice.
    if (!(event.ctrlKey || event.metaKey || event.shiftKey) && String(getSelection()) === "") {
      event.preventDefault();
      event.stopPropagation();
      choose(id);
    }
  };

  const way = (id) =>
    h("li", {}, h("a", { href: `#${id}`, "data-test": "way", "data-id": id, onclick: chosen(id) }, h("span", { class: "id" }, id), ` ${words.hazards[id].way}`));
  const line = ({ hazards }, index) =>
    h(
      "details",
      { class: "line", "data-test": "line" },
      h("summary", {}, `${words.hazards[hazards[0]].deed}: `, h("b", {}, said.lines[index][1]), `, ${count(hazards.length, "way")}`),
      h("ul", { class: "ways" }, hazards.map(way)),
    );

  const link = h("a", { href: `#${cause.id}`, onclick: chosen(cause.id) }, cause.sentence);
  const element = h(
    "article",
    { class: "cause", "data-test": "cause", "data-id": cause.id, style: `--cause:${colourOf(cause)}` },
    h("header", { class: "cause-head" }, badge(cause), h("h3", { class: cause.sentence.length > LONG ? "long" : null, "data-test": "cause-sentence" }, link), h("span", { class: "id" }, cause.id)),
    h("p", { class: "severity" }, h("b", { class: "worst" }, worst), " ", h("span", {}, sizes)),
    otherForce(said),
    h("ul", { class: "figures" }, figures(said).map(([key, text]) => h("li", { class: `figure-${key}` }, text))),
    h("div", { class: "cause-body" }, remedy(cause, words), outline.element),
    h("div", { class: "decision-row" }, decision, h("button", { type: "button", class: "screen-only", onclick: assess }, "Assess it")),
    h("details", { class: "lines", "data-test": "lines" }, h("summary", {}, `${count(cause.hazards.length, "way")} of this cause, by region and link`), cause.lines.map(line)),
  );
  element.addEventListener("click", (event) => {
    if (element.classList.contains("compact") && !event.defaultPrevented && String(getSelection()) === "") {
      choose(cause.id);
    }
  });

  function decide() {
    const level = requiredLevel(assessments.of(cause.id));
    const apart = cause.hazards.filter((id) => assessments.own(id) !== null).length;
    decision.replaceChildren(
      "Decision: ",
      h("b", {}, assessments.ofCause(cause.id)),
      level ? ` · PL r: ${level}` : "",
      apart > 0 ? ` · ${count(apart, "way")} decided on ${apart === 1 ? "its" : "their"} own` : "",
    );
  }
  assessments.follow(decide);
  decide();
  return {
    element,
    /** Shows the card in full, the region of the selected hazard marked, or as one of the others. */
    show(hazard) {
      element.classList.toggle("compact", hazard === null);
      current(element, hazard !== null);
      if (hazard !== null) {
        outline.mark(data.hazard(hazard).body_region);
        element.querySelectorAll('[data-test="way"]').forEach((a) => current(a, a.dataset.id === hazard));
      }
    },
    focus: () => link.focus({ preventScroll: true }),
  };
}
