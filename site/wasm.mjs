// The playground's WebAssembly (wasm/src/exports.rs).

/** Of a compiled module, its functions as JavaScript has them: texts are strings, objects go in as JSON. */
export async function playground(module) {
  const page = { now: () => performance.now() };
  const { exports } = await WebAssembly.instantiate(module, { page });
  const { memory, begin, room, done, open, advance, request, update, traced } = exports;
  const place = (object) => {
    const bytes = new TextEncoder().encode(JSON.stringify(object));
    const at = room(bytes.length);
    new Uint8Array(memory.buffer).set(bytes, at);
    return [at, bytes.length];
  };
  const text = (at) => {
    const length = new DataView(memory.buffer).getUint32(at, true);
    const text = new TextDecoder().decode(new Uint8Array(memory.buffer, at + 4, length));
    done(at, length);
    return text;
  };
  const own = begin();
  return {
    /** Begins a session; the error, or ''. */
    open: (wanted) => text(open(own, ...place(wanted))),
    /** So many ms have passed. */
    advance: (elapsed) => advance(own, elapsed),
    /** The answer to a request, or ''. */
    request: (asked) => text(request(own, ...place(asked))),
    /** What the page does not know yet, or ''. */
    update: () => text(update(own)),
    /** The trace of a run, or why there is none. */
    trace: (wanted) => text(traced(...place(wanted))),
  };
}
