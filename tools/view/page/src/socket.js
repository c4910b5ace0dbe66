// A session behind a WebSocket, which reconnects after a loss.

/** First delay of a reconnection, ms. Each further one is twice as long, up to LAST. */
const FIRST = 250;
const LAST = 4000;

export function socketSession(address) {
  const [listeners, watchers] = [[], []];
  let [socket, pause] = [undefined, FIRST];
  const tell = (reached) => watchers.forEach((watcher) => watcher(reached));
  const connect = () => {
    socket = new WebSocket(address);
    socket.addEventListener('open', () => {
      pause = FIRST;
      tell(true);
    });
    socket.addEventListener('message', ({ data }) => {
      const update = JSON.parse(data);
      listeners.forEach((listener) => listener(update));
    });
    socket.addEventListener('close', () => {
      tell(false);
      setTimeout(connect, pause);
      pause = Math.min(pause * 2, LAST);
    });
  };
  connect();
  return {
    send(request) {
      if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
    },
    listen: (listener) => listeners.push(listener),
    watch: (listener) => watchers.push(listener),
  };
}
