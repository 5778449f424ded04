// Head of the report: the verdict in one plain sentence, and what the search got through.

import { h } from "./dom.js";
import { count, grouped } from "./words.js";

/** What may happen to a person, by the criteria that are broken. */
export function canBe({ hazards }) {
  const kinds = new Set(hazards.map(({ class: kind }) => kind));
  if (["force", "head_contact"].some((kind) => kinds.has(kind)) || kinds.size === 0) {
    return [...kinds].every((kind) => kind === "force" || kind === "head_contact") ? "A person can be hit harder than allowed" : "A person can be hit harder than allowed, and more";
  }
  const words = { clamping: "clamped", pressure: "pressed harder than allowed", moving_contact: "touched by a robot that moves", separation: "nearer than allowed to a robot that moves" };
  return `A person can be ${[...kinds].map((kind) => words[kind]).join(", and ")}`;
}

/** Whether the scan was about people from anywhere, of whom each begins elsewhere. */
export const fromAnywhere = ({ settings }) => settings.strategy === "anywhere";

/** What was looked at. */
export function lookedAt({ certificate, settings, spent }) {
  if (settings.strategy === "anywhere") {
    return `people who come from anywhere that no sensor sees, at any moment within ${settings.until_s} s of the FMU's start`;
  }
  const quick = `a quick search of ${count(spent.iterations, "sequence")}`;
  if (certificate) {
    const beginnings = `all beginnings of ${certificate.complete_for_actions} of ${certificate.horizon} actions`;
    return settings.strategy === "auto" ? `${quick}, and ${beginnings}` : beginnings;
  }
  return settings.strategy === "auto"
    ? `${quick} alone, with seed ${settings.seed}`
    : `${count(spent.iterations, "iteration")} of ${settings.strategy} with seed ${settings.seed}`;
}

/** Of results that say nothing of what they rest on. */
const OLD = { says: "This result was written by an earlier version, which did not say what it rests on. Scan again.", covers: "" };

/** The verdict in a sentence, and what it is about. */
export const headline = ({ headline: words }) => words ?? OLD;

/** The head of the report. */
export function verdict({ scan, cell }) {
  const { says, covers } = headline(scan);
  return h(
    "header",
    { class: "top" },
    h("div", { class: "title" }, h("h1", {}, cell.name), h("p", { class: "kicker" }, `${scan.tool} · hazard report`)),
    h("p", { class: `verdict ${scan.verdict}`, "data-test": "verdict" }, says),
    h("p", { class: "scope", "data-test": "scope" }, covers),
    h(
      "p",
      { class: "note" },
      `A hazard is a way, found in the model, for a person to be ${scan.settings.criteria ? "harmed by what this cell counts as unsafe" : "hit harder than ISO/TS 15066 allows"}. The report helps an assessment; it does not show that the cell is safe.`,
    ),
  );
}
