// Sensors and actions over time, under the plots and on the same axis.

import { h } from "./dom.js";
import { GUTTER_PX, RIGHT_PX } from "./plots.js";
import { action } from "./words.js";

/** Frames from and to (exclusive) in which the sensor reports the person. */
function spans(detected) {
  return [...detected.matchAll(/1+/g)].map((match) => [match.index, match.index + match[0].length]);
}

/** Index of the action that is under way at a frame. */
export function actionAt(actions, frame) {
  return actions.findLastIndex((item) => item.frame <= frame);
}

/** The strips; `seek` hears the frame that was clicked. */
export function makeStrips(seek) {
  const element = h("div", { class: "strips", style: `--gutter:${GUTTER_PX}px; --right:${RIGHT_PX}px`, onclick: click });
  let last = 1;
  let replay = null;
  let parts = [];

  const place = (from, to) => `left:${(100 * from) / last}%;width:${(100 * (Math.min(to, last) - from)) / last}%`;

  function click(event) {
    const track = event.target.closest(".track");
    if (track) {
      const { left, width } = track.getBoundingClientRect();
      seek(((event.clientX - left) / width) * last);
    }
  }

  function strip(label, kind, content) {
    return h("div", { class: `strip ${kind}` }, h("span", { class: "label", title: label }, label), h("div", { class: "track" }, content, h("div", { class: "now" })));
  }

  return {
    element,
    load(next) {
      replay = next;
      last = Math.max(replay.frames - 1, 1);
      const sensors = replay.sensors.map(({ name, detected }) =>
        strip(name, "sensor", spans(detected).map(([from, to]) => h("div", { class: "on", style: place(from, to), title: `${name} reports the person` }))),
      );
      parts = replay.actions.map(({ name, frame }, index) => {
        const [walk, posture = ""] = name.split("/");
        const end = replay.actions[index + 1]?.frame ?? last;
        return h("div", { class: "action", style: place(frame, end), title: action(name) }, h("span", {}, walk), h("span", {}, posture));
      });
      element.replaceChildren(...sensors, strip("actions", "actions", parts));
    },
    show(frame) {
      element.querySelectorAll(".now").forEach((line) => (line.style.left = `${(100 * frame) / last}%`));
      const current = actionAt(replay.actions, frame);
      parts.forEach((part, index) => part.classList.toggle("current", index === current));
    },
  };
}
