// The replay of the selected hazard: scene, controls, plots, strips, the instant in words, and the facts.

import { command, drawing, h, section } from "./dom.js";
import { facts } from "./facts.js";
import { makePlayer } from "./player.js";
import { makePlots } from "./plots.js";
import { COLOURS, makeScene } from "./scene.js";
import { actionAt, makeStrips } from "./strips.js";
import { makeTransport } from "./transport.js";
import * as words from "./words.js";

function legend({ zones }) {
  const kinds = new Set(zones.map((zone) => zone.kind));
  const items = [
    ["robot", "robot"],
    ["hitting", "hitting link"],
    ["person", "person"],
    ["touched", "touched part"],
    ["path", "way of the person"],
    ["obstacle", "obstacle"],
    ...[...kinds].map((kind) => [kind, `${kind} (filled: reports)`]),
  ];
  const swatch = (key) => h("i", { class: "swatch", style: `background:${COLOURS[key] ?? COLOURS.obstacle}` });
  return h("ul", { class: "legend" }, items.map(([key, text]) => h("li", {}, swatch(key), text)), h("li", {}, h("i", { class: "swatch ring" }), "contact point"));
}

/** The scene in its frame, or a notice and a place for the drawing where there is no WebGL. */
function makeStage(cell) {
  const canvas = h("canvas", { "data-test": "scene", "aria-label": "the cell in three dimensions; drag to turn, wheel to zoom" });
  const name = h("span", { class: "pointed" });
  const flat = h("div", { class: "flat" });
  const stage = h("div", { class: "stage screen-only" }, canvas, name);
  let scene = null;

  function without() {
    scene = null;
    stage.replaceChildren(h("p", { class: "notice", "data-test": "no-webgl" }, "This browser shows no 3-D graphics (WebGL), so here is the contact seen from above; everything else works."), flat);
  }

  // three.js would report on the console what is said on the page here.
  const probe = document.createElement("canvas").getContext("webgl2");
  if (probe) {
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    try {
      scene = makeScene(canvas, cell, (text) => (name.textContent = text));
      canvas.addEventListener("webglcontextlost", without);
    } catch {
      without();
    }
  } else {
    without();
  }
  return {
    element: stage,
    get scene() {
      return scene;
    },
    drawFlat: (markup) => flat.replaceChildren(markup ? drawing(markup) : ""),
  };
}

/** The section with the replay. */
export function replaySection(data, selection) {
  const { cell } = data;
  const title = h("span");
  const stage = makeStage(cell);
  const player = makePlayer();
  const plots = makePlots(player.seek);
  const strips = makeStrips(player.seek);
  const instantText = h("p", { class: "instant", "data-test": "instant" });
  const panel = h("div");
  const details = h("div", { class: "facts" });
  let shown = false;
  let current = null;
  let hazard = null;

  const transport = makeTransport(player, {
    look: (view) => stage.scene?.look(view),
    inView: () => shown && current !== null,
  });
  new IntersectionObserver((entries) => (shown = entries.at(-1).isIntersecting)).observe(stage.element);

  function instant(frame) {
    const name = current.actions[actionAt(current.actions, frame)]?.name;
    const reporting = current.sensors.filter((sensor) => sensor.detected[frame] === "1").map((sensor) => sensor.name);
    const parts = [
      `${words.time(frame * cell.step_s)} of ${words.time((current.frames - 1) * cell.step_s)} (frame ${frame})`,
      name ? `the person ${words.action(name)}` : "start",
    ];
    if (current.sensors.length > 0) {
      parts.push(reporting.length > 0 ? `${reporting.join(", ")} ${reporting.length > 1 ? "report" : "reports"} the person` : "no sensor reports the person");
    }
    if (frame === current.contact_frame) {
      parts.push(`contact: ${hazard.robot_link} meets ${words.region(hazard.body_region)}`);
    }
    return parts.join(" · ");
  }

  player.follow(({ frame }) => {
    if (current) {
      stage.scene?.show(frame);
      plots.show(frame);
      strips.show(frame);
      instantText.textContent = instant(frame);
    }
  });

  const full = h(
    "div",
    { class: "replay" },
    h("div", { class: "left" }, stage.element, transport.views, legend(cell)),
    h("div", { class: "right screen-only" }, transport.element, instantText, plots.element, strips.element),
  );
  const none = h("div", { class: "notice", "data-test": "no-replay" });
  panel.append(full, none);

  function choose(id) {
    hazard = data.hazard(id);
    current = data.replay(id) ?? null;
    title.textContent = `${id}: ${hazard.robot_link} meets ${words.region(hazard.body_region)}`;
    details.replaceChildren(facts(hazard));
    full.hidden = current === null;
    none.hidden = current !== null;
    if (!current) {
      player.pause();
      none.replaceChildren(h("p", {}, "This report carries the replays of the worst hazards only, not of this one. To get it:"), command(`fmi-hazard replay scan.json ${id}`));
      return;
    }
    stage.drawFlat(data.topView(id));
    stage.scene?.load(current, hazard);
    transport.load(current);
    plots.load(current);
    strips.load(current);
    player.load(current.frames, cell.step_s, current.contact_frame);
    stage.scene?.look("overview");
  }

  const element = section("replay", "", panel, details);
  element.querySelector("h2").append("Replay ", title);
  // Scene and plots take their sizes from the page, so they begin once they are in it.
  return { element, start: () => selection.follow(choose) };
}
