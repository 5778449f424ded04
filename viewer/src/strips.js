// Sensors and actions over time, under the plots and on the same axis.

import { h } from "./dom.js";
import { GUTTER_PX, RIGHT_PX } from "./plots.js";

/** Frames from and to (exclusive) in which the sensor reports the person. */
function spans(detected) {
  return [...detected.matchAll(/1+/g)].map((match) => [match.index, match.index + match[0].length]);
}

/** Index of the action that is under way at a frame. */
export function actionAt(actions, frame) {
  return actions.findLastIndex((item) => item.frame <= frame);
}

/** The strips, with the words of the page; `seek` hears the frame that was clicked. */
export function makeStrips(words, seek) {
  const element = h("div", { class: "strips", style: `--gutter:${GUTTER_PX}px; --right:${RIGHT_PX}px`, onclick: click });
  let last = 1;
  let parts = [];

  const lines = (events) => events.map(({ frame, kind, text }) => h("div", { class: `event ${kind}`, style: `left:${(100 * frame) / last}%`, title: text }));
  const place = (from, to) => `left:${(100 * from) / last}%;width:${(100 * (Math.min(to, last) - from)) / last}%`;

  function click(event) {
    const track = event.target.closest(".track");
    if (track) {
      const { left, width } = track.getBoundingClientRect();
      seek(((event.clientX - left) / width) * last);
    }
  }

  function strip(label, kind, content, events) {
    return h("div", { class: `strip ${kind}` }, h("span", { class: "label", title: label }, label), h("div", { class: "track" }, content, lines(events), h("div", { class: "now" })));
  }

  /** Actions from frame to frame, equal ones in a row as one. */
  function runs(actions) {
    const all = [];
    actions.forEach(({ name, frame }, index) => {
      const to = actions[index + 1]?.frame ?? last;
      if (all.at(-1)?.name === name) {
        all.at(-1).to = to;
      } else {
        all.push({ name, from: frame, to });
      }
    });
    return all;
  }

  return {
    element,
    load(next, events) {
      last = Math.max(next.frames - 1, 1);
      const sensors = next.sensors.map(({ name, detected }) =>
        strip(name, "sensor", spans(detected).map(([from, to]) => h("div", { class: "on", style: place(from, to), title: `${name} ${words.people.reports}` })), events),
      );
      parts = runs(next.actions).map(({ name, from, to }) => {
        const text = words.actions[name];
        const [walk, ...rest] = text.split(", ");
        const block = h("div", { class: "action", style: place(from, to), title: text }, h("span", {}, walk), h("span", {}, rest.join(", ")));
        return { from, to, block };
      });
      element.replaceChildren(...sensors, strip(words.people.heading, "actions", parts.map(({ block }) => block), events));
    },
    show(frame) {
      element.querySelectorAll(".now").forEach((line) => (line.style.left = `${(100 * frame) / last}%`));
      parts.forEach(({ from, to, block }) => block.classList.toggle("current", frame >= from && (frame < to || to >= last)));
    },
  };
}
