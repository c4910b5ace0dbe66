// The player keeps the present time of a recording, and changes it.

/** Time between two updates of details while the player moves, ms. */
const SELDOM = 90;

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10];

export class Player {
  /**
   * Creates the player of a recording, and of another one to compare with it, which may be longer and whose program differs by
   * `changes`.
   */
  constructor(recording, other, changes) {
    Object.assign(this, { recording, other, changes });
    // The alignment is undefined if times of both runs are equal.
    this.alignment = undefined;
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

  /** Returns the present cycle. It counts on after the recording's end while the other one continues. */
  get place() {
    return this.recording.countAt(this.time);
  }

  /** Returns the last cycle of the longer recording. */
  get lastPlace() {
    return this.recording.countAt(this.end);
  }

  /** Returns the end of the recording that ends last, ms. */
  get end() {
    return Math.max(this.recording.duration, this.other ? this.ownTime(this.other.duration) : 0);
  }

  /** Returns the time of the other run that belongs to a time, ms. */
  otherTime(time) {
    return this.alignment?.toOther(time) ?? time;
  }

  /** Returns the time that belongs to a time of the other run, ms. */
  ownTime(time) {
    return this.alignment?.toOwn(time) ?? time;
  }

  /** Returns the runs with their present times and cycles. A run that is over stays at its end. */
  get runs() {
    const at = (recording, time) => ({ recording, time: Math.min(time, recording.duration), cycle: recording.cycleAt(time) });
    return [at(this.recording, this.time), ...(this.other ? [at(this.other, this.otherTime(this.time))] : [])];
  }

  /** Returns the marks of both runs in order of time: `{ cycle, kind, value, run, time }`. `time` is that of the player, ms. */
  get marks() {
    const of = ({ recording }, run) => recording.marks.map((mark) => ({ ...mark, run, time: run ? this.ownTime(recording.endOf(mark.cycle)) : recording.endOf(mark.cycle) }));
    return this.runs.flatMap(of).sort((one, other) => one.time - other.time);
  }

  /** Calls a function at each change of the time. */
  onMove(listener) {
    this.listeners.push(listener);
  }

  /** Calls a function for details that nobody reads in motion. It is called now and then while the player moves, and when it stops. */
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

  /** Changes the time as a part of a motion. */
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

  /** Goes to a cycle of one of the runs; the first one is 0. */
  goToMoment({ cycle, run = 0 }) {
    if (run) this.goToTime(this.ownTime(this.other.endOf(cycle)));
    else this.goTo(cycle);
  }

  step(cycles) {
    this.pause();
    this.goTo(this.place + cycles);
  }

  /** Goes to the next mark, or back to the previous one. */
  skip(way) {
    const cycles = this.marks.map(({ time }) => this.recording.countAt(time));
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
