// The table of hazards: sorted by column, filtered by text, region, link, decision and by a bin of the map.

import { badge } from "./card.js";
import { current, h, section } from "./dom.js";
import { count } from "./words.js";

/** Columns: title, what it is sorted by, what a cell holds, whether it is a number. */
function columns({ decisionOf, worst, counted, causeOf, words, others }) {
  const number = true;
  const times = (z) => z.sequences ?? z.times_found;
  const cell = (index) => (z) => words.hazards[z.id].row[index];
  const region = (z) => words.regions[z.body_region];
  return [
    ["id", (z) => z.id, (z) => h("a", { href: `#${z.id}`, class: "id" }, z.id)],
    ["cause", (z) => causeOf(z.id).number, (z) => badge(causeOf(z.id)), number],
    ["ratio", (z) => z.ratio, (z) => bar(z, worst, words.hazards[z.id]), number],
    ["body region", region, region],
    ["hit by", (z) => z.robot_link, (z) => z.robot_link],
    ["force: own speed", (z) => z.force_n, cell(1), number],
    ["force: approach", (z) => z.directed_force_n, cell(2), number],
    ["limit", (z) => z.limit_n, cell(3), number],
    ...(others ? [["what is broken", (z) => z.class, cell(4)]] : []),
    ["speed", (z) => z.speed_m_s, cell(5), number],
    ["safe below", (z) => z.safe_below_m_s, cell(6), number],
    ["time", (z) => z.time_s, cell(7), number],
    [counted ? "sequences" : "times found", (z) => Number(times(z)), cell(8), number],
    ["sensors that report", cell(9), cell(9)],
    ["confirmed", cell(10), cell(10)],
    ["decision", (z) => decisionOf(z.id), (z) => decisionOf(z.id)],
  ];
}

/** A ratio with a bar; the mark stands at the limit. Where the two forces are far apart, a sign says so. */
function bar({ ratio }, worst, { row: [text], apart, forces }) {
  const scale = Math.max(worst, 1.05);
  const part = (value) => `${((100 * value) / scale).toFixed(1)}%`;
  return h(
    "span",
    { class: "ratio" },
    apart ? h("span", { class: "flag", "data-test": "apart", title: [apart, ...forces[0]].join("\n") }, "differ") : null,
    h(
      "span",
      { class: "bar screen-only", "aria-hidden": "true" },
      h("span", { class: ratio >= 1 ? "over" : "under", style: `width:${part(ratio)}` }),
      h("span", { class: "mark", style: `left:${part(1)}` }),
    ),
    h("b", {}, text),
  );
}

function choice(label, test, values, change) {
  const options = [h("option", { value: "" }, "all"), ...values.map(([value, text]) => h("option", { value }, text))];
  return h("label", {}, `${label} `, h("select", { "data-test": test, onchange: change }, options));
}

/** The section with the table; `setBin` shows only the hazards of a bin of the map, `toReplay` leads to the picture. */
export function hazardTable(data, selection, assessments, toReplay) {
  const hazards = data.scan.hazards;
  const { words } = data;
  const worst = Math.max(...hazards.map((hazard) => hazard.ratio));
  const decisionOf = (id) => assessments.decision(id);
  const counted = hazards.some((hazard) => hazard.sequences !== null);
  const shown = columns({ decisionOf, worst, counted, causeOf: data.causeOf, words, others: hazards.some(({ id }) => words.hazards[id].broken) });
  const distinct = (of) => [...new Set(hazards.map(of))].sort();
  let sorted = { column: 2, descending: true };
  let bin = null;

  const filter = h("input", { type: "search", placeholder: "any text", "data-test": "filter", oninput: show });
  const regions = choice("region", "filter-region", distinct((z) => z.body_region).map((r) => [r, words.regions[r]]), show);
  const links = choice("hit by", "filter-link", distinct((z) => z.robot_link).map((l) => [l, l]), show);
  const decisions = choice("decision", "filter-decision", assessments.decisions.map((d) => [d, d]), show);
  const number = h("output", { "data-test": "shown" });
  const binNote = h("button", { type: "button", hidden: true, "data-test": "clear-bin", onclick: () => setBin(null) });

  const rows = new Map(hazards.map((hazard) => [hazard.id, row(hazard)]));
  const texts = new Map();
  const body = h("tbody", { onkeydown: walk });
  const heads = shown.map(([title, , , numeric], index) =>
    h(
      "th",
      { scope: "col", class: numeric ? "number" : null },
      h("button", { type: "button", "data-test": `sort-${index}`, onclick: () => sortBy(index) }, title),
    ),
  );

  function row(hazard) {
    const cells = shown.map(([, , content, numeric]) => h("td", { class: numeric ? "number" : null }, content(hazard)));
    const element = h("tr", { "data-test": "row", "data-id": hazard.id, class: hazard.class }, cells);
    element.addEventListener("click", (event) => {
      // A new window or a part of the text that is marked is not a choice.
      if (event.ctrlKey || event.metaKey || event.shiftKey || String(getSelection())) {
        return;
      }
      event.preventDefault();
      selection.select(hazard.id);
    });
    return element;
  }

  function walk(event) {
    const way = { ArrowDown: "nextElementSibling", ArrowUp: "previousElementSibling" }[event.key];
    const link = way && event.target.closest("tr")?.[way]?.querySelector("a");
    if (link) {
      event.preventDefault();
      link.focus();
    }
  }

  function sortBy(column) {
    const numeric = Boolean(shown[column][3]);
    sorted = { column, descending: sorted.column === column ? !sorted.descending : numeric };
    show();
  }

  function visible(hazard) {
    const is = (label, value) => !label.querySelector("select").value || label.querySelector("select").value === value;
    const text = filter.value.trim().toLowerCase();
    return (
      (bin === null || bin.ids.has(hazard.id)) &&
      is(regions, hazard.body_region) &&
      is(links, hazard.robot_link) &&
      is(decisions, decisionOf(hazard.id)) &&
      text.split(/\s+/).every((part) => texts.get(hazard.id).includes(part))
    );
  }

  function show() {
    const [, key] = shown[sorted.column];
    const sign = sorted.descending ? -1 : 1;
    const order = [...hazards].sort((a, b) => sign * (key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0));
    const kept = order.filter(visible);
    body.replaceChildren(...kept.map((hazard) => rows.get(hazard.id)));
    number.textContent = kept.length === hazards.length ? `${hazards.length} shown` : `${kept.length} of ${hazards.length} shown`;
    heads.forEach((head, index) => {
      const direction = sorted.descending ? "descending" : "ascending";
      head.setAttribute("aria-sort", index === sorted.column ? direction : "none");
    });
  }

  function setBin(chosen) {
    bin = chosen;
    binNote.hidden = bin === null;
    binNote.textContent = bin === null ? "" : `only ${bin.name} ✕`;
    fold.open ||= bin !== null;
    show();
  }

  /** Decisions and texts as they are now. */
  function refresh() {
    for (const hazard of hazards) {
      rows.get(hazard.id).lastElementChild.textContent = decisionOf(hazard.id);
      texts.set(hazard.id, rows.get(hazard.id).textContent.toLowerCase());
    }
    show();
  }

  const chosen = h("button", { type: "button", class: "to-replay screen-only", "data-test": "to-replay", onclick: toReplay });
  const fold = h(
    "details",
    { "data-test": "ways" },
    h("summary", {}, hazards.length === 1 ? "The one way, as a row" : `All ${count(hazards.length, "way")}, one row each`),
    h("div", { class: "filters screen-only" }, h("label", {}, "filter ", filter), regions, links, decisions, binNote, number),
    chosen,
    h("div", { class: "scroll", tabindex: 0 }, h("table", { class: "hazards" }, h("thead", {}, h("tr", {}, heads)), body)),
    words.table_notes.map((note) => h("p", { class: "note" }, note)),
  );

  assessments.follow(refresh);
  refresh();
  selection.follow(({ hazard: id }) => {
    chosen.textContent = `Show the replay of ${id}`;
    for (const [other, element] of rows) {
      element.setAttribute("aria-selected", other === id);
      current(element.querySelector("a"), other === id);
    }
  });

  // A link to one hazard leads to its row, too.
  const open = () => (fold.open ||= selection.namesHazard);
  addEventListener("hashchange", open);
  open();
  const element = section("hazards", "Every way by itself", fold);
  return { element, setBin };
}
