// Sticks of a control box: keys and a pad move the inputs VR1 to VR3 of a program that reads them. Released sticks spring back.

import { element } from './dom.js';

/** Readings of a stick at rest and at its ends, V. */
const REST = 5;
const [LOW, HIGH] = [0, 10];
/** The stick that a key moves, and the reading to which it does, by the key's place on the keyboard. */
const KEYS = {
  KeyW: ['VR1', HIGH], ArrowUp: ['VR1', HIGH], KeyS: ['VR1', LOW], ArrowDown: ['VR1', LOW],
  KeyA: ['VR2', HIGH], ArrowLeft: ['VR2', HIGH], KeyD: ['VR2', LOW], ArrowRight: ['VR2', LOW],
  KeyE: ['VR3', HIGH], KeyQ: ['VR3', LOW],
};

/** Returns true if a program reads all sticks; one that reads fewer has knobs, which stay where they are put. */
function readsSticks({ text }) {
  const code = text.replace(/\/\/.*/g, '');
  return [1, 2, 3].every((n) => new RegExp(`\\bAD_IN[\\s,]+VR${n}\\b`, 'i').test(code));
}

export function sticks(happen, recording) {
  const isRead = () => readsSticks(recording.script);
  const shown = {};
  const move = (name, volts) => {
    if (shown[name] === volts) return;
    shown[name] = volts;
    happen(`${name}=${volts}`);
  };
  // Of the pressed keys of a stick, the last one counts. When it is released, the one before counts again.
  const pressed = [];
  const follow = (name) => {
    const last = pressed.findLast((code) => KEYS[code][0] === name);
    move(name, last ? KEYS[last][1] : REST);
  };
  const release = (code) => {
    const place = pressed.indexOf(code);
    if (place < 0) return;
    pressed.splice(place, 1);
    follow(KEYS[code][0]);
  };
  // The capture phase comes before the page's shortcuts, which include arrow keys.
  document.addEventListener('keydown', (event) => {
    const { target, code } = event;
    const typing = target.isContentEditable || target.closest('dialog, select, textarea, input, [role=tab]');
    if (typing || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || !(code in KEYS) || !isRead()) return;
    event.preventDefault();
    event.stopPropagation();
    if (pressed.includes(code)) return;
    pressed.push(code);
    follow(KEYS[code][0]);
  }, true);
  document.addEventListener('keyup', ({ code }) => release(code), true);
  // The page gets no event for a key that is released elsewhere.
  window.addEventListener('blur', () => [...pressed].forEach(release));

  const pad = element('stick');
  const thumb = pad.firstElementChild;
  const place = (right, ahead) => {
    thumb.style.transform = `translate(${right * 100}%, ${-ahead * 100}%)`;
  };
  const part = (at, from, size) => Math.min(Math.max((2 * (at - from)) / size - 1, -1), 1);
  let [due, aim] = [];
  const steer = ({ clientX, clientY }) => {
    const { left, top, width, height } = pad.getBoundingClientRect();
    const [right, ahead] = [part(clientX, left, width), -part(clientY, top, height)];
    place(right, ahead);
    aim = [ahead, -right];
    // One event for each frame, however fast the pointer moves.
    due ??= requestAnimationFrame(() => {
      due = undefined;
      aim?.forEach((share, n) => move(`VR${n + 1}`, Math.round(10 * (REST + share * REST)) / 10));
    });
  };
  const rest = () => {
    aim = undefined;
    place(0, 0);
    move('VR1', REST);
    move('VR2', REST);
  };
  pad.addEventListener('pointerdown', (event) => {
    pad.setPointerCapture(event.pointerId);
    steer(event);
  });
  pad.addEventListener('pointermove', (event) => pad.hasPointerCapture(event.pointerId) && steer(event));
  for (const end of ['pointerup', 'pointercancel']) pad.addEventListener(end, rest);
  return {
    /** Shows the pad of a run that begins, if its program reads a stick. */
    begin() {
      pad.hidden = !isRead();
      for (const name of Object.keys(shown)) delete shown[name];
      pressed.length = 0;
    },
  };
}
