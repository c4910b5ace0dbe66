// Images, videos and links.

import { element, make } from './dom.js';
import { word } from './words.js';
import { zip } from './zip.js';

const VIDEO = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

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
    return [player.time, Math.min(player.time + seconds * 1000, player.recording.duration)];
  };
  const rate = () => Math.min(Math.max(Number(element('export-rate').value) || 25, 1), 60);

  async function frames() {
    const [from, to] = span();
    const files = [];
    const count = Math.floor(((to - from) / 1000) * rate() * (1 / player.speed)) + 1;
    for (let n = 0; n < count && !stopped; n++) {
      player.goToTime(from + (n * 1000 * player.speed) / rate());
      const bytes = new Uint8Array(await (await image()).arrayBuffer());
      files.push({ name: `${stem}-${String(n).padStart(5, '0')}.png`, bytes });
      status.textContent = word('recordingNow', `${n + 1} / ${count}`);
    }
    if (!stopped) save(zip(files), `${stem}.zip`);
  }

  async function video() {
    const type = window.MediaRecorder && VIDEO.find((type) => MediaRecorder.isTypeSupported(type));
    if (!type) {
      status.textContent = word('noVideo');
      return;
    }
    const [, to] = span();
    const recorder = new MediaRecorder(stage.canvas.captureStream(rate()), { mimeType: type, videoBitsPerSecond: 8_000_000 });
    const parts = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    const over = new Promise((resolve) => (recorder.onstop = resolve));
    recorder.start();
    player.play();
    while (player.playing && player.time < to && !stopped) {
      status.textContent = word('recordingNow', `${(player.time / 1000).toFixed(1)} s`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    player.pause();
    recorder.stop();
    await over;
    if (!stopped) save(new Blob(parts, { type }), `${stem}.webm`);
  }

  /** One at a time, with a button to stop it. */
  const doing = (what) => async () => {
    stopped = false;
    player.pause();
    dialog.classList.add('busy');
    status.textContent = '';
    await what();
    dialog.classList.remove('busy');
    if (status.textContent !== word('noVideo')) status.textContent = '';
  };
  const copy = (text) => async () => {
    try {
      await navigator.clipboard.writeText(text());
      status.textContent = word('copied');
    } catch {
      // A page in a file may not: what is to be copied is shown instead.
      status.textContent = text();
    }
  };
  const address = () => `${location.href.split('#')[0]}#cycle=${player.cycle}`;
  const quoted = (text) => text.replace(/&/g, '&amp;').replace(/"/g, '&quot;');
  element('save-image').addEventListener('click', doing(async () => save(await image(), `${stem}-${player.cycle}.png`)));
  element('save-frames').addEventListener('click', doing(frames));
  element('save-video').addEventListener('click', doing(video));
  element('stop-export').addEventListener('click', () => (stopped = true));
  element('copy-link').addEventListener('click', copy(address));
  element('copy-embed').addEventListener('click', copy(() => `<iframe src="${quoted(address())}" width="960" height="640" style="border:0" allow="fullscreen"></iframe>`));
}
