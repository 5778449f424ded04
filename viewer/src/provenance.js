// What was scanned, with what, and under which assumptions; licences of the libraries in this page.

import { command, definitions, h, section } from "./dom.js";

const hash = (value) => h("code", { class: "hash" }, value);

function subject({ subject: s, tool }) {
  const fmus = s.fmus.map((fmu) => [
    fmu.unit ? `FMU ${fmu.unit}` : "FMU",
    [`${fmu.model_name}, FMI ${fmu.fmi_version}, by ${fmu.generation_tool || "an unnamed tool"}; SHA-256 `, hash(fmu.sha256)],
  ]);
  const rows = [
    ["tool", tool],
    ["cell", s.cell],
    ["cell file", [`${s.cell_found}; SHA-256 `, hash(s.cell_sha256)]],
    ...fmus,
  ];
  return h(
    "div",
    {},
    h("h3", {}, "Subject"),
    h("dl", {}, rows.map(([term, value]) => h("div", {}, h("dt", {}, term), h("dd", {}, value)))),
    s.couplings.length > 0 ? h("ul", {}, s.couplings.map((coupling) => h("li", {}, coupling))) : null,
  );
}

const settings = (rows) => [h("h3", {}, "Settings"), definitions(rows)];

const selfTest = (rows) => [
  h("h3", {}, "Self-test of the FMU"),
  h("p", { class: "note" }, "Whether runs repeat exactly, and what saved states, reset and copies are worth."),
  definitions(rows),
];

function tables({ tables: all }, limits) {
  const rows = all.map((table) =>
    h("tr", {}, h("td", {}, table.title), h("td", {}, table.verified ? "verified" : "not verified"), h("td", {}, table.source), h("td", {}, table.confidence)),
  );
  return h(
    "div",
    {},
    h("h3", {}, "Limits and tables"),
    h("p", {}, limits),
    h(
      "div",
      { class: "scroll", tabindex: 0 },
      h("table", { class: "plain" }, h("thead", {}, h("tr", {}, ["table", "state", "source", "confidence"].map((title) => h("th", { scope: "col" }, title)))), h("tbody", {}, rows)),
    ),
  );
}

/** The last section. */
export function provenance({ scan, words, assumptions, reproduce }) {
  return section(
    "provenance",
    "Subject and settings",
    h("div", { class: "columns" }, subject(scan), h("div", {}, settings(words.settings)), h("div", {}, selfTest(words.self_test))),
    tables(scan, words.limits),
    h("h3", {}, "Assumptions"),
    h("ul", { class: "assumptions", "data-test": "assumptions" }, assumptions.map((text) => h("li", {}, text))),
    h("h3", {}, "Reproduce"),
    h("p", { class: "note" }, words.commands.replay[0]),
    command(reproduce),
    h(
      "p",
      { class: "note" },
      "This page carries three.js (MIT licence, © three.js authors) and uPlot (MIT licence, © 2022 Leon Sorokin); the full texts are at the end of its script.",
    ),
  );
}
