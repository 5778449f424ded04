// The head of the report after the verdict: the selected cause with its picture beside it, the other causes below.

import { causeCard } from "./card.js";
import { h, section } from "./dom.js";
import { count } from "./words.js";

/** The section with one card per cause; `picture` is the replay of the selected hazard, `assess` leads to the form. */
export function causesSection(data, selection, assessments, { picture, assess }) {
  const chosen = h("div", { class: "chosen" });
  const others = h("div", { class: "others" });
  const hero = h("div", { class: "hero" }, chosen, picture);

  function choose(id) {
    const before = selection.now.cause;
    const focused = others.contains(document.activeElement);
    selection.select(id);
    if (focused) {
      // The card that has the focus went up to the others' place.
      cards.get(selection.now.cause).focus();
    }
    // Another cause is read from its beginning; another way of the same cause is looked at.
    selection.now.cause === before ? picture.scrollIntoView({ block: "nearest" }) : hero.scrollIntoView({ block: "start" });
  }
  const cards = new Map(data.causes.map((cause) => [cause.id, causeCard(data, cause, { choose, assess, assessments })]));

  selection.follow(({ cause: selected, hazard }) => {
    for (const [id, card] of cards) {
      card.show(id === selected ? hazard : null);
    }
    const rest = [...cards].filter(([id]) => id !== selected).map(([, card]) => card.element);
    if (chosen.firstElementChild !== cards.get(selected).element) {
      chosen.replaceChildren(cards.get(selected).element);
      others.replaceChildren(...(rest.length > 0 ? [h("h3", {}, `${count(rest.length, "other cause")}, worst first`), ...rest] : []));
    }
  });
  return section("causes", `${count(data.causes.length, "cause")}${data.causes.length > 1 ? ", worst first" : ""}`, hero, others);
}
