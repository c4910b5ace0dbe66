// The playground's WebAssembly, of which JavaScript knows three functions (wasm/src/exports.rs).

/** Asks a question of wasm/src/ask.rs, and gives its answer. */
export function asker({ room, ask, done, memory }) {
  return (question) => {
    const bytes = new TextEncoder().encode(JSON.stringify(question));
    const place = room(bytes.length);
    new Uint8Array(memory.buffer).set(bytes, place);
    const answer = ask(place, bytes.length);
    const length = new DataView(memory.buffer).getUint32(answer, true);
    const text = new TextDecoder().decode(new Uint8Array(memory.buffer, answer + 4, length));
    done(answer, length);
    return JSON.parse(text);
  };
}
