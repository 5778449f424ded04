// What people decided about the hazards: what the report was given, merged with what is edited on the page.

/** Fields of an assessment in their order, with the choices that ISO 12100 based risk graphs give. */
export const FIELDS = [
  { key: "severity", label: "Severity", options: [["S1", "S1: slight, reversible"], ["S2", "S2: serious, irreversible or death"]] },
  { key: "exposure", label: "Exposure", options: [["F1", "F1: seldom or short"], ["F2", "F2: frequent or long"]] },
  { key: "avoidance", label: "Avoidance", options: [["P1", "P1: possible"], ["P2", "P2: scarcely possible"]] },
  { key: "decision", label: "Decision", options: ["open", "reduce", "accepted", "not credible"].map((value) => [value, value]) },
  { key: "measure", label: "Protective measure", long: true },
  { key: "residual", label: "Residual risk", long: true },
  { key: "by", label: "By" },
  { key: "date", label: "Date", type: "date" },
];

const sorted = (object) => Object.fromEntries(Object.entries(object).sort(([a], [b]) => (a < b ? -1 : 1)));

/** The assessments of this report. */
export function makeAssessments({ assessments, cell }) {
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

  return {
    /** Decisions to choose from, those of the given file included. */
    decisions: [...new Set([...usual, ...given])],
    /** The fields of a hazard; none if it is not assessed yet. */
    of: (id) => all.get(id) ?? {},
    set(id, key, value) {
      const empty = Object.fromEntries(FIELDS.map((field) => [field.key, ""]));
      all.set(id, { ...empty, ...all.get(id), [key]: value });
      unsaved.add(id);
      tell();
    },
    /** Ids with edits that are in no file yet. */
    unsaved,
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
