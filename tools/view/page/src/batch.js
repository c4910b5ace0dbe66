// Triangles or lines of many colours that change in every frame and are drawn by one call.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

export class Batch {
  /** Creates a batch of a kind (Mesh or LineSegments) with at most `most` corners. */
  constructor(Kind, material, most) {
    const attribute = (array, size, normalized) => new BufferAttribute(array, size, normalized).setUsage(DynamicDrawUsage);
    this.places = attribute(new Float32Array(3 * most), 3, false);
    this.colours = attribute(new Uint8Array(4 * most), 4, true);
    this.most = most;
    this.count = 0;
    const geometry = new BufferGeometry().setAttribute('position', this.places).setAttribute('color', this.colours);
    this.shape = new Kind(geometry, material);
    this.shape.frustumCulled = false;
  }

  /** Begins a frame without corners. */
  begin() {
    this.count = 0;
  }

  /** Sets colour and opacity of the following corners. */
  tint({ r, g, b }, opacity = 1) {
    this.rgba = [r, g, b, opacity].map((share) => Math.round(255 * share));
  }

  corner(x, y, z) {
    if (this.count === this.most) return;
    const [at, [r, g, b, a]] = [this.count++, this.rgba];
    const [places, colours] = [this.places.array, this.colours.array];
    [places[3 * at], places[3 * at + 1], places[3 * at + 2]] = [x, y, z];
    [colours[4 * at], colours[4 * at + 1], colours[4 * at + 2], colours[4 * at + 3]] = [r, g, b, a];
  }

  /** Adds a line through places, each [x, y, z]. */
  path(places) {
    for (let n = 1; n < places.length; n++) {
      this.corner(...places[n - 1]);
      this.corner(...places[n]);
    }
  }

  /** Ends the frame: passes its corners to the graphics. */
  end() {
    for (const attribute of [this.places, this.colours]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.shape.geometry.setDrawRange(0, this.count);
  }
}
