// Where a replay is seen: the scene with the names over it, or the drawing from above where there is no WebGL.

import { drawing, h } from "./dom.js";
import { makeLabels } from "./labels.js";
import { COLOURS, makeScene } from "./scene.js";

/** What the colours mean. */
export function legend({ zones, looks }) {
  const kinds = new Set(zones.map((zone) => zone.kind));
  const items = [
    ["hitting", "link that hits"],
    ["touched", "part that is hit"],
    ["robot", "robot"],
    ["person", "person"],
    ["path", "way of the person"],
    ["obstacle", "obstacle"],
    ...[...kinds].map((kind) => [kind, kind]),
  ];
  const swatch = (key) => h("i", { class: "swatch", style: `background:${COLOURS[key] ?? COLOURS.obstacle}` });
  return h("ul", { class: "legend screen-only" }, items.map(([key, text]) => h("li", {}, swatch(key), text)), h("li", {}, h("i", { class: "swatch ring" }), "contact"), looks.length > 0 ? h("li", {}, "Clear around the robot: the shapes that are judged.") : null, zones.length > 0 ? h("li", {}, "Zones are filled while they report.") : null);
}

/** The stage of the page. */
export function makeStage(cell) {
  const canvas = h("canvas", { "data-test": "scene", "aria-label": "the cell in three dimensions; drag to turn, wheel to zoom" });
  const pointed = h("span", { class: "pointed" });
  const flat = h("div", { class: "flat" });
  const labels = makeLabels();
  const element = h("div", { class: "stage screen-only" }, canvas, labels.element, pointed);
  const names = h("button", { type: "button", "data-test": "names", "aria-pressed": "true", title: "Show or hide the names in the picture", onclick: toggle }, "names");
  let scene = null;

  function toggle() {
    labels.toggle();
    names.setAttribute("aria-pressed", String(labels.on));
    scene?.draw();
  }

  function without() {
    scene = null;
    element.replaceChildren(h("p", { class: "notice", "data-test": "no-webgl" }, "This browser shows no 3-D graphics (WebGL), so here is the contact seen from above; everything else works."), flat);
  }

  // three.js would report on the console what is said on the page here.
  const probe = document.createElement("canvas").getContext("webgl2");
  if (probe) {
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    try {
      scene = makeScene(canvas, cell, labels, (text) => (pointed.textContent = text));
      canvas.addEventListener("webglcontextlost", without);
    } catch {
      without();
    }
  } else {
    without();
  }
  return {
    element,
    /** The button for the names; of use only where there is a scene. */
    names,
    get scene() {
      return scene;
    },
    drawFlat: (markup) => flat.replaceChildren(markup ? drawing(markup) : ""),
    /** Shows a frame; tells tests what is drawn. */
    show(frame) {
      if (scene) {
        scene.show(frame);
        canvas.dataset.drawn = JSON.stringify(scene.drawn);
      }
    },
    look: (view) => scene?.look(view),
  };
}
