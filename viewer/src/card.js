// The card of one cause: what is wrong, how bad it is, where on the body, what to change, and its ways folded below.

import { bodyOutline } from "./body.js";
import { command, current, h } from "./dom.js";
import { requiredLevel } from "./assessments.js";
import * as words from "./words.js";

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

/** How often, how early, how many, as pairs; of a cause whose worst hazard has a beginning of its own, when that is. */
export function figures(data, cause) {
  const { begins } = data.hazard(cause.worst);
  return [
    ["share", typeof cause.share === "number" ? `${words.share(cause.share)} of all sequences` : ""],
    ["earliest", begins ? `worst begins ${words.begun(begins)}` : `after ${words.time(cause.earliest_time_s)}`],
    ["ways", `${words.count(cause.hazards.length, "way")}, ${cause.confirmed === cause.hazards.length ? (cause.confirmed === 1 ? "confirmed" : "all confirmed") : `${cause.confirmed} confirmed`}`],
  ].filter(([, text]) => text);
}

function change({ change: what, checked, complete, enough_until_s: until, removes_all: all, less }) {
  const enough = typeof until === "number";
  const effect = [
    ["With it this cause was not met any more; other causes are left.", "It removes this cause; other causes are left."],
    ["Tried in part: with it no hazard was met any more.", "Tried in part: with it nothing is hazardous from the starts in the cell file; from elsewhere that is not shown."],
    ["", `Enough: with it nothing in this cell is hazardous any more, by any sequence from the start and from anywhere until ${until} s.`],
  ][Number(all) + Number(all && complete && enough)][Number(complete)];
  return h(
    "li",
    { "data-test": "change", class: all ? "all" : null },
    h("b", {}, what),
    h("p", {}, effect),
    h("p", { class: "note" }, `Checked: ${checked}${complete ? "" : " (not every sequence)"}.`.replace(/\.\.$/, ".")),
    less ? h("p", { class: "note" }, less) : null,
  );
}

/** The force that does not decide, where it is far from the one that does. */
export function otherForce(data, cause) {
  const { own, approach, decides, apart } = words.forces(data.hazard(cause.worst), data.scan.settings);
  const other = decides === own ? approach : own;
  return apart ? h("p", { class: "flag" }, `${other.name[0].toUpperCase()}${other.name.slice(1)}: ${words.ratio(other.ratio)} the limit, ${words.force(other.force)}.`) : null;
}

/** What to change, as far as it is known. */
export function remedy({ id, advice }) {
  const title = h("h4", {}, "What to change");
  if (!advice) {
    return h("div", { class: "remedy" }, title, h("p", { "data-test": "no-advice" }, "Changes are tried out by:"), command(`fmi-hazard explain . ${id}`));
  }
  const { changes, note } = advice;
  const more = changes.slice(IN_FULL);
  return h(
    "div",
    { class: "remedy" },
    title,
    changes.length > 0
      ? h("ol", { class: "changes" }, changes.slice(0, IN_FULL).map(change))
      : h("p", { "data-test": "no-change" }, "No single change that was tried keeps this cause from being met."),
    more.length > 0 ? h("details", {}, h("summary", {}, `${words.count(more.length, "other change")}`), h("ol", { class: "changes", start: IN_FULL + 1 }, more.map(change))) : null,
    note ? h("p", { class: "note" }, note) : null,
  );
}

/** The card; `choose` selects an id, `assess` leads to the form. */
export function causeCard(data, cause, { choose, assess, assessments }) {
  const [worst, sizes] = words.severity(cause, data.hazard(cause.worst));
  const outline = bodyOutline(cause);
  const decision = h("p", { class: "decided", "data-test": "cause-decision" });
  const chosen = (id) => (event) => {
    // A new window or a part of the text that is marked is not a choice.
    if (!(event.ctrlKey || event.metaKey || event.shiftKey) && String(getSelection()) === "") {
      event.preventDefault();
      event.stopPropagation();
      choose(id);
    }
  };

  const way = (id) => {
    const hazard = data.hazard(id);
    return h(
      "li",
      {},
      h("a", { href: `#${id}`, "data-test": "way", "data-id": id, onclick: chosen(id) }, h("span", { class: "id" }, id), ` ${words.ratio(words.forces(hazard, data.scan.settings).decides.ratio)} after ${words.time(hazard.time_s)}`),
    );
  };
  const size = (region, ratio) => (words.byForce(cause) ? words.ratioOf(region, ratio) : words.ratio(ratio));
  const line = ({ body_region: region, robot_link: link, ratio, hazards }) =>
    h(
      "details",
      { class: "line", "data-test": "line" },
      h("summary", {}, `${link} ${words.deed({ ...data.hazard(hazards[0]), body_region: region })}: `, h("b", {}, size(region, ratio)), `, ${words.count(hazards.length, "way")}`),
      h("ul", { class: "ways" }, hazards.map(way)),
    );

  const link = h("a", { href: `#${cause.id}`, onclick: chosen(cause.id) }, cause.sentence);
  const element = h(
    "article",
    { class: "cause", "data-test": "cause", "data-id": cause.id, style: `--cause:${colourOf(cause)}` },
    h("header", { class: "cause-head" }, badge(cause), h("h3", { class: cause.sentence.length > LONG ? "long" : null, "data-test": "cause-sentence" }, link), h("span", { class: "id" }, cause.id)),
    h("p", { class: "severity" }, h("b", { class: "worst" }, worst), " ", h("span", {}, sizes)),
    otherForce(data, cause),
    h("ul", { class: "figures" }, figures(data, cause).map(([key, text]) => h("li", { class: `figure-${key}` }, text))),
    h("div", { class: "cause-body" }, remedy(cause), outline.element),
    h("div", { class: "decision-row" }, decision, h("button", { type: "button", class: "screen-only", onclick: assess }, "Assess it")),
    h("details", { class: "lines", "data-test": "lines" }, h("summary", {}, `${words.count(cause.hazards.length, "way")} of this cause, by region and link`), cause.lines.map(line)),
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
      apart > 0 ? ` · ${words.count(apart, "way")} decided on ${apart === 1 ? "its" : "their"} own` : "",
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
