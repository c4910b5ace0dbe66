// Deflated bytes (RFC 1951) in base64, as a page holds what is large.

/** A call for each of some million characters would take longer than all else. */
export function bytesOf(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) bytes[at] = text.charCodeAt(at);
  return bytes;
}

/** Bytes that have gone through a stream. */
export async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export const inflated = (bytes) => through(bytes, new DecompressionStream('deflate-raw'));
