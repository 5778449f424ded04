// The cell from above with where people stand, or are touched, in bins of 0.1 m.

import { h, section, svg } from "./dom.js";
import { outline } from "./plan.js";
import { count, ratio } from "./words.js";

const BIN_M = 0.1;
const MARGIN_M = 0.4;
/** Zones may reach far beyond what matters; no more than this around hazards and start is drawn. */
const AROUND_M = 2;

const PLACES = { person: (z) => z.person_xy_m, contact: (z) => z.contact_point_m };

/** Hazards by bin: lower corner in bins, and what is in it. */
function binsOf(hazards, place) {
  const bins = new Map();
  for (const hazard of hazards) {
    const [x, y] = place(hazard);
    // Positions on a bin's edge must not fall to either side by rounding.
    const corner = [x, y].map((value) => Math.floor(value / BIN_M + 1e-6));
    const key = corner.join(",");
    const bin = bins.get(key) ?? { corner, hazards: [] };
    bin.hazards.push(hazard);
    bins.set(key, bin);
  }
  return [...bins.values()];
}

function extent({ cell, scan }) {
  const near = [cell.start.xy_m, ...scan.hazards.flatMap((z) => [PLACES.person(z), PLACES.contact(z)])];
  const bounds = (points) => [0, 1].map((axis) => [Math.min(...points.map((p) => p[axis])), Math.max(...points.map((p) => p[axis]))]);
  const centre = bounds(near);
  const all = bounds([...near, ...cell.obstacles.flatMap(outline), ...cell.zones.flatMap((zone) => zone.polygon_m)]);
  return all.map(([low, high], axis) => [Math.max(low, centre[axis][0] - AROUND_M) - MARGIN_M, Math.min(high, centre[axis][1] + AROUND_M) + MARGIN_M]);
}

function radios(name, legend, options, change) {
  const buttons = options.map(([value, text], index) =>
    h("label", {}, h("input", { type: "radio", name, value, checked: index === 0, "data-test": `${name}-${value}`, onchange: () => change(value) }), ` ${text}`),
  );
  return h("fieldset", {}, h("legend", {}, legend), buttons);
}

/** The section with the map; `setBin` hears of the bin that the reader wants in the table. */
export function map(data, selection, setBin) {
  const { cell, scan } = data;
  const [[left, right], [low, high]] = extent(data);
  const at = ([x, y]) => [x - left, high - y].map((value) => value.toFixed(3));
  const points = (polygon) => polygon.map((p) => at(p).join(",")).join(" ");
  let place = "person";
  let colour = "count";

  const bins = svg("g", { class: "bins" });
  const mark = svg("g", { class: "selected-place" });
  const told = h("output", { "data-test": "bin", class: "told screen-only" });
  const hint = "Point at a bin to read it; click it to see only its hazards in the table.";
  const say = (text) => (told.textContent = text || hint);
  say("");

  function drawBins() {
    const all = binsOf(scan.hazards, PLACES[place]);
    const value = ({ hazards }) => (colour === "count" ? hazards.length : Math.max(...hazards.map((z) => z.ratio)));
    const values = all.map(value);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    bins.replaceChildren(
      ...all.map((bin) => {
        const [x, y] = bin.corner.map((index) => index * BIN_M);
        const worst = Math.max(...bin.hazards.map((z) => z.ratio));
        const name = `${place === "person" ? "person at" : "contact at"} ${x.toFixed(1)} to ${(x + BIN_M).toFixed(1)}, ${y.toFixed(1)} to ${(y + BIN_M).toFixed(1)} m`;
        const text = `${name}: ${count(bin.hazards.length, "hazard")}, worst ${ratio(worst)}`;
        const choose = () => {
          setBin({ name, ids: new Set(bin.hazards.map((z) => z.id)) });
          selection.select(bin.hazards.reduce((a, b) => (b.ratio > a.ratio ? b : a)).id);
        };
        const heat = most > least ? (value(bin) - least) / (most - least) : 1;
        const [cx, cy] = at([x, y + BIN_M]);
        return svg("rect", {
          x: cx,
          y: cy,
          width: BIN_M,
          height: BIN_M,
          style: `--heat:${heat.toFixed(3)}`,
          tabindex: 0,
          role: "button",
          "aria-label": text,
          "data-test": "map-bin",
          onmouseenter: () => say(text),
          onfocus: () => say(text),
          onmouseleave: () => say(""),
          onblur: () => say(""),
          onclick: choose,
          onkeydown: (event) => {
            if (event.key === "Enter" || event.key === " ") {
              event.preventDefault();
              event.stopPropagation();
              choose();
            }
          },
        });
      }),
    );
    scale.textContent =
      colour === "count" ? `${count(least, "hazard")} (pale) to ${most} (dark) in a bin` : `worst ratio ${ratio(least)} (pale) to ${ratio(most)} (dark)`;
  }

  const scale = h("span", { class: "note" });
  const obstacles = cell.obstacles.map((o) => svg("polygon", { points: points(outline(o)), class: "obstacle" }, svg("title", {}, o.name)));
  const zones = cell.zones.map((z) => svg(z.polygon_m.length > 2 ? "polygon" : "polyline", { points: points(z.polygon_m), class: `zone ${z.kind}` }, svg("title", {}, `${z.kind} ${z.name}`)));
  const [sx, sy] = at(cell.start.xy_m);
  const start = svg(
    "g",
    { class: "start", transform: `translate(${sx} ${sy}) rotate(${-cell.start.heading_deg})` },
    svg("circle", { r: 0.12 }),
    svg("path", { d: "M 0.12 0 H 0.3 M 0.22 -0.07 L 0.3 0 L 0.22 0.07" }),
    svg("title", {}, "start of the person"),
  );
  const bar = [left + MARGIN_M / 2, low + MARGIN_M / 2];
  const [bx, by] = at(bar).map(Number);
  const ruler = svg("g", { class: "ruler" }, svg("path", { d: `M ${bx} ${by} h 1 m -1 -0.05 v 0.1 m 1 0 v -0.1` }), svg("text", { x: bx + 0.5, y: by - 0.07 }, "1 m"));
  const picture = svg(
    "svg",
    { viewBox: `0 0 ${(right - left).toFixed(3)} ${(high - low).toFixed(3)}`, class: "map", role: "group", "aria-label": "the cell from above", "data-test": "map" },
    zones,
    obstacles,
    bins,
    mark,
    start,
    ruler,
  );

  selection.follow((id) => {
    const hazard = data.hazard(id);
    const [px, py] = at(PLACES.person(hazard));
    const [qx, qy] = at(PLACES.contact(hazard));
    mark.replaceChildren(
      svg("line", { x1: px, y1: py, x2: qx, y2: qy }),
      svg("circle", { cx: px, cy: py, r: 0.09 }, svg("title", {}, `${id}: person`)),
      svg("path", { d: `M ${qx} ${qy} m -0.06 -0.06 l 0.12 0.12 m 0 -0.12 l -0.12 0.12` }, svg("title", {}, `${id}: contact`)),
    );
  });
  drawBins();

  return section(
    "map",
    "Where it happens",
    h(
      "div",
      { class: "filters screen-only" },
      radios("place", "bins of", [["person", "person"], ["contact", "contact"]], (value) => ((place = value), drawBins())),
      radios("colour", "colour", [["count", "number of hazards"], ["ratio", "worst ratio"]], (value) => ((colour = value), drawBins())),
    ),
    picture,
    h("p", { class: "map-line" }, told, " ", scale),
    h("p", { class: "note" }, "Ring: the selected hazard's person; cross: its contact. Arrow: start. Grey: obstacles. Dashed: sensor zones."),
  );
}
