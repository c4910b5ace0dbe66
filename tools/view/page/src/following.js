// Where one looks in a run that goes on: at its newest cycle, or back at what was, while it goes on or rests.

import { element } from './dom.js';
import { Player } from './player.js';

export class FollowingPlayer extends Player {
  constructor(recording, requests) {
    super(recording);
    this.requests = requests;
    this.following = true;
  }

  /** What the session says of the run. */
  takeStatus({ playing, speed, over }) {
    Object.assign(this, { playing, speed, over: Boolean(over) });
    this.changed();
  }

  /** There is more to see. */
  grown() {
    const go = () => this.goToTime(this.following ? this.recording.duration : this.time);
    if (this.playing) this.glide(go);
    else go();
  }

  goToTime(time) {
    super.goToTime(Math.max(time, this.recording.endOf(this.recording.first)));
  }

  goTo(cycle) {
    this.look(cycle >= this.recording.cycles - 1);
    super.goTo(cycle);
  }

  /** At the newest cycle from now on, or at what was. */
  look(following) {
    if (this.following === following) return;
    this.following = following;
    this.changed();
  }

  /** The run itself goes so many cycles forward or back, unless one looks at what was, or it only goes forward. */
  step(cycles) {
    if (this.goesForward || !this.following || !Number.isFinite(cycles) || Math.abs(cycles) > 1) return this.goTo(this.cycle + cycles);
    return this.requests.send({ do: 'step', cycles });
  }

  /** The run goes on from where one looks. */
  goOnFromHere() {
    if (!this.following) {
      this.requests.send({ do: 'go', cycle: this.cycle });
      this.requests.send({ do: 'play' });
    }
    this.newest();
  }

  newest() {
    this.goTo(this.recording.cycles - 1);
  }

  setSpeed(speed) {
    this.requests.send({ do: 'speed', times: speed });
  }

  /** A run that is over is run again. */
  toggle() {
    if (this.over) return element('restart').click();
    this.requests.send({ do: this.playing ? 'pause' : 'play' });
    if (!this.playing) this.newest();
    return undefined;
  }

  /** Looks at what was; the run does what it does. */
  pause() {
    this.look(false);
  }
}
