// Making elements. Texts go in as text nodes only: names come from FMUs and cell files of strangers.

const SVG = "http://www.w3.org/2000/svg";

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) {
      element.addEventListener(name.slice(2), value);
    } else if (value !== undefined && value !== null && value !== false) {
      element.setAttribute(name, value === true ? "" : value);
    }
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** An HTML element; attributes whose name begins with "on" are listeners. */
export function h(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** The same for SVG. */
export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), attributes, children);
}

/** Says of an element whether it is the one that is selected. */
export function current(element, on) {
  on ? element.setAttribute("aria-current", "true") : element.removeAttribute("aria-current");
}

/** A section of the report with its heading. */
export function section(id, title, ...children) {
  return h("section", { id, "aria-labelledby": `${id}-title` }, h("h2", { id: `${id}-title` }, title), ...children);
}

/** A definition list from pairs; pairs without a value are left out. */
export function definitions(pairs) {
  const list = h("dl");
  for (const [term, value] of pairs) {
    if (value !== null && value !== undefined && value !== "") {
      list.append(h("div", {}, h("dt", {}, term), h("dd", {}, value)));
    }
  }
  return list;
}

/** A command with a button that copies it. */
export function command(text) {
  const code = h("code", {}, text);
  const button = h("button", { type: "button", class: "copy screen-only", onclick: copy }, "Copy");
  async function copy() {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      // Without the permission the reader can still copy by hand what is marked now.
      getSelection().selectAllChildren(code);
      button.textContent = "Marked: press Ctrl+C";
    }
    setTimeout(() => (button.textContent = "Copy"), 2500);
  }
  return h("div", { class: "command" }, code, button);
}

/** SVG markup that the tool drew, without anything in it that could run. */
export function drawing(markup) {
  const parsed = new DOMParser().parseFromString(markup, "image/svg+xml").documentElement;
  if (parsed.localName !== "svg") {
    return h("p", { class: "note" }, "This drawing is not SVG.");
  }
  for (const element of [parsed, ...parsed.querySelectorAll("*")]) {
    if (["script", "foreignObject"].includes(element.localName)) {
      element.remove();
    }
    for (const { name } of [...element.attributes]) {
      if (name.startsWith("on") || name.endsWith("href")) {
        element.removeAttribute(name);
      }
    }
  }
  const width = parsed.getAttribute("width");
  const height = parsed.getAttribute("height");
  if (!parsed.hasAttribute("viewBox") && width && height) {
    parsed.setAttribute("viewBox", `0 0 ${width} ${height}`);
  }
  parsed.setAttribute("role", "img");
  return document.importNode(parsed, true);
}
