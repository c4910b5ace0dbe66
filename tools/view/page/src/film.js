// A video of a canvas, which the browser encodes frame by frame, not in real time.

import { webm } from './webm.js';

const CODEC = { browser: 'vp8', file: 'V_VP8' };
/** Time between two key frames, s. */
const ENTRY = 5;
/** Bits for each pixel of a frame. */
const BITS = 0.15;
/** Maximum number of frames that wait for the encoder. */
const WAITING = 4;

export class Film {
  /** Creates a video of a canvas in its present size; undefined if this browser encodes no video. */
  static async of(canvas, rate) {
    // VP8 needs even sizes: it stores colours at half the size.
    const [width, height] = [canvas.width & ~1, canvas.height & ~1];
    const wanted = { codec: CODEC.browser, width, height, framerate: rate, bitrate: Math.round(width * height * rate * BITS) };
    try {
      const { supported } = await VideoEncoder.isConfigSupported(wanted);
      return supported ? new Film(canvas, rate, wanted) : undefined;
    } catch {
      // The browser has no encoder, or none for a page from this address.
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
    // `add` and `end` reject on an error. Between them nobody awaits the promise, which must not count as unhandled.
    this.failed.catch(() => {});
    this.encoder.configure(wanted);
  }

  /** Adds the present picture of the canvas as a frame. */
  async add() {
    const { width, height } = this.wanted;
    const timestamp = Math.round((this.taken * 1e6) / this.rate);
    const frame = new VideoFrame(this.canvas, { timestamp, duration: Math.round(1e6 / this.rate), visibleRect: { x: 0, y: 0, width, height } });
    this.encoder.encode(frame, { keyFrame: this.taken % Math.round(ENTRY * this.rate) === 0 });
    frame.close();
    this.taken += 1;
    while (this.encoder.encodeQueueSize > WAITING) await Promise.race([new Promise((go) => setTimeout(go, 5)), this.failed]);
  }

  /** Returns the video as a blob. */
  async end() {
    await Promise.race([this.encoder.flush(), this.failed]);
    this.encoder.close();
    const { width, height } = this.wanted;
    return webm(this.frames, { codec: CODEC.file, width, height, each: 1000 / this.rate });
  }

  /** Stops the encoder without a result. */
  discard() {
    this.encoder.close();
  }
}
