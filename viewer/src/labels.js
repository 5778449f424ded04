// Names over the scene: texts that follow points of it, kept apart from each other, and switched off by a button.

import { Vector3 } from "three";
import { h } from "./dom.js";

const GAP_PX = 3;
/** How far a name stands from its point where it is not above it. */
const AWAY_PX = 18;
/** Half the side of the squares in the picture that stay free of names: contact and person. */
const FREE_PX = 13;

/** Labels over a picture. */
export function makeLabels() {
  const element = h("div", { class: "labels", "aria-hidden": "true", "data-test": "labels" });
  let items = [];
  let on = true;

  const overlaps = (a, b) => a.left < b.right + GAP_PX && b.left < a.right + GAP_PX && a.top < b.bottom + GAP_PX && b.top < a.bottom + GAP_PX;

  function place({ camera, width, height, free }) {
    const pixel = new Vector3();
    const at = (point) => {
      pixel.set(...point).project(camera);
      return [((pixel.x + 1) / 2) * width, ((1 - pixel.y) / 2) * height];
    };
    const taken = free.map(at).map(([x, y]) => ({ left: x - FREE_PX, right: x + FREE_PX, top: y - FREE_PX, bottom: y + FREE_PX }));
    for (const item of items) {
      const { label, anchors, kind } = item;
      if (!item.size?.[0]) {
        item.size = [label.offsetWidth, label.offsetHeight];
      }
      const [w, t] = item.size;
      const boxes = anchors().flatMap((point) => {
        const [x, y] = at(point);
        const seen = pixel.z < 1;
        // Above its point, below it or beside it, so that it does not hide what it names.
        const places = kind === "tick" ? [[-w / 2, -t / 2]] : [[-w / 2, -t - 6], [-w / 2, AWAY_PX], [AWAY_PX, -t / 2], [-w - AWAY_PX, -t / 2]];
        return places.map(([right, down]) => ({ left: x + right, right: x + right + w, top: y + down, bottom: y + down + t, seen }));
      });
      const fits = boxes.find((box) => box.seen && box.left >= 2 && box.right <= width - 2 && box.top >= 2 && box.bottom <= height - 2 && !taken.some((other) => overlaps(box, other)));
      label.style.visibility = fits ? "visible" : "hidden";
      if (fits) {
        taken.push(fits);
        label.style.transform = `translate(${fits.left.toFixed(1)}px, ${fits.top.toFixed(1)}px)`;
      }
    }
  }

  return {
    element,
    get on() {
      return on;
    },
    toggle() {
      on = !on;
      element.hidden = !on;
    },
    /** Other names, the most important first: text, kind, and where each may stand. */
    set(list) {
      items = list.map(({ text, kind, colour, anchors }) => ({ kind, anchors, label: h("span", { class: `tag ${kind}`, style: colour ? `border-color:${colour}` : null }, text) }));
      element.replaceChildren(...items.map(({ label }) => label));
    },
    /** Moves all to where their points are seen now, and none over the points that stay `free`. */
    place: (view) => on && place(view),
  };
}
