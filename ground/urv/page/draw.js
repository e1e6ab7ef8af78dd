// SPDX-License-Identifier: Apache-2.0
// Common helpers of the instruments.

const SVG = "http://www.w3.org/2000/svg";

export const byId = (id) => document.getElementById(id);

// An HTML element; its text is inserted as text only.
export function html(tag, attributes = {}, ...inside) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    made.setAttribute(name, value);
  }
  made.append(...inside);
  return made;
}

export function svg(tag, attributes = {}, ...inside) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) {
    made.setAttribute(name, value);
  }
  made.append(...inside);
  return made;
}

// Writes only changes: the page is drawn 25 times a second.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export function put(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

export const clamp = (value, low, high) =>
  Math.min(high, Math.max(low, value));

// A number with fixed width: no digit moves when another one changes.
export function fixed(value, places, width) {
  const shown = value.toFixed(places);
  // A zero has no sign.
  const plain = Number(shown) === 0 ? (0).toFixed(places) : shown;
  return plain.replace("-", "\u2212").padStart(width, "\u2007");
}

export const signed = (value, places, width) =>
  (Number(value.toFixed(places)) > 0 ? "+" + value.toFixed(places)
    : fixed(value, places, 0)).padStart(width, "\u2007");

// The cross over a panel without fresh words.
export const cross = (x, y, width, height) => svg("path", { class: "cross",
  d: `M${x} ${y}l${width} ${height}M${x} ${y + height}l${width} ${-height}` });

// Forbidden ranges of a value, lowest first: [level, from, to].
export function bands(item, low, high) {
  if (!item) return [];
  const found = [];
  const add = (level, from, to) => {
    if (to > from) found.push([level, clamp(from, low, high),
      clamp(to, low, high)]);
  };
  const { warning_low, caution_low, caution_high, warning_high } = item;
  if (warning_low !== null) add("warning", low, warning_low);
  if (caution_low !== null) {
    add("caution", warning_low ?? low, caution_low);
  }
  if (caution_high !== null) {
    add("caution", caution_high, warning_high ?? high);
  }
  if (warning_high !== null) add("warning", warning_high, high);
  return found;
}

// The limit that a value has passed.
export function level(item, value) {
  if (!item || value === null) return "";
  const { warning_low, caution_low, caution_high, warning_high } = item;
  if ((warning_low !== null && value < warning_low)
    || (warning_high !== null && value > warning_high)) return "warning";
  if ((caution_low !== null && value < caution_low)
    || (caution_high !== null && value > caution_high)) return "caution";
  return "";
}
