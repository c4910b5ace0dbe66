// The robot's body and links as solids, in true proportion.

import { Bone, BoxGeometry, CapsuleGeometry, CylinderGeometry, Group, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { links, placed } from './kinematics.js';
import { colour, legColour } from './dom.js';
import { Solid } from './solid.js';

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
    this.material = new MeshLambertMaterial({ vertexColors: true });
    [this.bones, this.parts] = [[], []];
    const thick = reach(robot) * 0.042;
    this.trunk = this.bone(this);
    if (robot.body) this.addBody(robot.body, thick);
    else this.addPalm(robot.legs, thick);
    this.links = robot.legs.map((leg, l) => leg.joints.map((joint, j) => this.addLink(leg, l, joint, j, thick)));
    this.solid = new Solid(this.parts, this.bones, this.material);
    this.add(this.solid);
    this.recolour();
  }

  /** Takes the colours of the page's scheme. */
  recolour() {
    const chosen = new Map();
    const of = ({ name, leg }) => {
      const key = `${name}${leg ?? ''}`;
      if (!chosen.has(key)) chosen.set(key, leg === undefined ? colour(name) : legColour(leg));
      return chosen.get(key);
    };
    this.solid.recolour(of);
  }

  /** What moves as one, on what carries it. */
  bone(parent) {
    const bone = new Bone();
    bone.matrixAutoUpdate = false;
    parent.add(bone);
    this.bones.push(bone);
    return bone;
  }

  /** These parts move with the bone that is the newest. */
  addParts(parts) {
    const bone = this.bones.length - 1;
    this.parts.push(...parts.map((part) => ({ ...part, bone })));
  }

  addBody({ x, y, z }, thick) {
    const size = [x, y, z].map(([min, max]) => Math.max(max - min, thick));
    const middle = [x, y, z].map(([min, max]) => (min + max) / 2);
    const trunk = new RoundedBoxGeometry(...size, 2, Math.min(...size) * 0.12);
    // A plate on top, and a window in front, show where forward is.
    const plate = new BoxGeometry(size[0] * 0.62, size[1] * 0.7, thick * 0.3);
    const nose = new BoxGeometry(size[0] * 0.5, thick * 0.3, size[2] * 0.16);
    const parts = [
      { geometry: trunk.translate(...middle), name: 'robot-body' },
      { geometry: plate.translate(middle[0], middle[1], z[1] + thick * 0.1), name: 'robot-link' },
      { geometry: nose.translate(middle[0], y[1], z[1] - size[2] * 0.2), name: 'robot-front' },
    ];
    this.addParts(parts);
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
    const palm = new RoundedBoxGeometry(...size, 2, thick * 0.5);
    this.addParts([{ geometry: palm.translate(...middle), name: 'robot-body' }]);
  }

  addLink(leg, l, { axis, link }, j, thick) {
    const bone = this.bone(this.trunk);
    const [last, length] = [j === leg.joints.length - 1, Math.hypot(...link)];
    const radius = thick * (1 - (0.45 * j) / Math.max(leg.joints.length, 1));
    const hub = new CylinderGeometry(radius * 1.28, radius * 1.28, radius * 2.5, 16);
    const parts = [{ geometry: turned(hub, new Vector3(...axis)), name: 'robot-joint' }];
    if (length > 1e-6) {
      const along = new Vector3(...link).normalize();
      const add = (geometry, at, name, leg) => parts.push({ geometry: turned(geometry, along, at), name, leg });
      add(new CylinderGeometry(radius * 0.72, radius * 0.98, length, 12), length / 2, 'robot-link');
      if (last) {
        // Its end is exactly where kinematics has the foot.
        add(new SphereGeometry(radius * 0.95, 14, 10), length - radius * 0.95, 'leg', l);
        add(new CapsuleGeometry(radius * 0.8, radius, 3, 12), length - radius * 1.8, 'leg', l);
      }
    }
    this.addParts(parts);
    return bone;
  }

  /** Puts it into a posture. */
  pose(posture) {
    this.trunk.matrix.copy(placed(posture.pose));
    this.trunk.matrixWorldNeedsUpdate = true;
    this.robot.legs.forEach((leg, l) => {
      const frames = links(leg, posture.angles[l]);
      this.links[l].forEach((bone, j) => bone.matrix.copy(frames[j]));
    });
  }
}

/** A geometry whose axis was up, along a direction and so far that way. */
function turned(geometry, direction, at = 0) {
  return geometry.applyMatrix4(new Matrix4().makeRotationFromQuaternion(towards(direction)).setPosition(direction.clone().multiplyScalar(at)));
}

/** Turns the unit vector up into a direction. */
export function towards(direction) {
  return new Quaternion().setFromUnitVectors(UP, direction);
}

