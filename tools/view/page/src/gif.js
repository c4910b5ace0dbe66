// A small GIF of a canvas for slides. Each frame shows the time and the message of the program.

import { GIFEncoder, applyPalette, quantize } from 'gifenc';
import { colour } from './dom.js';

/** Maximum width, px. */
const WIDTH = 640;
const COLOURS = 128;

export class Gif {
  /** Creates a GIF of a canvas in its present size, with `rate` frames per second. */
  constructor(canvas, rate) {
    const width = Math.min(canvas.width, WIDTH);
    const height = Math.round((canvas.height * width) / canvas.width);
    const copy = Object.assign(document.createElement('canvas'), { width, height });
    Object.assign(this, { canvas, width, height, delay: 1000 / rate, pen: copy.getContext('2d', { willReadFrequently: true }), encoder: GIFEncoder() });
  }

  /** Adds the present picture of the canvas as a frame. */
  add(time, message) {
    const { canvas, width, height, pen, encoder, delay } = this;
    pen.drawImage(canvas, 0, 0, width, height);
    Object.assign(pen, { font: '600 16px ui-monospace, "Cascadia Mono", Menlo, Consolas, monospace', textBaseline: 'top', fillStyle: colour('text') });
    pen.fillText(time, 12, 12);
    if (message) pen.fillText(message, 12, height - 28, width - 24);
    const { data } = pen.getImageData(0, 0, width, height);
    // All frames share a palette, so that colours do not flicker.
    this.palette ??= quantize(data, COLOURS);
    encoder.writeFrame(applyPalette(data, this.palette), width, height, { palette: this.palette, delay });
  }

  end() {
    this.encoder.finish();
    return new Blob([this.encoder.bytesView()], { type: 'image/gif' });
  }
}
