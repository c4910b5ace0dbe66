// Parts of different colours that move with bones, as one mesh: one call draws them all.

import { BufferAttribute, Color, Matrix4, Skeleton, SkinnedMesh } from 'three';
import { mergeGeometries, mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

export class Solid extends SkinnedMesh {
  /** Of parts { geometry, name, leg, bone }: the name and the leg choose the colour, the bone is one of `bones` by its number. */
  constructor(parts, bones, material) {
    const geometries = parts.map(({ geometry, bone }) => {
      geometry.deleteAttribute('uv');
      const merged = geometry.index ? geometry : mergeVertices(geometry);
      const { count } = merged.attributes.position;
      const [indices, weights] = [new Uint16Array(4 * count), new Float32Array(4 * count)];
      for (let at = 0; at < 4 * count; at += 4) [indices[at], weights[at]] = [bone, 1];
      merged.setAttribute('skinIndex', new BufferAttribute(indices, 4));
      return merged.setAttribute('skinWeight', new BufferAttribute(weights, 4));
    });
    super(mergeGeometries(geometries), material);
    this.parts = parts.map((part, n) => ({ ...part, vertices: geometries[n].attributes.position.count }));
    const { count } = this.geometry.attributes.position;
    this.geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * count), 3));
    this.castShadow = true;
    this.receiveShadow = true;
    // Its bones are where it is.
    this.frustumCulled = false;
    const still = bones.map(() => new Matrix4());
    this.bind(new Skeleton(bones, still), new Matrix4());
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
