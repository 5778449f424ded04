// Head of the report: the verdict in one plain sentence, and what the search got through.

import { h } from "./dom.js";

/** The head of the report. */
export function verdict({ scan, words, cell }) {
  const { says, covers } = scan.headline;
  return h(
    "header",
    { class: "top" },
    h("div", { class: "title" }, h("h1", {}, cell.name), h("p", { class: "kicker" }, `${scan.tool} · hazard report`)),
    h("p", { class: `verdict ${scan.verdict}`, "data-test": "verdict" }, says),
    h("p", { class: "scope", "data-test": "scope" }, covers),
    h("p", { class: "note" }, words.hazard_is),
  );
}
