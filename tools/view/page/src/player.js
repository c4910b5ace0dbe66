// Where in the run one is, and going on from there.

/** How often what nobody reads is shown while one glides along: ms. */
const SELDOM = 90;

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10];

export class Player {
  /** Of a recording, and of another one that is compared with it and may be longer. */
  constructor(recording, other) {
    Object.assign(this, { recording, other });
    this.time = recording.endOf(0);
    this.speed = 1;
    this.playing = false;
    this.gliding = false;
    this.listeners = [];
    this.stateListeners = [];
  }

  get cycle() {
    return Math.min(this.place, this.recording.cycles - 1);
  }

  /** The cycle where one is; it counts on after the recording's end while the other one still runs. */
  get place() {
    return this.recording.countAt(this.time);
  }

  /** The place where the longer one ends. */
  get lastPlace() {
    return this.recording.countAt(this.end);
  }

  /** When the longer one ends: ms. */
  get end() {
    return Math.max(this.recording.duration, this.other?.duration ?? 0);
  }

  /** Calls a function whenever one is elsewhere. */
  onMove(listener) {
    this.listeners.push(listener);
  }

  /** The same for what nobody reads while it flies by: every so often while one glides along, at once where one stops. */
  onRest(listener) {
    let [last, due] = [0, undefined];
    const call = () => {
      clearTimeout(due);
      [last, due] = [performance.now(), undefined];
      listener();
    };
    this.onMove(() => {
      const left = this.gliding ? last + SELDOM - performance.now() : 0;
      if (left <= 0) call();
      else due ??= setTimeout(call, left);
    });
  }

  /** Calls a function whenever playing begins or ends, or the speed changes. */
  onState(listener) {
    this.stateListeners.push(listener);
  }

  /** Goes somewhere on the way to elsewhere. */
  glide(go) {
    this.gliding = true;
    go();
    this.gliding = false;
  }

  goToTime(time) {
    const first = this.recording.endOf(0);
    this.time = Math.min(Math.max(time, first), this.end);
    this.listeners.forEach((listener) => listener());
  }

  goTo(cycle) {
    this.goToTime(this.recording.endOf(Math.min(Math.max(cycle, 0), this.lastPlace)));
  }

  step(cycles) {
    this.pause();
    this.goTo(this.place + cycles);
  }

  /** To the next mark, or back to the one before. */
  skip(way) {
    const cycles = this.recording.marks.map((mark) => mark.cycle);
    const ordered = way > 0 ? cycles : cycles.toReversed();
    const next = ordered.find((cycle) => (cycle - this.place) * way > 0);
    this.pause();
    this.goTo(next ?? (way > 0 ? this.lastPlace : 0));
  }

  setSpeed(speed) {
    this.speed = speed;
    this.changed();
  }

  changeSpeed(way) {
    const at = SPEEDS.indexOf(this.speed) + way;
    this.setSpeed(SPEEDS[Math.min(Math.max(at, 0), SPEEDS.length - 1)]);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.end) this.goTo(0);
    this.playing = true;
    this.last = undefined;
    this.changed();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.changed();
    this.listeners.forEach((listener) => listener());
  }

  tick(now) {
    if (!this.playing) return;
    const passed = now - (this.last ?? now);
    this.last = now;
    this.glide(() => this.goToTime(this.time + passed * this.speed));
    if (this.time >= this.end) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }

  changed() {
    this.stateListeners.forEach((listener) => listener());
  }
}
