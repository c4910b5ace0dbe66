// A session at the other end of a WebSocket, which is reached anew when it was lost.

/** How soon it is tried again: ms, doubled up to the last. */
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
