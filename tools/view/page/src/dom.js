// Elements by their ids, and new ones. Text always becomes text, never markup.

export const element = (id) => document.getElementById(id);

export function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** A number with so many decimals, without -0. */
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** Of ms, as the terminal has it: 62.340 s. */
export function clockTime(time) {
  return `${fixed(time / 1000, 3)} s`;
}

/** A value of the colour scheme. */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** The colour of a leg or finger. */
export function legColour(leg) {
  return colour(`leg-${(leg % 9) + 1}`);
}
