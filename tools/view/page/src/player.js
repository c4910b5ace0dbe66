// Where in the run one is, and going on from there.

/** How often what nobody reads is shown while one glides along: ms. */
const SELDOM = 90;

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10];

export class Player {
  constructor(recording) {
    this.recording = recording;
    this.time = recording.endOf(0);
    this.speed = 1;
    this.playing = false;
    this.gliding = false;
    this.listeners = [];
    this.stateListeners = [];
  }

  get cycle() {
    return this.recording.cycleAt(this.time);
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
    this.time = Math.min(Math.max(time, first), this.recording.duration);
    this.listeners.forEach((listener) => listener());
  }

  goTo(cycle) {
    const last = this.recording.cycles - 1;
    this.goToTime(this.recording.endOf(Math.min(Math.max(cycle, 0), last)));
  }

  step(cycles) {
    this.pause();
    this.goTo(this.cycle + cycles);
  }

  /** To the next mark, or back to the one before. */
  skip(way) {
    const cycles = this.recording.marks.map((mark) => mark.cycle);
    const ordered = way > 0 ? cycles : cycles.toReversed();
    const next = ordered.find((cycle) => (cycle - this.cycle) * way > 0);
    this.pause();
    this.goTo(next ?? (way > 0 ? this.recording.cycles - 1 : 0));
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
    if (this.time >= this.recording.duration) this.goTo(0);
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
    if (this.time >= this.recording.duration) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }

  changed() {
    this.stateListeners.forEach((listener) => listener());
  }
}
