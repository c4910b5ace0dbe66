// Reader of deflated bytes (RFC 1951) in base64, in which pages store large parts.

/** Decodes base64. The loop avoids a call for each of millions of characters. */
export function bytesOf(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) bytes[at] = text.charCodeAt(at);
  return bytes;
}

/** Returns the bytes after a stream. */
export async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export const inflated = (bytes) => through(bytes, new DecompressionStream('deflate-raw'));
