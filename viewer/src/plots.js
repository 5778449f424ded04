// Force, distance and speed over time, with one cursor for all, which follows the replay and moves it when clicked.

import uPlot from "uplot";
import { h } from "./dom.js";

/** Width of the column left of every plot and strip, so that their time axes are the same. */
export const GUTTER_PX = 92;
/** Room right of them, for half of the last tick's text. */
export const RIGHT_PX = 14;

const HEIGHT_PX = 132;
const SYNC = "replay";

const GRAPHS = [
  { key: "force_ratio", title: "a hit at this speed would be", others: "a hit of somebody who can give way would be", unit: "x", of: "x the limit", limit: 1, colour: "--hitting" },
  { key: "distance_m", title: "gap to what is hit", unit: "m", limit: 0, colour: "--accent" },
  { key: "speed_m_s", title: "speed of the link", unit: "m/s", colour: "--path" },
];

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** A level that must not be missing from the picture, as a dashed line. */
function level(value) {
  return (u) => {
    const y = u.valToPos(value, "y", true);
    const { ctx, bbox } = u;
    ctx.save();
    ctx.strokeStyle = style("--ink");
    ctx.setLineDash([6, 5]);
    ctx.beginPath();
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    ctx.restore();
  };
}

/** Upright lines where something happens: sensors begin to report, contact, rest. */
function upright(events) {
  return (u) => {
    const { ctx, bbox } = u;
    ctx.save();
    for (const { frame, kind } of events()) {
      const x = u.valToPos(u.data[0][frame], "x", true);
      ctx.strokeStyle = style(`--event-${kind}`);
      ctx.lineWidth = 1.5 * devicePixelRatio;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  };
}

/** Least and most of the numbers, the level included, with a little room. */
function range(limit) {
  return (_, low, high) => {
    const values = [low, high, limit].filter((value) => value !== null && value !== undefined);
    const [least, most] = values.length > 0 ? [Math.min(...values), Math.max(...values)] : [0, 1];
    const room = Math.max(0.08 * (most - least), 0.02);
    return [least < 0 ? least - room : least === 0 ? 0 : Math.max(0, least - room), most + room];
  };
}

/** The three plots; `seek` hears the frame that was clicked. */
export function makePlots(seek) {
  const figures = GRAPHS.map((graph) => {
    const value = h("b");
    const box = h("div", { class: "plot" });
    const title = h("span", {}, graph.title);
    return { ...graph, value, box, named: title, element: h("figure", {}, h("figcaption", {}, title, " ", value), box) };
  });
  const element = h("div", { class: "plots", "data-test": "plots" }, figures.map((figure) => figure.element));
  let replay = null;
  let events = [];
  let frame = 0;

  const last = () => Math.max(replay.frames - 1, 1);

  function options({ colour, limit, unit }) {
    const axis = { stroke: style("--ink-soft"), grid: { stroke: style("--line"), width: 1 }, ticks: { stroke: style("--line"), width: 1 }, font: "11px system-ui, sans-serif" };
    return {
      width: Math.max(element.clientWidth, 200),
      height: HEIGHT_PX,
      padding: [6, RIGHT_PX, 0, 0],
      legend: { show: false },
      cursor: { sync: { key: SYNC, setSeries: false }, drag: { x: false, y: false }, y: false, points: { size: 7 } },
      scales: { x: { time: false, range: (u, low, high) => [low, high] }, y: { range: range(limit) } },
      axes: [
        { ...axis, size: 22, gap: 2, values: (_, ticks) => ticks.map((tick) => `${+tick.toFixed(2)} s`) },
        { ...axis, size: GUTTER_PX, gap: 4, space: 24, values: (_, ticks) => ticks.map((tick) => `${+tick.toFixed(2)} ${unit}`) },
      ],
      series: [{}, { stroke: style(colour), width: 2, points: { show: false } }],
      hooks: { draw: [upright(() => events), ...(limit === undefined ? [] : [level(limit)])] },
    };
  }

  function listen(u) {
    const line = h("div", { class: "now" });
    u.over.append(line);
    u.now = line;
    const to = (event) => {
      const { left, width } = u.over.getBoundingClientRect();
      seek(((event.clientX - left) / width) * last());
    };
    u.over.addEventListener("pointerdown", (event) => {
      u.over.setPointerCapture(event.pointerId);
      to(event);
    });
    u.over.addEventListener("pointermove", (event) => event.buttons === 1 && to(event));
  }

  function build() {
    for (const figure of figures) {
      figure.plot?.destroy();
      const numbers = [...replay[figure.key]].map((value) => (Number.isFinite(value) ? value : null));
      figure.plot = new uPlot(options(figure), [[...replay.time_s], numbers], figure.box);
      listen(figure.plot);
    }
    show(frame);
  }

  function show(to) {
    frame = to;
    for (const { plot, key, value, unit, of } of figures) {
      plot.now.style.left = `${(100 * frame) / last()}%`;
      const number = replay[key][frame];
      value.textContent = Number.isFinite(number) ? `${number.toFixed(2)}${of ?? ` ${unit}`}` : "none";
    }
  }

  new ResizeObserver(() => {
    for (const { plot } of figures) {
      plot?.setSize({ width: Math.max(element.clientWidth, 200), height: HEIGHT_PX });
    }
  }).observe(element);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => replay && build());

  return {
    element,
    load(next, marked, byForce) {
      [replay, events, frame] = [next, marked, 0];
      figures.forEach(({ named, title, others }) => (named.textContent = byForce ? title : (others ?? title)));
      build();
    },
    show,
  };
}
