// Marks that are drawn in every frame: trails, support polygon, centre of mass, forces, slips. Lengths in mm.

import { Color, ConeGeometry, CylinderGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, RingGeometry, SphereGeometry, Vector3 } from 'three';
import { Batch } from './batch.js';
import { colour, legColour } from './dom.js';
import { towards } from './robot.js';

/** Maximum number of places of a trail. */
export const PLACES = 240;
/** Maximum number of corners of a support polygon: nine feet and four corners of the body. */
const CORNERS = 13;
/** Numbers of axes of a frame, and of corners of the triangles of the arrow on the floor. */
const [AXES, ARROW] = [3, 9];
/** Heights of marks above the ground, mm. Each kind is above the ones before. */
const LIFT = { fill: 1.2, edge: 1.4, spot: 1.6, ring: 1.8 };

/** Returns the corners of a geometry's triangles, one after the other. */
function triangles(geometry) {
  const { array } = geometry.toNonIndexed().attributes.position;
  return Array.from({ length: array.length / 3 }, (_, n) => new Vector3(...array.slice(3 * n, 3 * n + 3)));
}

export class Marks extends Group {
  /** Creates the marks of a robot with a size and a number of legs. */
  constructor(size, legs) {
    super();
    const thick = size * 0.006;
    this.shaft = triangles(new CylinderGeometry(thick, thick, 1, 8, 1, true).translate(0, 0.5, 0));
    this.head = triangles(new ConeGeometry(thick * 3, thick * 7, 12).translate(0, thick * 3.5, 0));
    this.spotRing = triangles(new RingGeometry(size * 0.014, size * 0.021, 24));
    this.slipRing = triangles(new RingGeometry(size * 0.04, size * 0.05, 24));
    const each = this.shaft.length + this.head.length + this.slipRing.length;
    const common = { vertexColors: true, transparent: true };
    this.lines = new Batch(LineSegments, new LineBasicMaterial(common), 2 * (legs * PLACES + CORNERS + 1 + AXES));
    this.faces = new Batch(Mesh, new MeshBasicMaterial({ ...common, side: DoubleSide }), legs * each + this.spotRing.length + 3 * CORNERS + ARROW);
    this.centre = new Mesh(new SphereGeometry(size * 0.014, 12, 8), new MeshBasicMaterial({ transparent: true, depthTest: false }));
    // Transparent shapes are drawn after what is seen through them: lines, then faces, then objects.
    [this.lines.shape.renderOrder, this.faces.shape.renderOrder, this.centre.renderOrder] = [0.4, 0.6, 2];
    this.add(this.lines.shape, this.faces.shape, this.centre);
    this.legs = legs;
  }

  /** Applies the colours of the page's scheme. */
  recolour() {
    const named = (name) => new Color(colour(name));
    this.tints = { good: named('good'), bad: named('bad'), force: named('force'), front: named('robot-front'), axes: ['axis-x', 'axis-y', 'axis-z'].map(named), legs: Array.from({ length: this.legs }, (_, leg) => new Color(legColour(leg))) };
  }

  begin() {
    this.lines.begin();
    this.faces.begin();
    this.centre.visible = false;
  }

  end() {
    this.lines.end();
    this.faces.end();
  }

  trail(leg, places) {
    this.lines.tint(this.tints.legs[leg], 0.85);
    this.lines.path(places);
  }

  /**
   * Adds the support polygon with its corners [x, y], the centre of mass, and the place under it. `ground` returns the
   * height of the floor.
   */
  support(corners, centre, isGood, ground) {
    const tint = isGood ? this.tints.good : this.tints.bad;
    const raised = (lift) => ([x, y]) => [x, y, ground(x, y) + lift];
    const [fill, edge] = [corners.map(raised(LIFT.fill)), corners.map(raised(LIFT.edge))];
    this.faces.tint(tint, 0.2);
    for (let corner = 1; corner + 1 < fill.length; corner++) [fill[0], fill[corner], fill[corner + 1]].forEach((at) => this.faces.corner(...at));
    this.lines.tint(tint);
    if (edge.length > 1) this.lines.path([...edge, edge[0]]);
    const under = [centre.x, centre.y, ground(centre.x, centre.y) + LIFT.spot];
    this.lines.path([centre.toArray(), under]);
    this.faces.tint(tint);
    for (const { x, y } of this.spotRing) this.faces.corner(under[0] + x, under[1] + y, under[2]);
    this.centre.visible = true;
    this.centre.position.copy(centre);
    this.centre.material.color.copy(tint);
  }

  /** Adds an arrow of a length from a place, along a unit vector. */
  force(place, direction, length) {
    this.faces.tint(this.tints.force);
    const turn = towards(direction);
    const put = (corner) => this.faces.corner(...corner.applyQuaternion(turn).add(place).toArray());
    for (const { x, y, z } of this.shaft) put(new Vector3(x, y * length, z));
    for (const { x, y, z } of this.head) put(new Vector3(x, y + length, z));
  }

  /** Adds the axes of a frame, from its origin to their ends. */
  axes(origin, ends) {
    ends.forEach((end, axis) => {
      this.lines.tint(this.tints.axes[axis]);
      this.lines.path([origin.toArray(), end.toArray()]);
    });
  }

  /** Adds an arrow on the floor from a place, along a level unit vector. Returns its tip. */
  forward(from, ahead, length, ground) {
    this.faces.tint(this.tints.front, 0.9);
    const aside = [-ahead.y, ahead.x];
    const at = (along, across) => {
      const [x, y] = [from.x + length * (along * ahead.x + across * aside[0]), from.y + length * (along * ahead.y + across * aside[1])];
      return [x, y, ground(x, y) + LIFT.spot];
    };
    const [shaft, head] = [[at(0, 0.07), at(0, -0.07), at(0.55, -0.07), at(0.55, 0.07)], [at(0.55, 0.2), at(0.55, -0.2), at(1, 0)]];
    for (const corner of [shaft[0], shaft[1], shaft[2], shaft[0], shaft[2], shaft[3], ...head]) this.faces.corner(...corner);
    return new Vector3(...head[2]);
  }

  slip({ x, y }, ground) {
    this.faces.tint(this.tints.bad);
    for (const corner of this.slipRing) this.faces.corner(x + corner.x, y + corner.y, ground + LIFT.ring);
  }
}
