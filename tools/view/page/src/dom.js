// Functions that find and create elements. Texts are never read as markup.

export const element = (id) => document.getElementById(id);

export function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Formats a number with so many decimals, without -0. */
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** Formats a time (ms) as the terminal does: 62.340 s. */
export function clockTime(time) {
  return `${fixed(time / 1000, 3)} s`;
}

/** Returns a colour of the scheme. */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Returns the colour of a leg or finger. */
export function legColour(leg) {
  return colour(`leg-${(leg % 9) + 1}`);
}
