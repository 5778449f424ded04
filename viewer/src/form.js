// The form that assesses the selected cause, or only the selected hazard, and the button that hands out the file.

import { h, section } from "./dom.js";
import { FIELDS, requiredLevel } from "./assessments.js";
import { count } from "./words.js";

const FILE = "assessments.json";

function input(field, { decisions }) {
  const common = { "data-test": `assess-${field.key}`, name: field.key };
  if (field.options) {
    const options = field.key === "decision" ? decisions.map((value) => [value, value]) : field.options;
    const blank = h("option", { value: "" }, "–");
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

/** The section with the form; `show` brings it into sight. */
export function assessmentForm(data, selection, assessments) {
  const inputs = FIELDS.map((field) => [field, input(field, assessments)]);
  const subject = h("p", { class: "subject", "data-test": "assess-subject" });
  const scope = h("input", { type: "checkbox", "data-test": "assess-scope", onchange: fill });
  const scopeText = h("span");
  const level = h("output", { class: "plr", "data-test": "plr" });
  const state = h("output", { "data-test": "unsaved" });
  const save = h("button", { type: "button", class: "primary", "data-test": "save", onclick: hand }, `Save ${FILE}`);
  let cause = null;

  const id = () => (scope.checked ? selection.now.hazard : selection.now.cause);

  function hand() {
    download(assessments.text());
    assessments.saved();
  }

  function tell() {
    const performance = requiredLevel(assessments.of(id()));
    level.textContent = performance ? `PL r: ${performance}` : "PL r: follows from severity, exposure and avoidance";
    const unsaved = assessments.unsaved();
    state.textContent = unsaved ? `Unsaved edits of ${unsaved}.` : "";
    const own = assessments.own(selection.now.hazard);
    scopeText.textContent = ` only this row: ${selection.now.hazard}${own ? ` (decided on its own: ${own})` : ""}`;
  }

  /** Puts what is known of the cause or the hazard into the fields. */
  function fill() {
    const { deed, way } = data.words.hazards[selection.now.hazard];
    const whole = data.cause(selection.now.cause);
    subject.replaceChildren(
      h("b", {}, id()),
      scope.checked
        ? `: only ${deed}, ${way}. What is left empty is as for the cause.`
        : `, for ${whole.hazards.length === 1 ? "its one way" : `all its ${count(whole.hazards.length, "way")}`}: ${whole.sentence}`,
    );
    for (const [field, element] of inputs) {
      const value = assessments.of(id())[field.key] ?? "";
      if (element.tagName === "SELECT" && ![...element.options].some((option) => option.value === value)) {
        element.append(h("option", { value }, value));
      }
      if (field.key === "decision") {
        // A cause is open until somebody decides; a row without a decision has that of its cause.
        element.options[0].hidden = !scope.checked;
        element.options[0].textContent = `as for the cause (${assessments.ofCause(whole.id)})`;
      }
      element.value = value || (field.key === "decision" && !scope.checked ? "open" : "");
    }
    tell();
  }

  for (const [field, element] of inputs) {
    element.addEventListener("input", () => assessments.set(id(), field.key, element.value));
  }
  selection.follow((now) => {
    if (now.cause !== cause) {
      cause = now.cause;
      scope.checked = false;
    }
    fill();
  });
  assessments.follow(tell);

  const element = section(
    "assessment",
    "Assessment (ISO 12100)",
    subject,
    h("label", { class: "scope-switch" }, scope, scopeText),
    h(
      "form",
      { onsubmit: (event) => event.preventDefault() },
      inputs.map(([field, control]) => h("label", { class: field.long ? "long" : null }, h("span", {}, field.label), control)),
    ),
    h("p", { class: "plr-line" }, level, h("span", { class: "note" }, " Required performance level by the risk graph of ISO 13849-1, Annex A.")),
    h("p", { class: "save" }, save, state),
    h(
      "p",
      { class: "note" },
      `Saves the assessments of all causes and rows, those given to this report included, as one file. Keep ${FILE} beside the cell file, in git: scans read it and never write it. This page itself keeps no edits.`,
    ),
  );
  return {
    element,
    show() {
      element.scrollIntoView({ block: "start" });
      inputs[0][1].focus({ preventScroll: true });
    },
  };
}
