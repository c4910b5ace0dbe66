// Triangles or lines of many colours that are others in every frame: one call draws them all.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

export class Batch {
  /** Of a kind (Mesh or LineSegments), with at most so many corners. */
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

  /** Nothing yet, in the frame that is made. */
  begin() {
    this.count = 0;
  }

  /** Corners from now on are of a colour, so opaque. */
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

  /** A line through all of these places, each [x, y, z]. */
  path(places) {
    for (let n = 1; n < places.length; n++) {
      this.corner(...places[n - 1]);
      this.corner(...places[n]);
    }
  }

  /** That is all. */
  end() {
    for (const attribute of [this.places, this.colours]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.shape.geometry.setDrawRange(0, this.count);
  }
}
