// The table of hazards: sorted by column, filtered by text, region, link, decision and by a bin of the map.

import { h, section } from "./dom.js";
import * as words from "./words.js";

/** Columns: title, what it is sorted by, what a cell holds, whether it is a number. */
function columns({ decisionOf, worst, counted }) {
  const number = true;
  const times = (z) => z.sequences ?? z.times_found;
  return [
    ["id", (z) => z.id, (z) => h("a", { href: `#${z.id}`, class: "id" }, z.id)],
    ["ratio", (z) => z.ratio, (z) => bar(z, worst), number],
    ["body region", (z) => words.region(z.body_region), (z) => words.region(z.body_region)],
    ["hit by", (z) => z.robot_link, (z) => z.robot_link],
    ["force / limit", (z) => z.force_n, words.forceOfLimit, number],
    ["speed", (z) => z.speed_m_s, (z) => words.speed(z.speed_m_s), number],
    ["safe below", (z) => z.safe_below_m_s, words.safeBelow, number],
    ["time", (z) => z.time_s, (z) => words.time(z.time_s), number],
    [counted ? "sequences" : "times found", (z) => Number(times(z)), (z) => words.grouped(times(z)), number],
    ["sensors at contact", (z) => words.sensors(z.sensors), (z) => words.sensors(z.sensors)],
    ["confirmed", (z) => words.confirmed(z.confirmed), (z) => words.confirmed(z.confirmed)],
    ["decision", (z) => decisionOf(z.id), (z) => decisionOf(z.id)],
  ];
}

/** A ratio with a bar; the mark stands at the limit. */
function bar(hazard, worst) {
  const scale = Math.max(worst, 1.05);
  const part = (value) => `${((100 * value) / scale).toFixed(1)}%`;
  const over = hazard.ratio >= 1;
  return h(
    "span",
    { class: "ratio" },
    h(
      "span",
      { class: "bar screen-only", "aria-hidden": "true" },
      h("span", { class: over ? "over" : "under", style: `width:${part(hazard.ratio)}` }),
      h("span", { class: "mark", style: `left:${part(1)}` }),
    ),
    h("b", {}, words.ratio(hazard.ratio)),
  );
}

function choice(label, test, values, change) {
  const options = [h("option", { value: "" }, "all"), ...values.map(([value, text]) => h("option", { value }, text))];
  return h("label", {}, `${label} `, h("select", { "data-test": test, onchange: change }, options));
}

/** The section with the table; `setBin` shows only the hazards of a bin of the map. */
export function hazardTable(data, selection, assessments) {
  const hazards = data.scan.hazards;
  const worst = Math.max(...hazards.map((hazard) => hazard.ratio));
  const decisionOf = (id) => assessments.of(id).decision || "open";
  const counted = hazards.some((hazard) => hazard.sequences !== null);
  const shown = columns({ decisionOf, worst, counted });
  const distinct = (of) => [...new Set(hazards.map(of))].sort();
  let sorted = { column: 1, descending: true };
  let bin = null;

  const filter = h("input", { type: "search", placeholder: "any text", "data-test": "filter", oninput: show });
  const regions = choice("region", "filter-region", distinct((z) => z.body_region).map((r) => [r, words.region(r)]), show);
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

  assessments.follow(refresh);
  refresh();
  selection.follow((id) => {
    for (const [other, element] of rows) {
      element.setAttribute("aria-selected", other === id);
      element.querySelector("a").toggleAttribute("aria-current", other === id);
    }
  });

  const bounded = data.scan.hazards.some((z) => z.class === "head_contact")
    ? h("p", { class: "note" }, "“None allowed”: a moving robot may not touch head or throat at all; the ratio is that to the force limit and may be below 1.")
    : null;
  const element = section(
    "hazards",
    "Hazards",
    h("div", { class: "filters screen-only" }, h("label", {}, "filter ", filter), regions, links, decisions, binNote, number),
    h("div", { class: "scroll", tabindex: 0 }, h("table", { class: "hazards" }, h("thead", {}, h("tr", {}, heads)), body)),
    bounded,
  );
  return { element, setBin };
}
