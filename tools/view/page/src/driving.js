// Drives a robot on servos by a button that is held, sticks and a gamepad. It sends signs of life, and shows the servos.

import { element, fixed } from './dom.js';
import { gamepad } from './gamepad.js';
import { Servos } from './servos.js';
import { whenSpoken, word } from './words.js';

/** Time between two signs of life: ms. */
const SIGN = 100;
/** Longest time for which the button is held until the robot starts, ms. */
const STARTS = 1500;
/** Readings of the sticks at rest: V. */
const REST = 5;

/** Texts about the robot, by phase and stage. */
const SAYS = {
  ready: () => 'robotReady',
  approach: (stage) => (stage === 'driven' ? 'robotApproach' : 'robotWaits'),
  running: (stage) => ({ driven: 'robotDriven', paused: 'robotPaused', halt: 'robotHalt', emergency: 'robotEmergency' })[stage],
  leaving: () => 'robotLeaving',
  left: () => 'robotLeft',
};

export class Driving {
  constructor(requests) {
    this.requests = requests;
    this.robot = undefined;
    this.servos = new Servos();
    this.sticks = [REST, REST, REST];
    // `press` is the number of the press that lasts, or 0. `last` is that of the last one.
    [this.press, this.last] = [0, 0];
  }

  /** Moves a stick of a robot on servos; returns false if the robot is no such one. */
  steer(name, volts) {
    if (!this.robot) return false;
    this.sticks[Number(name.at(-1)) - 1] = volts;
    this.sign();
    return true;
  }

  /** Takes the state of a robot on servos. */
  take(robot) {
    const isFirst = !this.robot;
    this.robot = robot;
    this.servos.take(robot);
    if (isFirst) this.begin();
    if (!robot.driver) this.release();
    this.show();
  }

  begin() {
    document.documentElement.dataset.hardware = '';
    element('drive').hidden = false;
    element('servos-box').hidden = false;
    const button = element('hold');
    button.addEventListener('pointerdown', (event) => {
      if (event.button) return;
      button.setPointerCapture(event.pointerId);
      this.hold();
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) button.addEventListener(end, () => this.release());
    button.addEventListener('contextmenu', (event) => event.preventDefault());
    button.addEventListener('keydown', (event) => {
      if (event.key !== ' ' && event.key !== 'Enter') return;
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) this.hold();
    });
    button.addEventListener('keyup', () => this.release());
    // The page does not hear of a release elsewhere.
    window.addEventListener('blur', () => this.release());
    document.addEventListener('visibilitychange', () => this.release());
    this.requests.session.watch?.(() => this.release());
    element('take').addEventListener('click', () => this.requests.send({ do: 'take' }));
    element('give').addEventListener('click', () => this.requests.send({ do: 'give' }));
    setInterval(() => this.sign(), SIGN);
    gamepad({
      steer: (name, volts) => this.steer(name, volts),
      hold: (on) => (on ? this.hold() : this.release()),
      stop: () => element('stop').click(),
      halt: () => element('halt').click(),
    });
    whenSpoken(() => this.show());
  }

  get isHere() {
    return document.visibilityState === 'visible' && document.hasFocus();
  }

  /** Begins a new press of the button. Only a new press moves a robot that rests. */
  hold() {
    if (!this.robot?.driver || this.press || !this.isHere) return;
    this.last += 1;
    this.press = this.last;
    this.since = performance.now();
    this.sign();
    this.show();
  }

  release() {
    if (!this.press) return;
    this.press = 0;
    this.say();
    this.show();
  }

  /** Sends a sign of life if the page is seen. */
  sign() {
    if (!this.robot?.driver) return;
    if (!this.isHere) this.release();
    else this.say();
  }

  say() {
    this.requests.send({ do: 'drive', press: this.press, sticks: this.sticks });
  }

  show() {
    const { driver, held, asked, hold, phase, stage, problem, stopped_in: stopped } = this.robot;
    const says = [word(SAYS[phase](stage))];
    if (!driver) says.unshift(word(held ? 'othersDrive' : 'nobodyDrives'));
    if (phase === 'ready' && this.press && performance.now() - this.since > STARTS) says.push(word('pressAgain'));
    if (driver && asked) says.unshift(word('isAsked'));
    if (stopped !== null) says.push(word('stoppedIn', fixed(stopped, 0)));
    if (problem) says.push(problem);
    element('drive-state').textContent = says.join(' ');
    element('drive-state').classList.toggle('bad', Boolean(problem) || stage === 'emergency');
    const button = element('hold');
    button.textContent = word(phase === 'ready' || phase === 'approach' ? 'holdToStart' : 'holdToDrive');
    button.disabled = !driver || phase === 'leaving' || phase === 'left';
    button.hidden = !hold && phase === 'running' && stage !== 'paused';
    button.setAttribute('aria-pressed', Boolean(this.press));
    element('take').hidden = driver;
    element('give').hidden = !driver;
    this.servos.show(this.robot);
  }
}
