// What the search covered and what that is worth: certificate, residual figures, coverage, faults, notes.

import { definitions, h, section } from "./dom.js";
import { restsOn } from "./rests_on.js";

/** Parts of the left column; the others are in the right one. */
const LEFT = ["certificate", "residual"];

function part({ id, title, says, rows = [] }, { certificate, faults }) {
  const complete = id !== "certificate" || certificate?.complete;
  return [
    h("h3", {}, title),
    says ? h("p", { "data-test": complete ? null : "incomplete" }, says) : null,
    definitions(rows),
    id === "faults" ? h("ul", { class: "faults" }, faults.map((fault) => h("li", {}, h("p", { class: "message" }, fault.message), h("p", { class: "note" }, fault.actions.join(", "))))) : null,
  ];
}

/** The section about coverage. */
export function coverage({ scan, words }) {
  const notes = scan.warnings.map((warning) => h("li", {}, warning));
  const column = (left) => h("div", {}, words.searched.filter(({ id }) => LEFT.includes(id) === left).flatMap((one) => part(one, scan)));
  return section(
    "coverage",
    "What the search covered",
    restsOn(scan, words),
    notes.length > 0 ? h("ul", { class: "warnings", "data-test": "warnings" }, notes) : null,
    h("div", { class: "columns" }, column(true), column(false)),
  );
}
