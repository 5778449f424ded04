// The report: reads the data in the page and builds the sections in their order.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { makeAssessments } from "./assessments.js";
import { causesSection } from "./causes.js";
import { coverage } from "./coverage.js";
import { readData } from "./data.js";
import { h, section } from "./dom.js";
import { assessmentForm } from "./form.js";
import { map } from "./map.js";
import { printPart } from "./print.js";
import { provenance } from "./provenance.js";
import { makeReplay } from "./replay.js";
import { makeSelection } from "./selection.js";
import { hazardTable } from "./table.js";
import { verdict } from "./verdict.js";
import { wholeSection } from "./whole.js";

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
  root.append(verdict(data));
  const selection = makeSelection(data.causes);
  root.append(unknownNote(selection), ...(data.whole ? [wholeSection(data)] : []));
  if (data.causes.length > 0) {
    const assessments = makeAssessments(data);
    const replay = makeReplay(data, selection);
    const table = hazardTable(data, selection, assessments, () => replay.picture.scrollIntoView({ block: "start" }));
    const form = assessmentForm(data, selection, assessments);
    root.append(
      printPart(data, assessments),
      causesSection(data, selection, assessments, { picture: replay.picture, assess: form.show }),
      replay.element,
      h("div", { class: "pair" }, map(data, selection, table.setBin), form.element),
      table.element,
    );
    replay.start();
  } else {
    root.append(section("hazards", "Hazards", h("p", { "data-test": "none" }, data.words.nothing_found)));
  }
  root.append(coverage(data), provenance(data));
}

const root = document.getElementById("report");
build(root).catch((error) => {
  root.append(h("p", { class: "notice" }, `This report cannot be shown: ${error.message}. See scan.json beside it.`));
  throw error;
});
