// The player of a live run. It follows the newest cycle, or shows an earlier one while the run continues or is paused.

import { element } from './dom.js';
import { Player } from './player.js';

export class FollowingPlayer extends Player {
  constructor(recording, requests) {
    super(recording);
    this.requests = requests;
    this.following = true;
  }

  /** Takes the status of the run from the session. */
  takeStatus({ playing, speed, over }) {
    Object.assign(this, { playing, speed, over: Boolean(over) });
    this.changed();
  }

  /** Shows the new cycles, if the player follows the run. */
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

  /** Begins or stops following the newest cycle. */
  look(following) {
    if (this.following === following) return;
    this.following = following;
    this.changed();
  }

  /**
   * Steps the run itself by some cycles, or the view if it shows an earlier cycle, if the step is longer than one cycle, or if the
   * run only goes forward.
   */
  step(cycles) {
    if (this.goesForward || !this.following || !Number.isFinite(cycles) || Math.abs(cycles) > 1) return this.goTo(this.cycle + cycles);
    return this.requests.send({ do: 'step', cycles });
  }

  /** Continues the run from the cycle that is shown. */
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

  /** Plays or pauses the run; restarts a run that is over. */
  toggle() {
    if (this.over) return element('restart').click();
    this.requests.send({ do: this.playing ? 'pause' : 'play' });
    if (!this.playing) this.newest();
    return undefined;
  }

  /** Stops following. The run itself is not paused. */
  pause() {
    this.look(false);
  }
}
