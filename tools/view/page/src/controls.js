// The inputs of a live run: keys, knobs, pushes, halt, emergency stop.

import { element, make } from './dom.js';
import { sticks } from './sticks.js';
import { label, whenSpoken, word } from './words.js';

/** The highest reading of an input, V. */
const VOLTS = 10;
/** The events of keys that write no character. */
const CODES = { Enter: 'key 0x0D', Escape: 'halt', Backspace: 'key 0x08' };

/** `driving` takes the sticks of a robot on servos. */
export function controls(requests, recording, driving) {
  const happen = (event) => requests.send({ do: 'event', event });
  element('stop').addEventListener('click', () => happen(CODES.Enter));
  // A paused run receives the halt request only when it continues.
  let asked = false;
  element('halt').addEventListener('click', () => {
    happen(CODES.Escape);
    asked = true;
    showHalt();
  });
  const showHalt = () => {
    const taken = recording.entries('event').values.includes('halt');
    asked &&= !taken;
    const pending = recording.outcome.how === 'limit' && (asked || taken);
    element('halt').setAttribute('aria-pressed', pending);
    element('halt').textContent = word(pending ? 'halting' : 'halt');
  };
  whenSpoken(showHalt);
  const field = (name) => Number(element(`push-${name}`).value) || 0;
  element('push').addEventListener('submit', (event) => {
    event.preventDefault();
    happen(`push ${field('x')} ${field('y')} ${field('z')} for ${Math.max(Math.round(field('cycles')), 1)}`);
  });
  const keys = element('keys');
  keys.addEventListener('keydown', (event) => {
    event.stopPropagation();
    if (!(event.key in CODES) || event.isComposing) return;
    event.preventDefault();
    happen(CODES[event.key]);
  });
  // Characters come as input, from a keyboard and from a screen.
  keys.addEventListener('input', (event) => {
    if (event.isComposing) return;
    for (const char of keys.value) {
      const byte = char.codePointAt(0);
      if (byte < 128) happen(`key 0x${byte.toString(16).padStart(2, '0')}`);
    }
    keys.value = '';
  });
  whenSpoken(() => (keys.placeholder = word('typeHere')));
  const stick = sticks((name, volts) => driving.steer(name, volts) || happen(`${name}=${volts}`), recording);
  let knobs = [];
  /** Shows the inputs of a run that begins. */
  const begin = () => {
    asked = false;
    stick.begin();
    knobs = recording.inputs.map((name) => knob(name, happen));
    const isKnob = ({ name }) => name.startsWith('VR');
    element('knobs').replaceChildren(...knobs.filter(isKnob).map(({ box }) => box));
    element('other-inputs').replaceChildren(...knobs.filter((knob) => !isKnob(knob)).map(({ box }) => box));
    element('other-inputs-box').hidden = !element('other-inputs').childElementCount;
    // Only a walking robot with mass can be pushed; only such a robot has forces in three directions.
    element('push').hidden = !recording.robot.body || !recording.has('force.0.0');
  };
  begin();
  whenSpoken(() => knobs.forEach((knob) => knob.say()));
  const show = () => {
    knobs.forEach((knob) => knob.show(recording));
    showHalt();
  };
  return { begin, show };
}

/** Creates the slider of an input. It also shows values that other viewers set. */
function knob(name, happen) {
  const slider = make('input', { type: 'range', min: 0, max: VOLTS, step: 0.1, value: 0 });
  slider.dataset.input = name;
  const reading = make('output', { textContent: '0.0 V' });
  const show = () => (reading.textContent = `${Number(slider.value).toFixed(1)} V`);
  let due;
  slider.addEventListener('input', () => {
    show();
    // One event for each frame, however fast the pointer moves.
    due ??= requestAnimationFrame(() => {
      due = undefined;
      happen(`${name}=${slider.value}`);
    });
  });
  const say = () => label(slider, 'input', name);
  say();
  let last;
  return {
    name,
    say,
    box: make('label', { className: 'knob' }, make('span', { textContent: name }), slider, reading),
    show(recording) {
      const { values } = recording.entries('event');
      if (values.length === last) return;
      last = values.length;
      const own = values.findLast((text) => text.startsWith(`${name}=`));
      const volts = own ? Number(own.slice(name.length + 1)) : 0;
      if (slider.matches(':active') || !Number.isFinite(volts)) return;
      slider.value = volts;
      show();
    },
  };
}
