// The controls of playing: slider, buttons and speed.

import { clockTime, colour, element, make } from './dom.js';
import { SPEEDS } from './player.js';
import { label, whenSpoken, word } from './words.js';

const MARKS = { message: 'mark-message', event: 'mark-event', slip: 'warn', fall: 'bad', collision: 'bad', fault: 'bad' };

export function timeline(player) {
  const { recording } = player;
  const [slider, strip, play, speed] = ['scrub', 'strip', 'play', 'speed'].map(element);
  slider.addEventListener('input', () => {
    player.pause();
    player.glide(() => player.goTo(Number(slider.value)));
  });
  const buttons = { back: () => player.step(-1), forward: () => player.step(1), earlier: () => player.skip(-1), later: () => player.skip(1) };
  for (const [id, act] of Object.entries(buttons)) element(id).addEventListener('click', act);
  play.addEventListener('click', () => player.toggle());
  for (const value of SPEEDS) speed.append(make('option', { value, textContent: `${value}×` }));
  speed.addEventListener('change', () => player.setSpeed(Number(speed.value)));
  const showState = () => {
    play.dataset.playing = player.playing;
    label(play, player.over ? 'runAgain' : player.playing ? 'pause' : 'play');
    speed.value = player.speed;
  };
  player.onState(showState);
  whenSpoken(showState);
  player.onMove(() => {
    const { place, lastPlace } = player;
    const time = clockTime(recording.told(player.time));
    slider.min = recording.first ?? 0;
    slider.max = lastPlace;
    slider.value = place;
    const text = `${word('cycle')} ${place}, ${time}`;
    slider.setAttribute('aria-valuetext', text);
    const [own, ...others] = player.runs;
    const shown = others.length ? [own, ...others].map(({ recording, cycle }) => `${cycle} / ${recording.cycles - 1}`) : [`${place} / ${lastPlace}`];
    element('now-cycle').textContent = shown.join(' | ');
    element('now-time').textContent = time;
  });
  return { draw: () => drawMarks(strip, player) };
}

/** Draws the marks of a run on the strip under the slider. */
function drawMarks(canvas, { recording, lastPlace, marks }) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const ratio = devicePixelRatio;
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  // The thumb of the slider does not reach the ends of its track.
  const inset = 8;
  const first = recording.first ?? 0;
  const x = (cycle) => inset + ((width - 2 * inset) * (cycle - first)) / Math.max(lastPlace - first, 1);
  for (const { time, kind, run } of marks) {
    const grave = MARKS[kind] === 'bad';
    pen.globalAlpha = run ? 0.45 : 1;
    pen.fillStyle = colour(MARKS[kind]);
    pen.fillRect(x(recording.countAt(time)) - (grave ? 1.5 : 0.75), grave ? 0 : height * 0.35, grave ? 3 : 1.5, height);
  }
}
