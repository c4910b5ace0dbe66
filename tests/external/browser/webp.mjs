// Joins still pictures to a moving one, all of them WebP (RFC 9649). Browsers encode stills and no motion.

/** Returns a chunk: its four letters, its length, and its content, filled up to an even length. */
function chunk(name, ...parts) {
  const content = Buffer.concat(parts);
  const head = Buffer.alloc(8);
  head.write(name, 'latin1');
  head.writeUInt32LE(content.length, 4);
  return Buffer.concat([head, content, Buffer.alloc(content.length % 2)]);
}

/** Returns a number as three bytes, lowest first. */
function three(value) {
  return Buffer.from([value & 255, (value >> 8) & 255, value >> 16]);
}

/** Returns the chunk of a still's pixels, without the head of its file and its colour profile. */
function pixels(still) {
  let at = 12;
  while (still.toString('latin1', at, at + 4) !== 'VP8 ') {
    at += 8 + still.readUInt32LE(at + 4);
    if (at + 8 > still.length) throw new Error('a still that is not lossy WebP');
  }
  return still.subarray(at);
}

/** Returns a picture that shows stills of one size one after the other, each for this many ms, for ever. */
export function animated(stills, { width, height }, milliseconds) {
  const size = Buffer.concat([three(width - 1), three(height - 1)]);
  const nowhere = Buffer.alloc(6);
  const frames = stills.map((still) => {
    // Nothing of the frame before shows through.
    return chunk('ANMF', nowhere, size, three(milliseconds), Buffer.from([2]), pixels(still));
  });
  const features = chunk('VP8X', Buffer.from([2, 0, 0, 0]), size);
  const forever = chunk('ANIM', Buffer.alloc(6));
  return chunk('RIFF', Buffer.from('WEBP', 'latin1'), features, forever, ...frames);
}
