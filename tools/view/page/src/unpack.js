// What tip-view packs (src/pack.rs): deflated bytes, of which a header in JSON comes first and then columns.

/** Of base64; a call for each of some million characters would take longer than all else. */
export function bytesOf(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) bytes[at] = text.charCodeAt(at);
  return bytes;
}

/** Inflates and reads a recording; `base64` is how the page holds it. */
export async function unpack(base64) {
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const columns = {};
  let at = 4 + length;
  for (const column of header.columns) {
    columns[column.name] = READERS[column.kind](bytes.subarray(at, at + column.bytes), column);
    at += column.bytes;
  }
  return { header, columns };
}

const READERS = {
  /** Whole numbers, each 7 bits a byte, lowest first. */
  numbers(bytes, { count }) {
    const values = new Float64Array(count);
    for (let i = 0, at = 0; i < count; i++) {
      let [value, scale, byte] = [0, 1, 0];
      do {
        byte = bytes[at++];
        value += (byte & 127) * scale;
        scale *= 128;
      } while (byte > 127);
      values[i] = value;
    }
    return values;
  },
  /** Differences of 16 bits between numbers on a grid: first all low bytes, then all high ones. */
  deltas(bytes, { count, first, grid }) {
    const values = new Float32Array(count);
    for (let i = 0, sum = first; i < count; i++) {
      const delta = ((bytes[i] | (bytes[count + i] << 8)) << 16) >> 16;
      sum += delta;
      values[i] = sum * grid;
    }
    return values;
  },
  /** Exact numbers: their first bytes, their second bytes and so on. */
  exact(bytes, { count }) {
    const turned = new Uint8Array(8 * count);
    for (let i = 0; i < count; i++) {
      for (let byte = 0; byte < 8; byte++) turned[8 * i + byte] = bytes[byte * count + i];
    }
    return new Float64Array(turned.buffer);
  },
};

/** Running sums. */
export function sums(values) {
  let sum = 0;
  return values.map((value) => (sum += value));
}

/** Whole numbers that may be negative, from 0, -1, 1, -2, … as 0, 1, 2, 3, … */
export function signed(values) {
  return values.map((value) => (value % 2 ? -(value + 1) / 2 : value / 2));
}
