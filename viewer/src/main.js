// The report: reads the data in the page and builds the sections in their order.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { makeAssessments } from "./assessments.js";
import { coverage } from "./coverage.js";
import { readData } from "./data.js";
import { h, section } from "./dom.js";
import { assessmentForm } from "./form.js";
import { map } from "./map.js";
import { printPart } from "./print.js";
import { provenance } from "./provenance.js";
import { replaySection } from "./replay.js";
import { makeSelection } from "./selection.js";
import { hazardTable } from "./table.js";
import { verdict } from "./verdict.js";

function unknownNote(selection) {
  const note = h("p", { class: "notice", "data-test": "unknown-id" });
  const tell = () => {
    note.hidden = selection.unknown === null;
    note.textContent = selection.unknown === null ? "" : `The address names ${selection.unknown}, which this report does not hold.`;
  };
  addEventListener("hashchange", tell);
  tell();
  return note;
}

async function build(root) {
  const data = await readData();
  const { hazards } = data.scan;
  root.append(verdict(data));
  const selection = makeSelection(hazards.map((hazard) => hazard.id));
  root.append(unknownNote(selection));
  if (hazards.length > 0) {
    const assessments = makeAssessments(data);
    const table = hazardTable(data, selection, assessments);
    const replay = replaySection(data, selection);
    root.append(
      table.element,
      replay.element,
      printPart(data, assessments),
      h("div", { class: "pair" }, map(data, selection, table.setBin), assessmentForm(data, selection, assessments)),
    );
    replay.start();
  } else {
    root.append(section("hazards", "Hazards", h("p", { "data-test": "none" }, "None was found. What that is worth is told by what the search covered, below.")));
  }
  root.append(coverage(data), provenance(data));
}

const root = document.getElementById("report");
build(root).catch((error) => {
  root.append(h("p", { class: "notice" }, `This report cannot be shown: ${error.message}. scan.json beside it holds the same results.`));
  throw error;
});
