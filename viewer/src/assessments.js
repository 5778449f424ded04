// What people decided about causes and single hazards: what the report was given, merged with what is edited on the page.

import { count } from "./words.js";

/** Fields of an assessment in their order, with the choices that ISO 12100 based risk graphs give. */
export const FIELDS = [
  { key: "task", label: "Task: who does what there (ISO 12100, 5.2)", long: true },
  { key: "severity", label: "Severity", options: [["S1", "S1: slight, reversible"], ["S2", "S2: serious, irreversible or death"]] },
  { key: "exposure", label: "Exposure", options: [["F1", "F1: seldom or short"], ["F2", "F2: frequent or long"]] },
  { key: "avoidance", label: "Avoidance", options: [["P1", "P1: possible"], ["P2", "P2: scarcely possible"]] },
  { key: "decision", label: "Decision", options: ["open", "reduce", "accepted", "not credible"].map((value) => [value, value]) },
  { key: "measure", label: "Protective measure", long: true },
  { key: "residual", label: "Residual risk", long: true },
  { key: "by", label: "By" },
  { key: "date", label: "Date", type: "date" },
];

/** The risk graph of ISO 13849-1, Annex A: required performance level by severity, exposure, avoidance. */
const GRAPH = { S1F1P1: "a", S1F1P2: "b", S1F2P1: "b", S1F2P2: "c", S2F1P1: "c", S2F1P2: "d", S2F2P1: "d", S2F2P2: "e" };

/** Required performance level that follows from an assessment; null as long as one of the three is not chosen. */
export const requiredLevel = ({ severity, exposure, avoidance }) => GRAPH[`${severity}${exposure}${avoidance}`] ?? null;

const sorted = (object) => Object.fromEntries(Object.entries(object).sort(([a], [b]) => (a < b ? -1 : 1)));

/** The assessments of this report. */
export function makeAssessments({ assessments, cell, causeOf }) {
  const all = new Map(Object.entries(assessments).map(([id, fields]) => [id, { ...fields }]));
  const listeners = [];
  const unsaved = new Set();
  const tell = () => listeners.forEach((listener) => listener());

  addEventListener("beforeunload", (event) => {
    if (unsaved.size > 0) {
      event.preventDefault();
    }
  });

  const usual = FIELDS.find((field) => field.key === "decision").options.map(([value]) => value);
  const given = [...all.values()].map((fields) => fields.decision).filter(Boolean);
  const of = (id) => all.get(id) ?? {};
  const own = (id) => of(id).decision || null;

  return {
    /** Decisions to choose from, those of the given file included. */
    decisions: [...new Set([...usual, ...given])],
    /** The fields of a cause or of a single hazard; none if it is not assessed. */
    of,
    /** The decision that was made for a hazard itself; null if that of its cause holds for it. */
    own,
    /** What was decided about a cause. */
    ofCause: (id) => own(id) ?? "open",
    /** What was decided about a hazard: for itself, or for its cause. */
    decision: (id) => own(id) ?? own(causeOf(id)?.id) ?? "open",
    set(id, key, value) {
      const empty = Object.fromEntries(FIELDS.map((field) => [field.key, ""]));
      all.set(id, { ...empty, ...all.get(id), [key]: value });
      unsaved.add(id);
      tell();
    },
    /** What is edited and in no file yet: "1 cause and 2 single ways"; empty if nothing is. */
    unsaved() {
      const causes = [...unsaved].filter((id) => id.startsWith("C-")).length;
      const ways = unsaved.size - causes;
      return [causes > 0 ? count(causes, "cause") : "", ways > 0 ? count(ways, "single way") : ""].filter(Boolean).join(" and ");
    },
    /** The file, in an order that a version control system shows small changes in. */
    text() {
      const entries = Object.fromEntries([...all].map(([id, fields]) => [id, sorted(fields)]));
      return `${JSON.stringify({ assessments: sorted(entries), cell: cell.name, format: 1 }, null, 2)}\n`;
    },
    saved() {
      unsaved.clear();
      tell();
    },
    follow: (listener) => listeners.push(listener),
  };
}
