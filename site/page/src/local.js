// A session in this page (tools/view/page/src/session.js), in a module in the place of a server.

/** Time between two advances of the run, ms. */
const TICK = 4;

/** Of a module (../../wasm.mjs). `open(wanted)` begins another session in the place of the one before, or gives an error. */
export function localSession(module) {
  const listeners = [];
  let last = performance.now();
  const tell = (text) => {
    const update = JSON.parse(text);
    listeners.forEach((listener) => listener(update));
  };
  const goOn = () => {
    const now = performance.now();
    module.advance(now - last);
    last = now;
    for (let update = module.update(); update; update = module.update()) tell(update);
  };
  setInterval(goOn, TICK);
  return {
    // As from afar, the answer comes when the page has done what it is doing.
    send(request) {
      const answer = module.request(request);
      queueMicrotask(() => {
        if (answer) tell(answer);
        goOn();
      });
    },
    listen: (listener) => listeners.push(listener),
    open(wanted) {
      const error = module.open(wanted);
      last = performance.now();
      queueMicrotask(goOn);
      return error;
    },
  };
}
