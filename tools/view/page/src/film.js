// A film of a canvas, frame by frame, however long each takes; encoded by the browser.

import { webm } from './webm.js';

const CODEC = { browser: 'vp8', file: 'V_VP8' };
/** How often a film can be entered: s. */
const ENTRY = 5;
/** Of one pixel of one frame: bits. */
const BITS = 0.15;
/** So many frames may wait for the encoder. */
const WAITING = 4;

export class Film {
  /** Of a canvas as large as it is now; none if this browser encodes no video. */
  static async of(canvas, rate) {
    // VP8 halves colours in both directions.
    const [width, height] = [canvas.width & ~1, canvas.height & ~1];
    const wanted = { codec: CODEC.browser, width, height, framerate: rate, bitrate: Math.round(width * height * rate * BITS) };
    try {
      const { supported } = await VideoEncoder.isConfigSupported(wanted);
      return supported ? new Film(canvas, rate, wanted) : undefined;
    } catch {
      // No encoder at all, or none for a page from such an address.
      return undefined;
    }
  }

  constructor(canvas, rate, wanted) {
    Object.assign(this, { canvas, rate, wanted, frames: [], taken: 0 });
    this.failed = new Promise((_, fail) => {
      const output = (chunk) => {
        const bytes = new Uint8Array(chunk.byteLength);
        chunk.copyTo(bytes);
        this.frames.push({ bytes, time: Math.round(chunk.timestamp / 1000), isKey: chunk.type === 'key' });
      };
      this.encoder = new VideoEncoder({ output, error: fail });
    });
    // Who waits for the encoder hears of it; nobody may wait.
    this.failed.catch(() => {});
    this.encoder.configure(wanted);
  }

  /** What the canvas shows is the next frame. */
  async add() {
    const { width, height } = this.wanted;
    const timestamp = Math.round((this.taken * 1e6) / this.rate);
    const frame = new VideoFrame(this.canvas, { timestamp, duration: Math.round(1e6 / this.rate), visibleRect: { x: 0, y: 0, width, height } });
    this.encoder.encode(frame, { keyFrame: this.taken % Math.round(ENTRY * this.rate) === 0 });
    frame.close();
    this.taken += 1;
    while (this.encoder.encodeQueueSize > WAITING) await Promise.race([new Promise((go) => setTimeout(go, 5)), this.failed]);
  }

  /** The whole film. */
  async end() {
    await Promise.race([this.encoder.flush(), this.failed]);
    this.encoder.close();
    const { width, height } = this.wanted;
    return webm(this.frames, { codec: CODEC.file, width, height, each: 1000 / this.rate });
  }

  /** Nobody wants it. */
  discard() {
    this.encoder.close();
  }
}
