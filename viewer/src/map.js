// The cell from above: where people stand, or are touched, in bins of 0.1 m; causes by number; the robot and what it sweeps.

import { badge, colourOf } from "./card.js";
import { h, section, svg } from "./dom.js";
import { outline } from "./plan.js";
import { footprint, swept } from "./sweep.js";
import { count, ratio } from "./words.js";

const BIN_M = 0.1;
const MARGIN_M = 0.4;
/** Zones may reach far beyond what matters; no more than this around hazards and start is drawn. */
const AROUND_M = 1.2;
/** Room for the texts of the axes, left and below. */
const AXIS_M = 0.42;

/** Radius of a cause's number, and where it stands beside its place: above, at the sides, farther off. */
const BADGE_M = 0.1;
const BADGE_PLACES = [0.2, 0.34, 0.48].flatMap((far) => [-90, -45, -135, 0, 180, 45, 135, 90].map((turn) => [far * Math.cos((turn * Math.PI) / 180), far * Math.sin((turn * Math.PI) / 180)]));

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
  const bases = (cell.robots ?? []).flatMap((robot) => (robot.base_m ? [robot.base_m] : []));
  const near = [cell.start.xy_m, ...bases, ...scan.hazards.flatMap((z) => [PLACES.person(z), PLACES.contact(z)])];
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

/** A place for a name: the middle of what of an outline is on the map. */
function middleOf(polygon, bounds) {
  return [0, 1].map((axis) => {
    const [low, high] = bounds[axis].map((value, side) => value + (side === 0 ? 0.3 : -0.3));
    const inside = polygon.map((p) => Math.max(low, Math.min(high, p[axis])));
    return (Math.min(...inside) + Math.max(...inside)) / 2;
  });
}

/** The section with the map; `setBin` hears of the bin that the reader wants in the table. */
export function map(data, selection, setBin) {
  const { cell, scan } = data;
  const bounds = extent(data);
  const [[left, right], [low, high]] = bounds;
  const at = ([x, y]) => [x - left, high - y].map((value) => Number(value.toFixed(3)));
  const points = (polygon) => polygon.map((p) => at(p).join(",")).join(" ");
  const worstOf = (hazards) => hazards.reduce((a, b) => (b.ratio > a.ratio ? b : a));
  let place = "person";
  let colour = "cause";

  const bins = svg("g", { class: "bins" });
  const sweep = svg("path", { class: "sweep" }, svg("title", {}, "where robots are at some time in the replays of this report"));
  const robot = svg("g", { class: "robot" });
  const mark = svg("g", { class: "selected-place" });
  const places = svg("g", { class: "cause-places" });
  const told = h("output", { "data-test": "bin", class: "told screen-only" });
  const hint = "Point at a bin to read it; click it to see only its hazards in the table.";
  const say = (text) => (told.textContent = text || hint);
  say("");

  /** A part of the picture that is chosen by click or key. */
  const button = (element, text, choose) => {
    const attributes = { tabindex: "0", role: "button", "aria-label": text };
    Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
    ["mouseenter", "focus"].forEach((event) => element.addEventListener(event, () => say(text)));
    ["mouseleave", "blur"].forEach((event) => element.addEventListener(event, () => say("")));
    element.addEventListener("click", choose);
    element.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        event.stopPropagation();
        choose();
      }
    });
    return element;
  };

  function drawBins() {
    const all = binsOf(scan.hazards, PLACES[place]);
    const value = ({ hazards }) => (colour === "count" ? hazards.length : Math.max(...hazards.map((hazard) => hazard.ratio)));
    const values = all.map(value);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    bins.replaceChildren(
      ...all.map((bin) => {
        const [x, y] = bin.corner.map((index) => index * BIN_M);
        const worst = worstOf(bin.hazards);
        const name = `${place === "person" ? "person at" : "contact at"} ${x.toFixed(1)} to ${(x + BIN_M).toFixed(1)}, ${y.toFixed(1)} to ${(y + BIN_M).toFixed(1)} m`;
        const text = `${name}: ${count(bin.hazards.length, "hazard")}, worst ${ratio(worst.ratio)}, cause ${data.causeOf(worst.id).number}`;
        const choose = () => {
          setBin({ name, ids: new Set(bin.hazards.map((z) => z.id)) });
          selection.select(worst.id);
        };
        const heat = most > least ? (value(bin) - least) / (most - least) : 1;
        const [cx, cy] = at([x, y + BIN_M]);
        const style = colour === "cause" ? `fill:${colourOf(data.causeOf(worst.id))}` : `--heat:${heat.toFixed(3)}`;
        return button(svg("rect", { x: cx, y: cy, width: BIN_M, height: BIN_M, style, "data-test": "map-bin" }), text, choose);
      }),
    );
    scale.textContent =
      colour === "cause"
        ? "Each bin has the colour of its worst cause."
        : colour === "count"
          ? `${count(least, "hazard")} (pale) to ${most} (dark) in a bin`
          : `worst ratio ${ratio(least)} (pale) to ${ratio(most)} (dark)`;
    drawPlaces();
  }

  /** The numbers of the causes, near to where the worst hazard of each is, and none over another. */
  function drawPlaces() {
    const taken = [];
    places.replaceChildren(
      ...data.causes.map((cause) => {
        const [x, y] = at(PLACES[place](data.hazard(cause.worst)));
        const free = ([u, v]) => taken.every(([s, t]) => Math.hypot(u - s, v - t) > 2.2 * BADGE_M);
        const around = BADGE_PLACES.map(([u, v]) => [x + u, y + v]);
        const [bx, by] = around.find(free) ?? around[0];
        taken.push([bx, by]);
        const group = svg(
          "g",
          { class: "cause-place", "data-test": "place-cause", "data-id": cause.id, transform: `translate(${bx.toFixed(3)} ${by.toFixed(3)})`, style: `--cause:${colourOf(cause)}` },
          svg("line", { x2: (x - bx).toFixed(3), y2: (y - by).toFixed(3) }),
          svg("circle", { r: BADGE_M }),
          svg("text", { y: 0.045 }, String(cause.number)),
        );
        return button(group, `cause ${cause.number}: ${cause.sentence}`, () => selection.select(cause.id));
      }),
    );
  }

  const scale = h("span", { class: "note" });
  const inView = ([x, y]) => x > left && x < right && y > low && y < high;
  const label = (text, [x, y], kind) => {
    const [px, py] = at([x, y]);
    return svg("text", { x: px, y: py, class: `name ${kind}` }, text);
  };
  // What the programme moves is in the replay alone.
  const still = cell.obstacles.filter((o) => !o.follows);
  const obstacles = still.map((o) => svg("polygon", { points: points(outline(o)), class: "obstacle" }, svg("title", {}, o.name)));
  const zones = cell.zones.map((z) => svg(z.polygon_m.length > 2 ? "polygon" : "polyline", { points: points(z.polygon_m), class: `zone ${z.kind}` }, svg("title", {}, z.title)));
  /** Names of zones stand at their lower left corner: in the middle are the bins. */
  const names = [
    ...still.map((o) => label(o.name, middleOf(outline(o), bounds), "obstacle-name")),
    ...cell.zones.map((z) => {
      const [from, edge] = [0, 1].map((axis) => Math.max(bounds[axis][0] + 0.05, Math.min(...z.polygon_m.map((p) => p[axis]))));
      return label(z.title, [from + 0.05, edge + 0.05], `zone-name ${z.kind}`);
    }),
  ];
  const [sx, sy] = at(cell.start.xy_m);
  const start = svg(
    "g",
    { class: "start", transform: `translate(${sx} ${sy}) rotate(${-cell.start.heading_deg})` },
    svg("circle", { r: 0.12 }),
    svg("path", { d: "M 0.12 0 H 0.3 M 0.22 -0.07 L 0.3 0 L 0.22 0.07" }),
    svg("title", {}, "start of the person"),
  );
  const size = [right - left, high - low];
  const whole = ([from, to]) => Array.from({ length: Math.floor(to) - Math.ceil(from) + 1 }, (_, index) => Math.ceil(from) + index);
  const ruler = svg(
    "g",
    { class: "ruler" },
    svg("path", { d: `M 0 0 V ${size[1].toFixed(3)} H ${size[0].toFixed(3)}` }),
    whole([bounds[0][0] + 0.2, bounds[0][1] - 0.15]).map((x) => [svg("path", { d: `M ${(x - left).toFixed(3)} ${size[1].toFixed(3)} v 0.05` }), svg("text", { x: (x - left).toFixed(3), y: (size[1] + 0.19).toFixed(3) }, `${x} m`)]).flat(),
    whole([bounds[1][0] + 0.1, bounds[1][1] - 0.1]).map((y) => [svg("path", { d: `M 0 ${(high - y).toFixed(3)} h -0.05` }), svg("text", { x: -0.08, y: (high - y + 0.04).toFixed(3), class: "left" }, `${y} m`)]).flat(),
    svg("text", { x: -0.1, y: (size[1] + 0.19).toFixed(3), class: "left" }, "x, y"),
  );
  const clip = svg("clipPath", { id: "map-frame" }, svg("rect", { width: size[0].toFixed(3), height: size[1].toFixed(3) }));
  const picture = svg(
    "svg",
    {
      viewBox: `${-AXIS_M} 0 ${(size[0] + AXIS_M).toFixed(3)} ${(size[1] + 0.26).toFixed(3)}`,
      class: "map",
      role: "group",
      "aria-label": "map of the cell",
      "data-test": "map",
    },
    svg("defs", {}, clip),
    svg("g", { "clip-path": "url(#map-frame)" }, sweep, zones, obstacles, robot, bins, mark, start),
    names.filter((_, index) => inView(middleOf(index < still.length ? outline(still[index]) : cell.zones[index - still.length].polygon_m, bounds))),
    places,
    ruler,
  );

  function drawRobot(replay, hitting) {
    const shapes = cell.links.map((link, index) => {
      const { polygon, radius } = footprint(replay, cell, replay.contact_frame, index);
      const kind = link.name === hitting || `${link.robot}/${link.name}` === hitting ? "hitting" : null;
      const drawn = polygon.map(at);
      if (radius === 0) {
        return svg("polygon", { points: points(polygon), class: kind });
      }
      const [[x1, y1], [x2, y2]] = drawn;
      // A line of no length shows no round ends everywhere; a hair's breadth does.
      return svg("line", { x1, y1, x2: x1 === x2 && y1 === y2 ? x2 + 0.001 : x2, y2, "stroke-width": 2 * radius, class: kind });
    });
    robot.replaceChildren(...shapes, svg("title", {}, "robot at the contact of the selected hazard"));
  }

  let sweeping = false;
  /** The swept area takes every replay: it is worked out when the reader comes here. */
  function drawSweep() {
    if (!sweeping) {
      sweeping = true;
      const replays = data.replays.map(({ id }) => data.replay(id));
      const path = swept(replays, cell, bounds).map(({ x, y, width, height }) => `M${(x - left).toFixed(3)} ${(high - y).toFixed(3)}h${width.toFixed(3)}v${(-height).toFixed(3)}h${(-width).toFixed(3)}z`);
      sweep.setAttribute("d", path.join(""));
    }
  }
  new IntersectionObserver((entries) => entries.some((entry) => entry.isIntersecting) && drawSweep(), { rootMargin: "400px" }).observe(picture);

  selection.follow(({ hazard: id, cause }) => {
    const hazard = data.hazard(id);
    const [px, py] = at(PLACES.person(hazard));
    const [qx, qy] = at(PLACES.contact(hazard));
    mark.replaceChildren(
      svg("line", { x1: px, y1: py, x2: qx, y2: qy }),
      svg("circle", { cx: px, cy: py, r: 0.09 }, svg("title", {}, `${id}: person`)),
      svg("path", { d: `M ${qx} ${qy} m -0.06 -0.06 l 0.12 0.12 m 0 -0.12 l -0.12 0.12` }, svg("title", {}, `${id}: contact`)),
    );
    const replay = data.replay(id) ?? data.replay(data.cause(cause).worst) ?? data.replay(data.replays[0]?.id);
    replay ? drawRobot(replay, hazard.robot_link) : robot.replaceChildren();
  });
  drawBins();

  const key = data.causes.slice(0, 8).map((cause) => h("li", {}, badge(cause), ` ${cause.sentence}`));
  return section(
    "map",
    "Where it happens",
    h(
      "div",
      { class: "filters screen-only" },
      radios("place", "bins of", [["person", "person"], ["contact", "contact"]], (value) => ((place = value), drawBins())),
      radios("colour", "colour", [["cause", "cause"], ["count", "number of hazards"], ["ratio", "worst ratio"]], (value) => ((colour = value), drawBins())),
    ),
    picture,
    h("p", { class: "map-line" }, told, " ", scale),
    h("ul", { class: "map-key" }, key),
    h("p", { class: "note" }, "Ring: the selected hazard's person; cross: its contact. Arrow: start. Blue: robot at that contact, and pale where robots go in the replays. Grey: obstacles. Dashed: sensor zones. Numbers: worst way of each cause."),
  );
}
