// What a result rests on: everything that "nobody is hit" needs, shown, assumed or open. All words are the scan's.

import { h } from "./dom.js";

const STATES = { shown: "shown", assumed: "accepted", open: "open" };

const known = (one) =>
  ({
    shown: () => one.figure,
    assumed: () => `${one.by}: ${one.because} (${one.tried})`,
    open: () => (one.what_to_do ? `${one.why}. ${one.what_to_do}.` : one.why),
  })[one.standing]();

const row = (one) =>
  h("tr", { class: one.standing }, h("td", {}, STATES[one.standing]), h("td", {}, one.about ? `${one.says} (${one.about})` : one.says), h("td", {}, known(one)));

/** Open ones first. */
const ORDER = ["open", "assumed", "shown"];

/** The table, and the lines that accept what was only tried out. */
export function restsOn({ obligations }, words) {
  if (!obligations || obligations.length === 0) {
    return null;
  }
  const rows = ORDER.flatMap((standing) => obligations.filter((one) => one.standing === standing));
  const lines = obligations.flatMap((one) => (one.accept ? [one.accept] : []));
  return h(
    "div",
    { "data-test": "rests-on" },
    h("h3", {}, "What this result rests on"),
    h(
      "div",
      { class: "scroll", tabindex: 0 },
      h("table", { class: "plain obligations" }, h("thead", {}, h("tr", {}, ["", "needed", "known"].map((title) => h("th", { scope: "col" }, title)))), h("tbody", {}, rows.map(row))),
    ),
    lines.length > 0 ? [h("p", {}, words.to_accept), h("pre", { "data-test": "accept" }, lines.join("\n"))] : null,
  );
}
