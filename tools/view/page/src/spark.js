// A small plot of a variable over the whole run.

const SVG = 'http://www.w3.org/2000/svg';
/** Size and margin, px. */
const [WIDTH, HEIGHT, EDGE] = [150, 30, 2];

/** Draws the values of a scalar from the first cycle to the last, with a line at the present cycle. */
export function spark(recording, scalar, cycle) {
  const picture = draw('svg', { class: 'spark', width: WIDTH, height: HEIGHT, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': 'true' });
  const { cycles, values } = recording.entries(`set.${scalar}`);
  if (!values.length) return picture;
  const first = recording.first ?? 0;
  const x = (cycle) => ((cycle - first) / Math.max(recording.cycles - 1 - first, 1)) * (WIDTH - 2 * EDGE) + EDGE;
  const [low, high] = values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
  const y = (value) => HEIGHT - EDGE - (high > low ? (value - low) / (high - low) : 0.5) * (HEIGHT - 2 * EDGE);
  // Within half a pixel, the line goes through the lowest and the highest value.
  let path = '';
  for (let n = 0; n < values.length; ) {
    const at = x(cycles[n]);
    let [least, most, last] = [values[n], values[n], values[n]];
    for (; n < values.length && x(cycles[n]) < at + 0.5; n++) {
      last = values[n];
      [least, most] = [Math.min(least, last), Math.max(most, last)];
    }
    const level = (value) => `V${y(value).toFixed(1)}`;
    path += path ? `H${at.toFixed(1)}` : `M${at.toFixed(1)} ${y(least).toFixed(1)}`;
    path += level(least) + level(most) + level(last);
  }
  const now = x(cycle).toFixed(1);
  picture.append(draw('path', { class: 'now', d: `M${now} 0V${HEIGHT}` }), draw('path', { d: `${path}H${WIDTH - EDGE}` }));
  return picture;
}

function draw(tag, attributes) {
  const made = document.createElementNS(SVG, tag);
  Object.entries(attributes).forEach(([name, value]) => made.setAttribute(name, value));
  return made;
}
