// The form that assesses the selected hazard, and the button that hands out the file.

import { h, section } from "./dom.js";
import { FIELDS } from "./assessments.js";
import { count, ratio, region } from "./words.js";

const FILE = "assessments.json";

function input(field, { decisions }) {
  const common = { "data-test": `assess-${field.key}`, name: field.key };
  if (field.options) {
    const options = field.key === "decision" ? decisions.map((value) => [value, value]) : field.options;
    const blank = field.key === "decision" ? [] : [h("option", { value: "" }, "–")];
    return h("select", common, blank, options.map(([value, text]) => h("option", { value }, text)));
  }
  return field.long ? h("textarea", { ...common, rows: 2 }) : h("input", { ...common, type: field.type ?? "text" });
}

function download(text) {
  const address = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  h("a", { href: address, download: FILE }).click();
  // The browser reads the address only after this task.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** The section with the form. */
export function assessmentForm(data, selection, assessments) {
  const inputs = FIELDS.map((field) => [field, input(field, assessments)]);
  const subject = h("p", { class: "subject" });
  const state = h("output", { "data-test": "unsaved" });
  const save = h("button", { type: "button", class: "primary", "data-test": "save", onclick: hand }, `Save ${FILE}`);

  function hand() {
    download(assessments.text());
    assessments.saved();
  }

  for (const [field, element] of inputs) {
    element.addEventListener("input", () => assessments.set(selection.id, field.key, element.value));
  }
  selection.follow((id) => {
    const hazard = data.hazard(id);
    subject.replaceChildren(h("b", {}, id), `: ${hazard.robot_link} meets ${region(hazard.body_region)}, ${ratio(hazard.ratio)}`);
    for (const [field, element] of inputs) {
      const value = assessments.of(id)[field.key] ?? "";
      if (element.tagName === "SELECT" && ![...element.options].some((option) => option.value === value) && value) {
        element.append(h("option", { value }, value));
      }
      element.value = value || (field.key === "decision" ? "open" : "");
    }
  });
  const tell = () => {
    const number = assessments.unsaved.size;
    state.textContent = number > 0 ? `Unsaved edits of ${count(number, "hazard")}.` : "";
  };
  assessments.follow(tell);

  return section(
    "assessment",
    "Assessment (ISO 12100)",
    subject,
    h(
      "form",
      { onsubmit: (event) => event.preventDefault() },
      inputs.map(([field, element]) => h("label", { class: field.long ? "long" : null }, h("span", {}, field.label), element)),
    ),
    h("p", { class: "save" }, save, state),
    h(
      "p",
      { class: "note" },
      `Saves the assessments of all hazards, those given to this report included, as one file. Keep ${FILE} beside the cell file, in git: scans read it and never write it. This page itself keeps no edits.`,
    ),
  );
}
