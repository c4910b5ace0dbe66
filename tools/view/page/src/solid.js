// Parts of different colours that never move against each other, as one mesh: one call draws them.

import { BufferAttribute, Color, Mesh } from 'three';
import { mergeGeometries, mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

export class Solid extends Mesh {
  /** Of parts { geometry, name, leg }: the name and the leg choose the colour. */
  constructor(parts, material) {
    const geometries = parts.map(({ geometry }) => {
      geometry.deleteAttribute('uv');
      return geometry.index ? geometry : mergeVertices(geometry);
    });
    super(mergeGeometries(geometries), material);
    this.parts = parts.map((part, n) => ({ ...part, vertices: geometries[n].attributes.position.count }));
    const { count } = this.geometry.attributes.position;
    this.geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * count), 3));
    this.castShadow = true;
    this.receiveShadow = true;
  }

  /** Paints each part as `of` says. */
  recolour(of) {
    const { color } = this.geometry.attributes;
    let at = 0;
    for (const part of this.parts) {
      const { r, g, b } = new Color(of(part));
      for (let end = at + part.vertices; at < end; at++) color.setXYZ(at, r, g, b);
    }
    color.needsUpdate = true;
  }
}
