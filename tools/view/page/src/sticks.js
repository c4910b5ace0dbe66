// Sticks of a control box: keys and pads move the inputs VR1 to VR3 of a program that reads them. Released sticks spring back.

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

/** `steer(name, volts)` moves a stick. */
export function sticks(steer, recording) {
  const isRead = () => readsSticks(recording.script);
  const shown = {};
  const move = (name, volts) => {
    if (shown[name] === volts) return;
    shown[name] = volts;
    steer(name, volts);
  };
  // Of the pressed keys of a stick, the last one counts. When it is released, the one before counts again.
  const pressed = [];
  const followKeys = (name) => {
    const last = pressed.findLast((code) => KEYS[code][0] === name);
    move(name, last ? KEYS[last][1] : REST);
  };
  const release = (code) => {
    const place = pressed.indexOf(code);
    if (place < 0) return;
    pressed.splice(place, 1);
    followKeys(KEYS[code][0]);
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
    followKeys(KEYS[code][0]);
  }, true);
  document.addEventListener('keyup', ({ code }) => release(code), true);
  // The page gets no event for a key that is released elsewhere.
  window.addEventListener('blur', () => [...pressed].forEach(release));

  const part = (at, from, size) => Math.min(Math.max((2 * (at - from)) / size - 1, -1), 1);
  /** A pad whose thumb is moved to the right and ahead, and what it does to the sticks then, as shares of their ranges. */
  const pad = (box, aims) => {
    const thumb = box.firstElementChild;
    const names = Object.keys(aims(0, 0));
    const place = (right, ahead) => {
      thumb.style.transform = `translate(${right * 100}%, ${-ahead * 100}%)`;
    };
    let [due, aim] = [];
    const follow = ({ clientX, clientY }) => {
      const { left, top, width, height } = box.getBoundingClientRect();
      const [right, ahead] = [part(clientX, left, width), -part(clientY, top, height)];
      place(right, box.dataset.flat === undefined ? ahead : 0);
      aim = aims(right, ahead);
      // One event for each frame, however fast the pointer moves.
      due ??= requestAnimationFrame(() => {
        due = undefined;
        for (const [name, share] of Object.entries(aim ?? {})) move(name, Math.round(10 * (REST + share * REST)) / 10);
      });
    };
    const rest = () => {
      aim = undefined;
      place(0, 0);
      names.forEach((name) => move(name, REST));
    };
    box.addEventListener('pointerdown', (event) => {
      box.setPointerCapture(event.pointerId);
      follow(event);
    });
    box.addEventListener('pointermove', (event) => box.hasPointerCapture(event.pointerId) && follow(event));
    for (const end of ['pointerup', 'pointercancel']) box.addEventListener(end, rest);
    return box;
  };
  const pads = [
    pad(element('stick'), (right, ahead) => ({ VR1: ahead, VR2: -right })),
    pad(element('sidestep'), (right) => ({ VR3: right })),
  ];
  return {
    /** Shows the pads of a run that begins, if its program reads sticks. */
    begin() {
      pads.forEach((box) => (box.hidden = !isRead()));
      for (const name of Object.keys(shown)) delete shown[name];
      pressed.length = 0;
    },
  };
}
