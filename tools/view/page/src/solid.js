// Parts of different colours that move with bones, as one mesh that one call draws. Each corner moves with one bone. There are
// few corners, so they are moved here once for all passes. A skinning shader would compute four bones for each corner and pass.

import { BufferAttribute, Color, DynamicDrawUsage, Mesh } from 'three';
import { mergeGeometries, mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

export class Solid extends Mesh {
  /** Creates a mesh of parts { geometry, name, leg, bone }: name and leg choose the colour; bone is an index. */
  constructor(parts, material) {
    const geometries = parts.map(({ geometry }) => {
      geometry.deleteAttribute('uv');
      return geometry.index ? geometry : mergeVertices(geometry);
    });
    super(mergeGeometries(geometries), material);
    this.parts = parts.map(({ name, leg, bone }, n) => ({ name, leg, bone, vertices: geometries[n].attributes.position.count }));
    const { position, normal } = this.geometry.attributes;
    this.moving = [position, normal].map((attribute) => ({ attribute: attribute.setUsage(DynamicDrawUsage), still: attribute.array.slice() }));
    this.geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * position.count), 3));
    this.castShadow = true;
    this.receiveShadow = true;
    // The bounding sphere of the mesh does not move with its parts.
    this.frustumCulled = false;
  }

  /** Gives each part the colour that `of` returns. */
  paint(of) {
    const { color } = this.geometry.attributes;
    let at = 0;
    for (const part of this.parts) {
      const { r, g, b } = new Color(of(part));
      for (let end = at + part.vertices; at < end; at++) color.setXYZ(at, r, g, b);
    }
    color.needsUpdate = true;
  }

  /** Moves the bones to these matrices. */
  move(bones) {
    this.moving.forEach(({ attribute, still }, kind) => {
      // Positions are shifted and turned, normals only turned.
      const shift = kind === 0 ? 1 : 0;
      const { array } = attribute;
      let at = 0;
      for (const { bone, vertices } of this.parts) {
        const m = bones[bone].elements;
        for (const end = at + 3 * vertices; at < end; at += 3) {
          const [x, y, z] = [still[at], still[at + 1], still[at + 2]];
          array[at] = m[0] * x + m[4] * y + m[8] * z + shift * m[12];
          array[at + 1] = m[1] * x + m[5] * y + m[9] * z + shift * m[13];
          array[at + 2] = m[2] * x + m[6] * y + m[10] * z + shift * m[14];
        }
      }
      attribute.needsUpdate = true;
    });
  }
}
