// The replay of the selected hazard: picture and controls for the head of the page, and a section with plots and facts.

import { command, h, section } from "./dom.js";
import { eventsOf } from "./events.js";
import { facts } from "./facts.js";
import { makePlayer } from "./player.js";
import { makePlots } from "./plots.js";
import { legend, makeStage } from "./stage.js";
import { actionAt, makeStrips } from "./strips.js";
import { makeTransport } from "./transport.js";
import { time } from "./words.js";

/** The replay: `picture` belongs beside the card of the cause, `element` is the section with everything else. */
export function makeReplay(data, selection) {
  const { cell, words } = data;
  const title = h("span");
  const stage = makeStage(cell);
  const player = makePlayer();
  const plots = makePlots(player.seek);
  const strips = makeStrips(words, player.seek);
  const instantText = h("p", { class: "instant", "data-test": "instant" });
  const details = h("div", { class: "facts" });
  let shown = false;
  let current = null;
  let hazard = null;

  const transport = makeTransport(player, { look: stage.look, inView: () => shown && current !== null });
  new IntersectionObserver((entries) => (shown = entries.at(-1).isIntersecting)).observe(stage.element);

  function instant(frame) {
    const name = current.actions[actionAt(current.actions, frame)]?.name;
    const reporting = current.sensors.filter((sensor) => sensor.detected[frame] === "1").map((sensor) => sensor.name);
    const { people } = words;
    const parts = [
      `${time(frame * cell.step_s)} of ${time((current.frames - 1) * cell.step_s)}`,
      name ? `${people.who} ${words.actions[name]}`.trim() : "start",
    ];
    if (current.sensors.length > 0) {
      parts.push(reporting.length > 0 ? `${reporting.join(", ")} ${reporting.length > 1 ? people.report : people.reports}` : people.unseen);
    }
    if (frame === current.contact_frame) {
      parts.push(words.hazards[hazard.id].deed);
    }
    return parts.join(" · ");
  }

  player.follow(({ frame }) => {
    if (current) {
      stage.show(frame);
      plots.show(frame);
      strips.show(frame);
      instantText.textContent = instant(frame);
    }
  });

  if (stage.scene) {
    transport.views.append(stage.names);
  } else {
    transport.views.hidden = true;
  }
  const caption = h("p", { class: "shown-hazard" });
  const full = h("div", {}, stage.element, transport.element, instantText, transport.views, stage.scene ? legend(cell) : null);
  const none = h("div", { class: "notice", "data-test": "no-replay" });
  const graphs = h("div", { class: "graphs screen-only" }, plots.element, strips.element);

  function choose({ hazard: id }) {
    hazard = data.hazard(id);
    current = data.replay(id) ?? null;
    const { deed, way, forces } = words.hazards[id];
    title.textContent = `${id}: ${deed}`;
    const worst = data.causeOf(id)?.worst === id;
    caption.replaceChildren(h("b", {}, worst ? "Its worst way" : "One of its ways"), `: ${deed}, ${way} `, h("span", { class: "id" }, id));
    details.replaceChildren(facts(data, hazard));
    full.hidden = current === null;
    graphs.hidden = current === null;
    none.hidden = current !== null;
    if (!current) {
      player.pause();
      const [when, report] = words.commands.report;
      none.replaceChildren(h("p", {}, when), command(`${report}${id}`));
      return;
    }
    const events = eventsOf(current, hazard, words);
    stage.drawFlat(data.topView(id));
    stage.scene?.load(current, hazard);
    transport.load(current, events);
    plots.load(current, events, forces !== undefined);
    strips.load(current, events);
    player.load(current.frames, cell.step_s, current.contact_frame);
    stage.look("overview");
    stage.show(current.contact_frame);
  }

  const element = section("replay", "", h("div", { class: "replay" }, graphs, details));
  element.querySelector("h2").append("How it comes to this ", title);
  return {
    picture: h("div", { class: "picture" }, caption, full, none),
    element,
    // Scene and plots take their sizes from the page, so they begin once they are in it.
    start: () => selection.follow(choose),
  };
}
