// The robot's body and links as solids, in true proportion.

import { BoxGeometry, CapsuleGeometry, CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { links, placed } from './kinematics.js';
import { colour, legColour } from './dom.js';

const UP = new Vector3(0, 1, 0);

/** How long the longest leg is when it is straight: mm. */
export function reach(robot) {
  const lengths = robot.legs.map((leg) => leg.joints.reduce((sum, { link }) => sum + Math.hypot(...link), 0));
  return Math.max(...lengths, 1);
}

export class RobotSolid extends Group {
  constructor(robot) {
    super();
    this.robot = robot;
    this.materials = {};
    const thick = reach(robot) * 0.042;
    this.trunk = new Group();
    this.trunk.matrixAutoUpdate = false;
    this.add(this.trunk);
    if (robot.body) this.addBody(robot.body, thick);
    else this.addPalm(robot.legs, thick);
    this.links = robot.legs.map((leg, l) => leg.joints.map((joint, j) => this.addLink(leg, l, joint, j, thick)));
    this.recolour();
  }

  material(name, leg) {
    const key = leg === undefined ? name : `${name}${leg}`;
    this.materials[key] ??= Object.assign(new MeshLambertMaterial(), { of: name, leg });
    return this.materials[key];
  }

  /** Takes the colours of the page's scheme. */
  recolour() {
    for (const material of Object.values(this.materials)) {
      material.color.set(material.leg === undefined ? colour(material.of) : legColour(material.leg));
    }
  }

  solid(geometry, material, parent) {
    const mesh = new Mesh(geometry, material);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    parent.add(mesh);
    return mesh;
  }

  addBody({ x, y, z }, thick) {
    const size = [x, y, z].map(([min, max]) => Math.max(max - min, thick));
    const middle = [x, y, z].map(([min, max]) => (min + max) / 2);
    const round = Math.min(...size) * 0.12;
    this.solid(new RoundedBoxGeometry(...size, 3, round), this.material('robot-body'), this.trunk).position.set(...middle);
    // A plate on top, and a window in front, show where forward is.
    const plate = this.solid(new BoxGeometry(size[0] * 0.62, size[1] * 0.7, thick * 0.3), this.material('robot-link'), this.trunk);
    plate.position.set(middle[0], middle[1], z[1] + thick * 0.1);
    const nose = this.solid(new BoxGeometry(size[0] * 0.5, thick * 0.3, size[2] * 0.16), this.material('robot-front'), this.trunk);
    nose.position.set(middle[0], y[1], z[1] - size[2] * 0.2);
  }

  /** What fingers, or the legs of a robot that is bolted down, begin on. */
  addPalm(legs, thick) {
    const ends = [0, 1, 2].map((axis) => {
      const places = legs.map(({ base }) => base[axis]);
      return [Math.min(...places), Math.max(...places)];
    });
    const up = this.robot.planar ? 1 : 2;
    const size = ends.map(([min, max], axis) => max - min + (axis === up ? thick * 1.6 : thick * 3));
    const middle = ends.map(([min, max], axis) => (min + max) / 2 + (axis === up ? thick * 1.6 : 0));
    const palm = new RoundedBoxGeometry(...size, 3, thick * 0.5);
    this.solid(palm, this.material('robot-body'), this.trunk).position.set(...middle);
  }

  addLink(leg, l, { axis, link }, j, thick) {
    const group = new Group();
    group.matrixAutoUpdate = false;
    this.trunk.add(group);
    const [last, length] = [j === leg.joints.length - 1, Math.hypot(...link)];
    const radius = thick * (1 - (0.45 * j) / Math.max(leg.joints.length, 1));
    const hub = this.solid(new CylinderGeometry(radius * 1.28, radius * 1.28, radius * 2.5, 20), this.material('robot-joint'), group);
    hub.quaternion.setFromUnitVectors(UP, new Vector3(...axis));
    if (length < 1e-6) return group;
    const along = new Vector3(...link).normalize();
    const limb = this.solid(new CylinderGeometry(radius * 0.72, radius * 0.98, length, 16), this.material('robot-link'), group);
    limb.quaternion.setFromUnitVectors(UP, along);
    limb.position.copy(along).multiplyScalar(length / 2);
    if (last) {
      // Its end is exactly where kinematics has the foot.
      const foot = this.solid(new SphereGeometry(radius * 0.95, 20, 14), this.material('leg', l), group);
      foot.position.copy(along).multiplyScalar(length - radius * 0.95);
      const cuff = this.solid(new CapsuleGeometry(radius * 0.8, radius, 4, 14), this.material('leg', l), group);
      cuff.quaternion.setFromUnitVectors(UP, along);
      cuff.position.copy(along).multiplyScalar(length - radius * 1.8);
    }
    return group;
  }

  /** Puts it into a posture. */
  pose(posture) {
    this.trunk.matrix.copy(placed(posture.pose));
    this.trunk.matrixWorldNeedsUpdate = true;
    this.robot.legs.forEach((leg, l) => {
      const frames = links(leg, posture.angles[l]);
      this.links[l].forEach((group, j) => group.matrix.copy(frames[j]));
    });
  }
}

/** Turns the unit vector up into a direction. */
export function towards(direction) {
  return new Quaternion().setFromUnitVectors(UP, direction);
}

