// The controls of a replay: play, steps, scrubber, speed, views, and their keys.

import { h } from "./dom.js";
import { time } from "./words.js";

const SPEEDS = [0.1, 0.25, 0.5, 1];
const VIEWS = [
  ["overview", "3/4"],
  ["top", "top"],
  ["front", "front"],
  ["side", "side"],
  ["eye", "person's eye"],
  ["contact", "contact"],
];

const button = (test, text, title, onclick) => h("button", { type: "button", "data-test": test, title, onclick }, text);

/** Whether keys belong to the element that has the focus, as in a form field. */
function takesKeys(element, key) {
  return element.closest("input, select, textarea, [contenteditable]") || (key === " " && element.closest("button, [role=button], summary"));
}

/** The controls of a player; `look` hears of the chosen view; `inView` tells whether the reader sees the replay. */
export function makeTransport(player, { look, inView }) {
  let frames = 1;
  let contact = 0;
  const play = button("play", "▶ Play", "Play or pause (space)", () => player.toggle());
  const scrub = h("input", { type: "range", min: 0, step: 1, "data-test": "scrub", "aria-label": "time", oninput: () => player.seek(Number(scrub.value)) });
  const step = (by) => () => player.seek(player.frame + by);
  const jump = (to) => () => player.seek(to());
  const speed = h(
    "select",
    { "data-test": "speed", onchange: () => player.setSpeed(Number(speed.value)) },
    SPEEDS.map((value) => h("option", { value, selected: value === 0.5 }, `${value}x`)),
  );
  const views = VIEWS.map(([view, text]) => button(`view-${view}`, text, `View: ${text}`, () => look(view)));
  const ticks = h("div", { class: "ticks", "aria-hidden": "true" });
  const chips = h("ol", { class: "events", "data-test": "events", "aria-label": "what happens" });
  const element = h(
    "div",
    { class: "transport screen-only" },
    h("div", { class: "row" }, play, button("back", "◀|", "One frame back (left)", step(-1)), button("forward", "|▶", "One frame on (right)", step(1)), h("div", { class: "scrubber" }, ticks, scrub), button("to-contact", "Contact", "Jump to the contact", jump(() => contact)), h("label", {}, "speed ", speed)),
    chips,
  );
  const viewRow = h("div", { class: "row views screen-only", role: "group", "aria-label": "views" }, views);

  const keys = { " ": () => player.toggle(), ArrowLeft: step(-1), ArrowRight: step(1), Home: jump(() => 0), End: jump(() => frames - 1) };
  document.addEventListener("keydown", (event) => {
    const act = keys[event.key];
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.shiftKey;
    // Out of sight of the replay these keys scroll the page as ever.
    if (act && plain && inView() && !event.defaultPrevented && !takesKeys(event.target, event.key)) {
      event.preventDefault();
      act();
    }
  });
  player.follow(({ frame, playing }) => {
    scrub.value = frame;
    play.textContent = playing ? "❚❚ Pause" : "▶ Play";
  });

  return {
    element,
    views: viewRow,
    load(replay, events) {
      [frames, contact] = [replay.frames, replay.contact_frame];
      scrub.max = frames - 1;
      ticks.replaceChildren(...events.map(({ frame, kind }) => h("i", { class: kind, style: `left:${(100 * frame) / Math.max(frames - 1, 1)}%` })));
      chips.replaceChildren(
        ...events.map(({ frame, kind, text }) => h("li", {}, h("button", { type: "button", class: kind, title: `Go to ${time(frame * replay.step)}`, onclick: () => player.seek(frame) }, h("b", {}, time(frame * replay.step)), ` ${text}`))),
      );
    },
  };
}
