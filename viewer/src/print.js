// What is printed in place of the scene: for each hazard with a replay its drawing from above, facts and assessment.

import { FIELDS } from "./assessments.js";
import { definitions, drawing, h } from "./dom.js";
import { facts } from "./facts.js";
import { ratio, region } from "./words.js";

/** The part for paper; it is filled when the page is printed, and empty on the screen. */
export function printPart(data, assessments) {
  const element = h("section", { class: "print-only", id: "print" });
  addEventListener("beforeprint", () => {
    if (element.childElementCount > 0) {
      return;
    }
    element.append(
      h("h2", {}, "Hazards one by one"),
      ...data.replays.map(({ id, top_view: view }) => {
        const hazard = data.hazard(id);
        return h(
          "article",
          {},
          h("h3", {}, `${id}: ${hazard.robot_link} meets ${region(hazard.body_region)}, ${ratio(hazard.ratio)}`),
          view ? drawing(view) : null,
          facts(hazard),
          definitions(FIELDS.map(({ key, label }) => [label.toLowerCase(), assessments.of(id)[key]])),
        );
      }),
    );
  });
  addEventListener("afterprint", () => element.replaceChildren());
  return element;
}
