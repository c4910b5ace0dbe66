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

/** Of ms: 1:02.340, or 2.340 s. */
export function clockTime(time) {
  const seconds = time / 1000;
  const minutes = Math.floor(seconds / 60);
  return minutes ? `${minutes}:${(seconds - 60 * minutes).toFixed(2).padStart(5, '0')}` : `${seconds.toFixed(2)} s`;
}

/** A value of the colour scheme. */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** The colour of a leg or finger. */
export function legColour(leg) {
  return colour(`leg-${(leg % 9) + 1}`);
}
