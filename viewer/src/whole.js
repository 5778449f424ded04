// The whole floor from above, for people who come from anywhere: where they are hit, how hard, how early and when, and of what
// nothing is known.

import { h, section, svg } from "./dom.js";
import { outline } from "./plan.js";
import { count, ratio, time } from "./words.js";

const MARGIN_M = 0.35;
/** Zones and floor may reach far beyond what matters: no more than this around the rest is drawn. */
const AROUND_M = 1.0;
/** Places that get a number. */
const NUMBERED = 6;
/** Widths of the picture that a letter is high; on a phone and on others. */
const LETTER = { narrow: 0.034, wide: 0.021 };
const NARROW = "(max-width: 640px)";
/** Edges of a square of the floor in which only who walks in is hit. */
const SMALL = 0.6;
/** Up to so many times the limit each class reaches; pale to dark, told apart in grey as well. */
const HARD = [
  { below: 1, text: "head or throat touched: no contact is allowed", colour: "#fff3b8" },
  { below: 1.25, text: "hit with up to 1.25 times the limit", colour: "#fed06b" },
  { below: 1.5, text: "1.25 to 1.5 times", colour: "#fd8d3c" },
  { below: 2, text: "1.5 to 2 times", colour: "#d7261e" },
  { below: Infinity, text: "twice the limit and more", colour: "#7a0024" },
];
const NOT_LOOKED_AT = "not looked at to the end";
/** Without it nothing is known of where people can stand. */
const isGroundKnown = ({ ground }) => ground.unseen_m.length + ground.watched_m.length > 0;
/** Early to late. */
const EARLY = ["#440154", "#3b528b", "#21918c", "#5ec962", "#d8e219"];

const hardness = (times) => HARD.find(({ below }) => times < below);
const area = (squares, edge) => `${(squares * edge * edge).toFixed(squares * edge * edge < 0.095 ? 2 : 1)} m²`;
/** No place is at minus zero. */
const metres = (value) => (Math.round(100 * value) / 100 + 0).toFixed(2);
const place = ([x, y]) => `${metres(x)}, ${metres(y)} m`;
const moment = (from, span) => `${time(from * span)} to ${time((from + 1) * span)}`;

/** Classes of the earliest moments: text and colour, and which one a moment is in. */
function earliness(floor) {
  const all = floor.map((square) => square.earliest_s);
  const [first, last] = [Math.min(...all), Math.max(...all)];
  const number = last - first < 1e-9 ? 1 : EARLY.length;
  const edge = (index) => first + ((last - first) * index) / number;
  const classes = Array.from({ length: number }, (_, index) => ({ text: number === 1 ? time(first) : `${time(edge(index))} to ${time(edge(index + 1))}`, colour: EARLY[index] }));
  const of = (at) => classes[Math.max(0, Math.min(number - 1, Math.floor((number * (at - first)) / (last - first || 1))))];
  return { classes, of };
}

/** What has to be in the picture, and what may be as far as there is room. */
function extent({ cell, whole }) {
  const bases = (cell.robots ?? []).flatMap((robot) => (robot.base_m ? [robot.base_m] : []));
  const corners = (rectangles) => rectangles.flatMap(([left, low, right, high]) => [[left, low], [right, high]]);
  const needed = [...whole.floor.map(({ xy_m }) => xy_m), ...whole.open_m, ...bases, ...corners(whole.ground.swept_m), ...whole.places.slice(0, NUMBERED).flatMap((hit) => [hit.xy_m, hit.start_m])];
  const wished = [...needed, ...cell.obstacles.flatMap(outline), ...cell.zones.flatMap((zone) => zone.polygon_m)];
  const bounds = (points) => [0, 1].map((axis) => points.reduce(([low, high], p) => [Math.min(low, p[axis]), Math.max(high, p[axis])], [Infinity, -Infinity]));
  const [inner, outer] = [needed.length > 0 ? needed : [cell.start.xy_m], wished.length > 0 ? wished : [cell.start.xy_m]].map(bounds);
  return inner.map(([low, high], axis) => [Math.max(outer[axis][0], low - AROUND_M) - MARGIN_M, Math.min(outer[axis][1], high + AROUND_M) + MARGIN_M]);
}

/** A place for a name: the middle of what of an outline is in the picture; null if nothing is. */
function middleOf(polygon, bounds) {
  const spans = bounds.map(([low, high], axis) => [Math.max(low, Math.min(...polygon.map((p) => p[axis]))), Math.min(high, Math.max(...polygon.map((p) => p[axis])))]);
  return spans.every(([low, high]) => low <= high) ? spans.map(([low, high]) => (low + high) / 2) : null;
}

/** The picture; `key` tells its patterns from those of another one in the page. */
function drawn(data, key) {
  const { cell, whole, words } = data;
  const edge = whole.cell_m;
  const bounds = extent(data);
  const [[left, right], [low, high]] = bounds;
  const size = [right - left, high - low];
  const letter = LETTER[matchMedia(NARROW).matches ? "narrow" : "wide"] * Math.max(size[0], 0.8 * size[1], 2);
  const number = (value) => Number(value.toFixed(3));
  const at = ([x, y]) => [number(x - left), number(high - y)];
  const points = (polygon) => polygon.map((p) => at(p).join(",")).join(" ");
  const boxes = (rectangles) => rectangles.map(([a, b, c, d]) => `M${at([a, d]).join(" ")}h${number(c - a)}v${number(d - b)}h${number(a - c)}z`).join("");
  const squareAt = ([x, y], attributes, side = edge) => {
    const [px, py] = at([x - side / 2, y + side / 2]);
    return svg("rect", { x: px, y: py, width: number(side), height: number(side), ...attributes });
  };
  const label = (text, [x, y], kind) => {
    const [px, py] = at([x, y]);
    return svg("text", { x: px, y: py, class: `name ${kind}`, "font-size": number(letter) }, text);
  };
  const hits = whole.floor.map((square) => squareAt(square.xy_m, { class: "hit", "data-test": "whole-square" }, square.unseen ? edge : SMALL * edge));
  const cursor = squareAt([0, 0], { class: "cursor", visibility: "hidden" });

  const numbered = whole.places.slice(0, NUMBERED);
  const taken = numbered.map((hit) => at(hit.xy_m));
  const radius = 0.85 * letter;
  /** Beside what it marks, and not over another. */
  const beside = ([x, y]) => {
    const around = [2.6, 4, 5.8, 8].flatMap((far) => Array.from({ length: 12 }, (_, turn) => [x + far * letter * Math.cos(turn / 1.91), y - far * letter * Math.sin(turn / 1.91)]));
    const free = ([u, v]) => u > radius && v > radius && u < size[0] - radius && v < size[1] - radius && taken.every(([s, t]) => Math.hypot(u - s, v - t) > 2.3 * radius);
    const found = around.find(free) ?? [x, y];
    taken.push(found);
    return found;
  };
  const marks = numbered.map((hit, index) => {
    const [x, y] = at(hit.xy_m);
    const [sx, sy] = at(hit.start_m);
    const [bx, by] = beside([x, y]);
    const way = hit.walks_in ? [svg("path", { class: "way", d: `M${sx} ${sy}L${x} ${y}` }), svg("circle", { class: "from", cx: sx, cy: sy, r: number(0.4 * letter) })] : [];
    return svg(
      "g",
      { class: "hit-place", "data-test": "whole-place" },
      ...way,
      svg("path", { class: "lead", d: `M${number(bx)} ${number(by)}L${x} ${y}` }),
      svg("circle", { class: "at", cx: x, cy: y, r: number(0.25 * letter) }),
      svg("circle", { class: "disc", cx: number(bx), cy: number(by), r: number(radius) }),
      svg("text", { x: number(bx), y: number(by + 0.37 * letter), "font-size": number(letter) }, String(index + 1)),
      svg("title", {}, placeText(hit, words)),
    );
  });

  const bases = (cell.robots ?? []).filter((robot) => robot.base_m).map((robot) => {
    const [x, y] = at(robot.base_m);
    const arm = number(0.9 * letter);
    return svg("g", { class: "base" }, svg("circle", { cx: x, cy: y, r: number(0.6 * letter) }), svg("path", { d: `M${x - arm} ${y}h${2 * arm}M${x} ${y - arm}v${2 * arm}` }), label(robot.name, [robot.base_m[0], robot.base_m[1] + 1.3 * letter], "base-name"));
  });
  const obstacles = cell.obstacles.map((o) => svg("polygon", { points: points(outline(o)), class: "obstacle" }, svg("title", {}, o.name)));
  const zones = cell.zones.map((z) => svg(z.polygon_m.length > 2 ? "polygon" : "polyline", { points: points(z.polygon_m), class: `zone ${z.kind}` }, svg("title", {}, z.title)));
  const names = cell.zones.flatMap((z) => {
    const corner = middleOf(z.polygon_m, bounds) && [0, 1].map((axis) => Math.max(bounds[axis][0], Math.min(...z.polygon_m.map((p) => p[axis]))) + 0.4 * letter);
    return corner ? [label(z.title, corner, "zone-name")] : [];
  });
  const wholes = ([from, to]) => Array.from({ length: Math.max(0, Math.floor(to) - Math.ceil(from) + 1) }, (_, index) => Math.ceil(from) + index);
  const tick = number(0.5 * letter);
  const ruler = [
    svg("path", { d: `M0 0V${number(size[1])}H${number(size[0])}` }),
    ...wholes(bounds[0]).flatMap((x) => [svg("path", { d: `M${number(x - left)} ${number(size[1])}v${tick}` }), svg("text", { x: number(x - left), y: number(size[1] + 1.6 * letter), "font-size": number(letter) }, `${x} m`)]),
    ...wholes(bounds[1]).flatMap((y) => [svg("path", { d: `M0 ${number(high - y)}h${-tick}` }), svg("text", { x: number(-0.8 * letter), y: number(high - y + 0.35 * letter), class: "left", "font-size": number(letter) }, `${y} m`)]),
  ];
  const [bx, by] = [number(size[0] - 1 - letter), number(size[1] - 1.2 * letter)];
  const bar = [svg("path", { d: `M${bx} ${number(by - 0.4 * letter)}v${number(0.4 * letter)}h1v${number(-0.4 * letter)}` }), svg("text", { x: bx + 0.5, y: number(by - 0.5 * letter), "font-size": number(letter) }, "1 m")];
  const frame = { width: number(size[0]), height: number(size[1]) };
  const stripes = svg("pattern", { id: `${key}-unknown`, width: 0.05, height: 0.05, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" }, svg("rect", { width: 0.05, height: 0.05, class: "blank" }), svg("rect", { width: 0.02, height: 0.05, class: "stripe" }));
  // Paler, and the other way, than what was looked at and is not known.
  const lines = svg("pattern", { id: `${key}-unlooked`, width: 0.08, height: 0.08, patternUnits: "userSpaceOnUse", patternTransform: "rotate(-45)" }, svg("rect", { width: 0.08, height: 0.08, class: "blank" }), svg("rect", { width: 0.01, height: 0.08, class: "stripe" }));
  const unlooked = { style: `fill:url(#${key}-unlooked)`, "data-test": "whole-unlooked" };
  const open = svg("g", { class: "open", style: `fill:url(#${key}-unknown)` }, ...whole.open_m.map((middle) => squareAt(middle, {})));
  const element = svg(
    "svg",
    {
      viewBox: [-4.2 * letter, -0.3 * letter, size[0] + 6 * letter, size[1] + 2.6 * letter].map(number).join(" "),
      class: "whole-map",
      role: "img",
      "aria-label": "the floor from above",
      "data-test": "whole-map",
    },
    svg("defs", {}, stripes, lines, svg("clipPath", { id: `${key}-frame` }, svg("rect", frame))),
    svg(
      "g",
      { "clip-path": `url(#${key}-frame)` },
      svg("rect", isGroundKnown(whole) ? { ...frame, class: "nowhere" } : { ...frame, ...unlooked }),
      svg("path", { d: boxes(whole.ground.unseen_m), class: "unseen" }),
      svg("path", { d: boxes(whole.ground.watched_m), class: "watched" }),
      whole.not_looked_at_m.length > 0 ? svg("path", { d: boxes(whole.not_looked_at_m), ...unlooked }) : null,
      svg("path", { d: boxes(whole.ground.swept_m), class: "swept" }),
      open,
      svg("g", { class: "hits" }, ...hits),
      zones,
      obstacles,
      bases,
      names,
      cursor,
      svg("g", { class: "scale-bar" }, ...bar),
    ),
    ...marks,
    svg("g", { class: "whole-ruler" }, ...ruler),
  );
  /** Colours every square by what `of` answers for it: a colour, or null for one that is hit at other moments alone. */
  const colour = (of) => hits.forEach((rect, index) => {
    const fill = of(whole.floor[index]);
    rect.setAttribute("style", fill === null ? "" : `fill:${fill}`);
    rect.classList.toggle("else", fill === null);
  });
  const point = (xy) => {
    cursor.setAttribute("visibility", xy ? "visible" : "hidden");
    if (xy) {
      const [x, y] = at([xy[0] - edge / 2, xy[1] + edge / 2]);
      cursor.setAttribute("x", x);
      cursor.setAttribute("y", y);
    }
  };
  /** The point of the floor under the pointer. */
  const under = (event) => {
    const matrix = element.getScreenCTM()?.inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [x + left, high - y];
  };
  return { element, colour, point, under, bounds };
}

/** One way to be hit, in words. */
function placeText(hit, words) {
  // Nothing below 1 is a hit but of what may not be touched at all.
  const hard = hit.ratio < 1 ? `${words.not_allowed} (${ratio(hit.ratio)})` : ratio(hit.ratio);
  const when = typeof hit.time_s === "number" ? ` after ${time(hit.time_s)}` : "";
  const how = hit.walks_in ? `walks from ${place(hit.start_m)} to ${place(hit.xy_m)}` : `stands at ${place(hit.xy_m)}`;
  return `${hard}: ${words.regions[hit.body_region]} hit by ${hit.robot_link}${when}; ${how}, ${hit.posture}${hit.confirmed ? "" : "; not confirmed"}`;
}

const swatch = (style, text) => h("li", {}, h("span", { class: "surface", style }), h("span", {}, text));
const kind = (name, text) => h("li", {}, h("span", { class: `surface ${name}` }), h("span", {}, text));

/** What surfaces mean, whatever squares are coloured by. */
function surfaces({ whole, cell }) {
  return [
    whole.floor.every(({ unseen }) => unseen) ? null : kind("small", "small: only who walks in, if they get there in time"),
    whole.open_m.length > 0 ? kind("unknown", "not known whether anybody is hit there") : null,
    whole.looked_at ? kind("unseen", "people come here unseen; no hit found") : kind("unlooked", NOT_LOOKED_AT),
    whole.looked_at && whole.ground.watched_m.length > 0 ? kind("watched", "sensors see people here, or on the way here; no hit found") : null,
    isGroundKnown(whole) ? kind("nowhere", "nobody can stand here, or gets here") : null,
    whole.ground.swept_m.length > 0 ? kind("swept", "below what the robots sweep") : null,
    cell.obstacles.length > 0 ? kind("obstacle", "obstacle") : null,
    cell.zones.length > 0 ? kind("zone", "where sensors see") : null,
  ].filter(Boolean);
}

const TRIED = "Colours tell the worst that was tried in each square; it may be worse.";
const MOMENTS = "A moment shows who is hit then of those who are hit at some moment. Others may be hit then where no colour is.";

/** The picture for paper, with its legend. */
export function wholePage(data) {
  const { whole, words } = data;
  const picture = drawn(data, "whole-paper");
  picture.colour((square) => hardness(square.ratio).colour);
  return h(
    "article",
    { "data-test": "print-whole", class: "whole-page" },
    h("h2", {}, "The floor"),
    h("p", {}, whole.said),
    picture.element,
    h("ul", { class: "whole-key" }, hardClasses(whole).map(({ text, colour }) => swatch(`background:${colour}`, text)), surfaces(data)),
    h("p", { class: "note" }, TRIED),
    h("ol", { class: "whole-places" }, whole.places.slice(0, NUMBERED).map((hit) => h("li", {}, placeText(hit, words)))),
  );
}

/** The lowest class stands in the legend only if a square is in it. */
const hardClasses = ({ floor }) => HARD.filter(({ below }) => below > 1 || floor.some((square) => square.ratio < 1));

/** The section with the floor. */
export function wholeSection(data) {
  const { whole, words } = data;
  const edge = whole.cell_m;
  const picture = drawn(data, "whole");
  const squareOf = ([x, y]) => [x, y].map((value) => Math.floor(value / edge + 1e-6)).join(",");
  const known = new Map(whole.floor.map((square) => [squareOf(square.xy_m), square]));
  const open = new Set(whole.open_m.map(squareOf));
  const early = earliness(whole.floor);
  const spans = whole.floor.flatMap((square) => square.spans.map(([at]) => at));
  const last = Math.max(Math.ceil(whole.until_s / whole.span_s - 1e-6) - 1, ...spans, 0);
  let shown = "worst";
  let span = spans.length > 0 ? Math.min(...spans) : 0;
  let chosen = null;

  const told = h("output", { "data-test": "whole-told", class: "told screen-only" });
  const key = h("ul", { class: "whole-key", "data-test": "whole-key" });
  const caption = h("p", { class: "note" });
  const hint = "Point at the floor, or touch it, to read a square; arrow keys move on.";
  function say() {
    const square = chosen && known.get(squareOf(chosen));
    if (!chosen) {
      told.textContent = hint;
    } else if (square) {
      const now = shown === "moment" ? square.spans.find(([at]) => at === span) : null;
      const then = shown !== "moment" ? "" : now ? `; now ${ratio(now[1])}` : "; now no hit found";
      told.textContent = `${place(square.xy_m)}: up to ${ratio(square.ratio)}, first at ${time(square.earliest_s)}${square.unseen ? "" : ", only who walks in, if in time"}${then}`;
    } else {
      told.textContent = `${place(chosen)}: ${open.has(squareOf(chosen)) ? "not known" : whole.looked_at ? "no hit found" : NOT_LOOKED_AT}`;
    }
    picture.point(chosen);
  }
  const slider = h("input", { type: "range", min: 0, max: last, step: 1, value: span, "aria-label": "moment", "data-test": "whole-slider", oninput: () => ((span = Number(slider.value)), choose("moment")) });
  const now = h("output", { class: "whole-now", "data-test": "whole-now" });
  function draw() {
    const moments = shown === "moment";
    const ratioAt = (square) => square.spans.find(([at]) => at === span)?.[1];
    const of = {
      worst: (square) => hardness(square.ratio).colour,
      earliest: (square) => early.of(square.earliest_s).colour,
      moment: (square) => (ratioAt(square) === undefined ? null : hardness(ratioAt(square)).colour),
    };
    picture.colour(of[shown]);
    const classes = shown === "earliest" ? early.classes : hardClasses(whole);
    const rows = classes.map(({ text, colour }) => swatch(`background:${colour}`, shown === "earliest" ? `first hit at ${text}` : text));
    key.replaceChildren(...rows, ...(moments ? [kind("else", "hit at other moments")] : []), ...surfaces(data));
    slider.setAttribute("aria-valuetext", moment(span, whole.span_s));
    const hit = whole.floor.filter((square) => ratioAt(square) !== undefined).length;
    now.textContent = moments ? `${moment(span, whole.span_s)}: ${hit === 0 ? "no hit found" : `hits on ${area(hit, edge)}`}` : `0 to ${time(whole.until_s)}`;
    caption.textContent = moments ? MOMENTS : shown === "earliest" ? "Colours tell the earliest moment, after the start, at which a hit was found in each square." : TRIED;
    say();
  }
  const buttons = [["worst", "how hard"], ["earliest", "how early"], ...(whole.followed && spans.length > 0 ? [["moment", "at one moment"]] : [])].map(([value, text], index) => {
    const input = h("input", { type: "radio", name: "whole", value, checked: index === 0, "data-test": `whole-${value}`, onchange: () => choose(value) });
    return [value, input, h("label", {}, input, ` ${text}`)];
  });
  function choose(value) {
    shown = value;
    buttons.forEach(([name, input]) => (input.checked = name === value));
    draw();
  }
  const { element, bounds } = picture;
  const within = (xy) => xy.every((value, axis) => value >= bounds[axis][0] && value <= bounds[axis][1]);
  const to = (xy) => {
    chosen = xy && within(xy) ? xy.map((value) => (Math.floor(value / edge + 1e-6) + 0.5) * edge) : null;
    say();
  };
  ["pointermove", "pointerdown"].forEach((name) => element.addEventListener(name, (event) => to(picture.under(event))));
  element.addEventListener("pointerleave", (event) => event.pointerType === "mouse" && to(null));
  element.setAttribute("tabindex", "0");
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (step) {
      event.preventDefault();
      event.stopPropagation();
      const worst = whole.floor.reduce((a, b) => (b.ratio > a.ratio ? b : a), whole.floor[0]);
      const next = chosen ? chosen.map((value, axis) => value + step[axis] * edge) : (worst?.xy_m ?? bounds.map(([from, until]) => (from + until) / 2));
      within(next) && to(next);
    }
  });
  const link = (hit, text) => (hit.id && data.hazard(hit.id) ? h("a", { href: `#${hit.id}` }, text) : text);
  const listed = whole.places.slice(0, NUMBERED).map((hit) => h("li", { onmouseenter: () => to(hit.xy_m), onmouseleave: () => to(null) }, link(hit, placeText(hit, words))));
  const more = whole.places.length - listed.length;
  draw();
  return section(
    "whole",
    "The floor",
    h("p", { class: "whole-head", "data-test": "whole-head" }, whole.said),
    h(
      "div",
      { class: "filters screen-only" },
      whole.floor.length > 0 ? h("fieldset", {}, h("legend", {}, "colour"), buttons.map(([, , label]) => label)) : null,
      whole.followed && spans.length > 0 ? h("span", { class: "whole-time" }, slider, now) : null,
    ),
    h(
      "div",
      { class: "whole" },
      h("div", {}, element, told),
      h(
        "div",
        {},
        key,
        caption,
        listed.length > 0 ? h("h3", {}, "Worst ways to be hit") : null,
        h("ol", { class: "whole-places" }, listed),
        more > 0 ? h("p", { class: "note" }, `And ${count(more, "way")} more, less bad or not confirmed.`) : null,
      ),
    ),
  );
}
