// What is printed in place of the screen: a page to sign, then a page for each cause.

import { FIELDS, requiredLevel } from "./assessments.js";
import { bodyOutline } from "./body.js";
import { badge, figures, otherForce, remedy } from "./card.js";
import { definitions, drawing, h } from "./dom.js";
import { facts } from "./facts.js";
import { wholePage } from "./whole.js";
import { count } from "./words.js";

/** Lines of a cause that have room on its page. */
const LINES = 8;

const table = (heads, rows, kind) =>
  h("table", { class: `plain ${kind}` }, h("thead", {}, h("tr", {}, heads.map((title) => h("th", { scope: "col" }, title)))), h("tbody", {}, rows.map((cells) => h("tr", {}, cells.map((cell) => h("td", {}, cell))))));

/** The first page: what it is about, what was found and decided, who says so. */
function firstPage(data, assessments) {
  const { scan, words, cell } = data;
  const { says, covers } = scan.headline;
  const rows = data.causes.map((cause) => [badge(cause), cause.sentence, words.causes[cause.id].severity[0], remedyLine(cause, words), assessments.ofCause(cause.id), requiredLevel(assessments.of(cause.id)) ?? "–"]);
  return h(
    "article",
    { class: "first", "data-test": "print-first" },
    h("p", { class: "kicker" }, `${scan.tool} · hazard report`),
    h("h1", {}, cell.name),
    h("p", { class: "verdict" }, says),
    h("p", {}, covers),
    h("h3", {}, "Causes, worst first"),
    table(["", "cause", "worst", "what to change", "decision", "PL r"], rows, "causes"),
    h("h3", {}, "What the search covered"),
    definitions([
      ["cell file", [scan.subject.cell_found, "; SHA-256 ", h("code", {}, scan.subject.cell_sha256)]],
      ["FMU", scan.subject.fmus.flatMap((fmu, index) => [index > 0 ? "; " : "", `${fmu.unit ? `${fmu.unit}: ` : ""}${fmu.model_name}; SHA-256 `, h("code", {}, fmu.sha256)])],
      ["made again by", h("code", {}, data.reproduce)],
    ]),
    h("h3", {}, "Assessed by"),
    h("div", { class: "sign" }, ["Name", "Date", "Signature"].map((text) => h("p", {}, text))),
    h("p", { class: "note" }, words.hazard_is),
  );
}

const remedyLine = ({ id, advice }, words) => advice?.changes[0]?.change ?? words.causes[id].no_change;

function causePage(data, cause, assessments) {
  const { words } = data;
  const hazard = data.hazard(cause.worst);
  const said = words.causes[cause.id];
  const [worst, sizes] = said.severity;
  const outline = bodyOutline(cause, words);
  outline.mark(hazard.body_region);
  const view = data.topView(cause.worst);
  const given = assessments.of(cause.id);
  const apart = cause.hazards.filter((id) => assessments.own(id) !== null);
  const lines = cause.lines.map(({ robot_link: link, hazards }, index) => {
    const [hit, hard] = said.lines[index];
    return [hit, link, hard, String(hazards.length)];
  });
  return h(
    "article",
    { "data-test": "print-cause", "data-id": cause.id },
    h("h2", {}, badge(cause), ` ${cause.sentence}`),
    h("p", { class: "severity" }, h("b", {}, worst), ` ${sizes}`),
    otherForce(said),
    h("p", {}, [...figures(said).map(([, text]) => text), cause.id].join(" · ")),
    h("div", { class: "print-pictures" }, view ? drawing(view) : h("p", { class: "note" }, "This report carries no drawing of its worst way."), outline.element),
    h("div", { class: "print-columns" }, h("div", {}, remedy(cause, words)), h("div", {}, h("h4", {}, "Assessment (ISO 12100)"), definitions([
      ...FIELDS.map(({ key, label }) => [label.split(":")[0].toLowerCase(), key === "decision" ? assessments.ofCause(cause.id) : given[key]]),
      ["PL r", requiredLevel(given) ?? ""],
      ["decided apart", apart.map((id) => `${id}: ${assessments.own(id)}`).join(", ")],
    ]))),
    h("h4", {}, `Its worst way, ${cause.worst}`),
    facts(data, hazard, { short: true }),
    h("h4", {}, "Ways by region and link"),
    table(["body region", "hit by", "worst", "ways"], lines.slice(0, LINES), "lines"),
    lines.length > LINES ? h("p", { class: "note" }, `And ${count(lines.length - LINES, "other pair")} of region and link, less bad; scan.json has them all.`) : null,
  );
}

/** The part for paper; it is filled when the page is printed, and empty on the screen. */
export function printPart(data, assessments) {
  const element = h("section", { class: "print-only", id: "print" });
  addEventListener("beforeprint", () => element.replaceChildren(firstPage(data, assessments), ...(data.whole ? [wholePage(data)] : []), ...data.causes.map((cause) => causePage(data, cause, assessments))));
  addEventListener("afterprint", () => element.replaceChildren());
  return element;
}
