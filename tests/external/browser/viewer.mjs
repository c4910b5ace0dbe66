// A viewer of `tip serve` without a page. Tests watch and drive by it.

/** Time between two signs of life: ms. */
const SIGN = 100;
const REST = [5, 5, 5];

export const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));

export class Viewer {
  /** Connects to the address of a page. */
  static async at(address) {
    const url = new URL(address);
    const viewer = new Viewer();
    viewer.socket = new WebSocket(`ws://${url.host}/live${url.search}`, { headers: { Origin: url.origin } });
    [viewer.id, viewer.press, viewer.cycles, viewer.waiting] = [0, 0, 0, new Set()];
    viewer.socket.onmessage = ({ data }) => viewer.take(JSON.parse(data));
    await new Promise((resolve, reject) => Object.assign(viewer.socket, { onopen: resolve, onerror: reject }));
    await viewer.until((robot) => robot);
    return viewer;
  }

  take(update) {
    if (update.type === 'robot') this.robot = update;
    if (update.type === 'status') this.status = update;
    for (const one of this.waiting) {
      if (!one.knows(this.robot, this)) continue;
      this.waiting.delete(one);
      one.resolve(performance.now());
    }
  }

  send(request) {
    this.id += 1;
    this.socket.send(JSON.stringify({ id: this.id, ...request }));
  }

  /** Waits until the robot is in a state; returns the time at which that was heard. */
  until(knows, what = String(knows), patience = 60_000) {
    if (knows(this.robot, this)) return Promise.resolve(performance.now());
    return new Promise((resolve, reject) => {
      const one = { knows, resolve };
      this.waiting.add(one);
      setTimeout(() => this.waiting.delete(one) && reject(new Error(`never: ${what}: ${JSON.stringify(this.robot)}`)), patience).unref();
    });
  }

  /** Holds the button from now on. */
  hold(sticks = REST) {
    this.press += 1;
    clearInterval(this.timer);
    const sign = () => this.send({ do: 'drive', press: this.press, sticks });
    sign();
    this.timer = setInterval(sign, SIGN);
  }

  release() {
    clearInterval(this.timer);
    this.send({ do: 'drive', press: 0, sticks: REST });
  }

  /** Starts the robot. A busy machine may let a press lapse; then it is repeated. */
  async start() {
    this.send({ do: 'take' });
    for (let times = 0; times < 20; times += 1) {
      this.hold();
      const runs = await this.until(({ phase, stage }) => phase === 'running' && stage === 'driven', 'it runs', 4000).catch(() => undefined);
      if (runs) return;
      this.release();
      await wait(100);
    }
    throw new Error(`it does not start: ${JSON.stringify(this.robot)}`);
  }

  close() {
    clearInterval(this.timer);
    this.socket.close();
  }
}

/** Returns the median, the 95th percentile and the maximum of some times. */
export function spread(times) {
  const sorted = [...times].sort((one, other) => one - other);
  const at = (part) => sorted[Math.min(Math.floor(part * sorted.length), sorted.length - 1)].toFixed(1);
  return `${at(0.5)} ms median, ${at(0.95)} 95 %, ${at(1)} worst, of ${sorted.length}`;
}
