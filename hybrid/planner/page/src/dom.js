// Elements of the page.

export const byId = (id) => document.getElementById(id);

/** An element with attributes, listeners (values that are functions) and children. */
export function make(name, attributes = {}, ...children) {
  const drawn = ["svg", "path"].includes(name);
  const node = drawn
    ? document.createElementNS("http://www.w3.org/2000/svg", name)
    : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (typeof value === "function") node.addEventListener(key, value);
    else if (value !== false && value !== undefined && value !== null)
      node.setAttribute(key, value === true ? "" : String(value));
  node.append(
    ...children.flat().filter((child) => child !== null && child !== undefined && child !== ""),
  );
  return node;
}

/** The head of a column; an empty one is a plain cell. */
export const columnHead = (text, number = false) =>
  text ? make("th", { scope: "col", class: number ? "number" : null }, text) : make("td");

/** A table of column heads and rows. */
export const tableOf = (heads, rows) =>
  make("table", {}, make("thead", {}, make("tr", {}, heads)), make("tbody", {}, rows));

/** What is wider than the page scrolls in itself, also by keyboard. */
export const scrolling = (label, attributes, ...children) =>
  make(
    "div",
    { class: "scroll", role: "region", tabindex: "0", "aria-label": label, ...attributes },
    ...children,
  );

/** Colours of the style sheet, for what is drawn on a canvas; they follow light and dark. */
export function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** One line for those who do not see the page change. */
export function announce(text) {
  byId("spoken").textContent = text;
}
