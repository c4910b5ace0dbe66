// Writer of ZIP files without compression (PKWARE's APPNOTE 6.3.10, method 0), for files that are compressed already.

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; bit++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});

function checksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = TABLE[(sum ^ byte) & 255] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}

/** Encodes numbers of 2 or 4 bytes, the lowest first, each given as [size, value]. */
function record(...fields) {
  const bytes = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) bytes.setUint16(at, value, true);
    else bytes.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(bytes.buffer);
}

/** Creates a ZIP of files { name, bytes }; names are ASCII. */
export function zip(files) {
  const [parts, list] = [[], []];
  let at = 0;
  for (const { name, bytes } of files) {
    const ascii = new TextEncoder().encode(name);
    // Version 1.0, no flags, stored, midnight of 1 January 1980.
    const common = [[2, 10], [2, 0], [2, 0], [2, 0], [2, 0x21], [4, checksum(bytes)], [4, bytes.length], [4, bytes.length], [2, ascii.length], [2, 0]];
    const local = record([4, 0x04034b50], ...common);
    list.push(record([4, 0x02014b50], [2, 10], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]), ascii);
    parts.push(local, ascii, bytes);
    at += local.length + ascii.length + bytes.length;
  }
  const size = list.reduce((sum, part) => sum + part.length, 0);
  const end = record([4, 0x06054b50], [2, 0], [2, 0], [2, files.length], [2, files.length], [4, size], [4, at], [2, 0]);
  return new Blob([...parts, ...list, end], { type: 'application/zip' });
}
