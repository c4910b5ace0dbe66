// The export of images, videos and links.

import { clockTime, element, make } from './dom.js';
import { Film } from './film.js';
import { Gif } from './gif.js';
import { word } from './words.js';
import { zip } from './zip.js';

/** Maximum frame rate of a GIF, 1/s. */
const SLIDES = 20;

export function exporting(player, stage) {
  const dialog = element('export-box');
  const stem = player.recording.script.name.replace(/\.[^.]*$/, '').replace(/[^\w-]+/g, '_') || 'run';
  const status = element('export-status');
  let stopped = false;

  const save = (blob, name) => {
    const link = make('a', { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  };
  const image = () => {
    stage.drawFine();
    return new Promise((resolve) => stage.canvas.toBlob(resolve, 'image/png'));
  };
  const span = () => {
    const seconds = Math.max(Number(element('export-seconds').value) || 0, 0.1);
    return [player.time, Math.min(player.time + seconds * 1000, player.end)];
  };
  const rate = () => Math.min(Math.max(Number(element('export-rate').value) || 25, 1), 60);

  /** Shows each frame of the chosen span and calls `act(n)`. */
  async function each(act, most = Infinity) {
    const [[from, to], per] = [span(), Math.min(rate(), most)];
    const count = Math.floor(((to - from) / 1000) * per * (1 / player.speed)) + 1;
    for (let n = 0; n < count && !stopped; n++) {
      player.goToTime(from + (n * 1000 * player.speed) / per);
      await act(n);
      status.textContent = word('recordingNow', `${n + 1} / ${count}`);
    }
  }

  async function frames() {
    const files = [];
    await each(async (n) => {
      const bytes = new Uint8Array(await (await image()).arrayBuffer());
      files.push({ name: `${stem}-${String(n).padStart(5, '0')}.png`, bytes });
    });
    if (!stopped) save(zip(files), `${stem}.zip`);
  }

  async function video() {
    stage.drawFine();
    const film = await Film.of(stage.canvas, rate());
    if (!film) {
      await frames();
      return stopped ? '' : word('noVideo');
    }
    await each(async () => {
      stage.drawFine();
      await film.add();
      // The browser draws the page and handles a click on the stop button.
      await new Promise((go) => setTimeout(go));
    });
    if (stopped) film.discard();
    else save(await film.end(), `${stem}.webm`);
    return '';
  }

  async function gif() {
    const { canvas } = stage;
    stage.drawFine();
    const made = new Gif(canvas, Math.min(rate(), SLIDES));
    await each(async () => {
      stage.drawFine();
      made.add(clockTime(player.recording.told(player.time)), player.recording.messageAt(player.cycle));
      await new Promise((go) => setTimeout(go));
    }, SLIDES);
    if (!stopped) save(made.end(), `${stem}.gif`);
  }

  /** Returns a handler that runs an export with a stop button, and then restores the time of the player. */
  const doing = (what) => async () => {
    stopped = false;
    player.pause();
    const { time } = player;
    dialog.classList.add('busy');
    status.textContent = '';
    try {
      status.textContent = (await what()) ?? '';
    } catch ({ message }) {
      status.textContent = message;
    } finally {
      player.goToTime(time);
      dialog.classList.remove('busy');
    }
  };
  const copy = (text) => async () => {
    try {
      await navigator.clipboard.writeText(text());
      status.textContent = word('copied');
    } catch {
      // A page in a file may not use the clipboard. The text is shown instead.
      status.textContent = text();
    }
  };
  const address = () => `${location.href.split('#')[0]}#cycle=${player.place}`;
  const quoted = (text) => text.replace(/&/g, '&amp;').replace(/"/g, '&quot;');
  element('save-image').addEventListener('click', doing(async () => save(await image(), `${stem}-${player.place}.png`)));
  element('save-frames').addEventListener('click', doing(frames));
  element('save-gif').addEventListener('click', doing(gif));
  element('save-video').addEventListener('click', doing(video));
  element('stop-export').addEventListener('click', () => (stopped = true));
  element('copy-link').addEventListener('click', copy(address));
  element('copy-embed').addEventListener('click', copy(() => `<iframe src="${quoted(address())}" width="960" height="640" style="border:0" allow="fullscreen"></iframe>`));
}
