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

function sentence(scan) {
  const number = scan.hazards.length;
  const sure = scan.hazards.filter((hazard) => hazard.confirmed).length;
  switch (scan.verdict) {
    case "hazards_found": {
      const causes = scan.causes?.length ?? 0;
      const confirmed = sure === number ? (number === 1 ? "confirmed" : "all confirmed") : `${grouped(sure)} confirmed`;
      return `${canBe(scan)}: ${count(causes, "cause")}, ${count(number, "way")}, ${confirmed} by a fresh replay.`;
    }
    case "none_found":
      return "No hazard found in this model.";
    case "inconclusive":
      return "Inconclusive: nothing was found, which says nothing about the cell. See the notes under coverage.";
    case "fmu_failed":
      return "The FMU failed: nothing was found in what could be evaluated, which says little.";
    case "interrupted":
      return "Interrupted: nothing found so far.";
    default:
      return `Verdict: ${scan.verdict}.`;
  }
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

function scope(scan) {
  if (scan.certificate?.complete) {
    const others = scan.hazards.length > 0 ? "there are no others" : "none of them is hazardous";
    return [
      "Complete.",
      `All ${grouped(scan.certificate.sequences)} sequences are accounted for: ${others} within the stated actions and horizon, in this model. A statement about the model, not about the real cell.`,
    ];
  }
  if (fromAnywhere(scan) && scan.verdict === "none_found") {
    return ["Nothing was left open.", `Looked at: ${lookedAt(scan)}. A statement about the model, not about the real cell.`];
  }
  const left = scan.residual ? " The residual figures under coverage bound what is left." : "";
  return ["Not complete.", `Looked at: ${lookedAt(scan)}. Not finding more is not proof of safety.${left}`];
}

/** The verdict in one sentence, and what it covers in two parts. */
export const summary = (scan) => ({ sentence: sentence(scan), scope: scope(scan) });

/** The head of the report. */
export function verdict({ scan, cell }) {
  const [word, meaning] = scope(scan);
  return h(
    "header",
    { class: "top" },
    h("div", { class: "title" }, h("h1", {}, cell.name), h("p", { class: "kicker" }, `${scan.tool} · hazard report`)),
    h("p", { class: `verdict ${scan.verdict}`, "data-test": "verdict" }, sentence(scan)),
    h("p", { class: "scope", "data-test": "scope" }, h("strong", {}, word), ` ${meaning}`),
    h(
      "p",
      { class: "note" },
      `A hazard is a way, found in the model, for a person to be ${scan.settings.criteria ? "harmed by what this cell counts as unsafe" : "hit harder than ISO/TS 15066 allows"}. The report helps an assessment; it does not show that the cell is safe.`,
    ),
  );
}
