// Binary search in ordered lists.

/** Returns the number of ordered values up to and including `value`. */
export function countUpTo(values, value, of = (one) => one) {
  let [low, high] = [0, values.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (of(values[middle]) <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}
