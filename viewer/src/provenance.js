// What was scanned, with what, and under which assumptions; licences of the libraries in this page.

import { command, definitions, h, section } from "./dom.js";
import { criterion } from "./words.js";

const hash = (value) => h("code", { class: "hash" }, value);

function agreement(value) {
  const result = value?.result ?? String(value);
  switch (result) {
    case "exact":
      return "exact";
    case "not_offered":
      return "not offered";
    case "differs":
      return `WRONG, differs by up to ${value.largest.toExponential(2)}`;
    case "failed":
      return `FAILED: ${value.reason}`;
    default:
      return result;
  }
}

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

const label = (key) => key.replaceAll("_", " ");

const UNITS = [
  ["_m_s", " m/s"],
  ["_s", " s"],
  ["_m", " m"],
  ["_deg", " degrees"],
];

/** Any value in words, with the unit that its name ends in, and the name without it. */
function named(key, value) {
  const measured = [value].flat().every((one) => typeof one === "number");
  const [end, unit] = (measured && UNITS.find(([ending]) => key.endsWith(ending))) || ["", ""];
  return [label(key.slice(0, key.length - end.length)), `${inWords(value)}${unit}`];
}

function inWords(value) {
  if (typeof value === "number") {
    return String(Number(value.toPrecision(12)));
  }
  if (typeof value === "boolean") {
    return value ? "yes" : "no";
  }
  if (Array.isArray(value)) {
    return value.map((one) => (one !== null && typeof one === "object" ? `(${inWords(one)})` : inWords(one))).join("; ") || "none";
  }
  if (value !== null && typeof value === "object") {
    return Object.entries(value).map(([key, one]) => {
      const [name, words] = named(key, one);
      return one !== null && typeof one === "object" && !Array.isArray(one) ? `${name} (${words})` : `${name} ${words}`;
    }).join(", ");
  }
  return value === null ? "none" : String(value);
}

function settings(all) {
  const pairs = Object.entries(all).map(([key, value]) => (key === "speed_criterion" ? [label(key), criterion(all)] : named(key, value)));
  return [h("h3", {}, "Settings"), definitions(pairs)];
}

function selfTest(test) {
  const pairs = Object.entries(test).map(([key, value]) => [
    label(key.replace(/_s$/, "")),
    typeof value === "object" && value !== null ? agreement(value) : `${value}${key.endsWith("_s") ? " s" : ""}`,
  ]);
  return [
    h("h3", {}, "Self-test of the FMU"),
    h("p", { class: "note" }, "Whether runs repeat exactly, and what saved states, reset and copies are worth."),
    definitions(pairs),
  ];
}

function tables({ standard_edition: edition, tables: all }) {
  const open = all.filter((table) => !table.verified).length;
  const rows = all.map((table) =>
    h("tr", {}, h("td", {}, table.title), h("td", {}, table.verified ? "verified" : "not verified"), h("td", {}, table.source), h("td", {}, table.confidence)),
  );
  return h(
    "div",
    {},
    h("h3", {}, "Limits and tables"),
    h("p", {}, `${edition}. ${open} of ${all.length} tables are not yet verified against the purchased standards.`),
    h(
      "div",
      { class: "scroll", tabindex: 0 },
      h("table", { class: "plain" }, h("thead", {}, h("tr", {}, ["table", "state", "source", "confidence"].map((title) => h("th", { scope: "col" }, title)))), h("tbody", {}, rows)),
    ),
  );
}

/** The last section. */
export function provenance({ scan, assumptions, reproduce }) {
  return section(
    "provenance",
    "What was scanned",
    h("div", { class: "columns" }, subject(scan), h("div", {}, settings(scan.settings)), h("div", {}, selfTest(scan.self_test))),
    tables(scan),
    h("h3", {}, "Assumptions"),
    h("ul", { class: "assumptions", "data-test": "assumptions" }, assumptions.map((text) => h("li", {}, text))),
    h("h3", {}, "Reproduce"),
    h("p", { class: "note" }, "In the folder with this report:"),
    command(reproduce),
    h(
      "p",
      { class: "note" },
      "This page carries three.js (MIT licence, © three.js authors) and uPlot (MIT licence, © 2022 Leon Sorokin); the full texts are at the end of its script.",
    ),
  );
}
