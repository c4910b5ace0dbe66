// The robot's body and links as solids, to scale.

import { BoxGeometry, CapsuleGeometry, CylinderGeometry, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { links, placed } from './kinematics.js';
import { colour, legColour } from './dom.js';
import { Solid } from './solid.js';

const UP = new Vector3(0, 1, 0);

/** Returns the length of the longest leg when it is straight, mm. */
export function reach(robot) {
  const lengths = robot.legs.map((leg) => leg.joints.reduce((sum, { link }) => sum + Math.hypot(...link), 0));
  return Math.max(...lengths, 1);
}

export class RobotSolid extends Solid {
  constructor(robot) {
    const thick = reach(robot) * 0.042;
    const trunk = robot.body ? bodyParts(robot.body, thick) : palmParts(robot, thick);
    const links = robot.legs.flatMap((leg, l) => leg.joints.map((joint, j) => linkParts(leg, l, joint, j, thick)));
    // Parts that move together have the same bone: 0 for the trunk, then one for each link.
    const parts = [trunk, ...links].flatMap((parts, bone) => parts.map((part) => ({ ...part, bone })));
    super(parts, new MeshLambertMaterial({ vertexColors: true }));
    this.robot = robot;
    this.overlapping = [];
    this.recolour();
  }

  /** Shows parts that overlap, such as link12 and body, in the colour of what is bad. */
  collide(parts) {
    if (parts.join() === this.overlapping.join()) return;
    this.overlapping = parts;
    this.recolour();
  }

  /** Applies the colours of the page's scheme. */
  recolour() {
    const chosen = new Map();
    const names = ['body', ...this.robot.legs.flatMap((leg, l) => leg.joints.map((_, j) => `link${l + 1}${j + 1}`))];
    this.paint(({ name, leg, bone }) => {
      if (this.overlapping.includes(names[bone])) return colour('bad');
      const key = `${name}${leg ?? ''}`;
      if (!chosen.has(key)) chosen.set(key, leg === undefined ? colour(name) : legColour(leg));
      return chosen.get(key);
    });
  }

  /** Moves the robot to a posture. */
  pose(posture) {
    const trunk = placed(posture.pose);
    const bones = [trunk];
    this.robot.legs.forEach((leg, l) => {
      const frames = links(leg, posture.angles[l]);
      leg.joints.forEach((_, j) => bones.push(frames[j].premultiply(trunk)));
    });
    this.move(bones);
  }
}

function bodyParts({ x, y, z }, thick) {
  const size = [x, y, z].map(([min, max]) => Math.max(max - min, thick));
  const middle = [x, y, z].map(([min, max]) => (min + max) / 2);
  const trunk = new RoundedBoxGeometry(...size, 2, Math.min(...size) * 0.12);
  // A plate on top and a window in front show the direction forward.
  const plate = new BoxGeometry(size[0] * 0.62, size[1] * 0.7, thick * 0.3);
  const nose = new BoxGeometry(size[0] * 0.5, thick * 0.3, size[2] * 0.16);
  return [
    { geometry: trunk.translate(...middle), name: 'robot-body' },
    { geometry: plate.translate(middle[0], middle[1], z[1] + thick * 0.1), name: 'robot-link' },
    { geometry: nose.translate(middle[0], y[1], z[1] - size[2] * 0.2), name: 'robot-front' },
  ];
}

/** Returns the parts of the base that carries fingers or the legs of a robot that is bolted down. */
function palmParts({ legs, planar }, thick) {
  const ends = [0, 1, 2].map((axis) => {
    const places = legs.map(({ base }) => base[axis]);
    return [Math.min(...places), Math.max(...places)];
  });
  const up = planar ? 1 : 2;
  const size = ends.map(([min, max], axis) => max - min + (axis === up ? thick * 1.6 : thick * 3));
  const middle = ends.map(([min, max], axis) => (min + max) / 2 + (axis === up ? thick * 1.6 : 0));
  const palm = new RoundedBoxGeometry(...size, 2, thick * 0.5);
  return [{ geometry: palm.translate(...middle), name: 'robot-body' }];
}

function linkParts(leg, l, { axis, link }, j, thick) {
  const [last, length] = [j === leg.joints.length - 1, Math.hypot(...link)];
  const radius = thick * (1 - (0.45 * j) / Math.max(leg.joints.length, 1));
  const hub = new CylinderGeometry(radius * 1.28, radius * 1.28, radius * 2.5, 14);
  const parts = [{ geometry: turned(hub, new Vector3(...axis)), name: 'robot-joint' }];
  if (length > 1e-6) {
    const along = new Vector3(...link).normalize();
    const add = (geometry, at, name, leg) => parts.push({ geometry: turned(geometry, along, at), name, leg });
    // The ends of a link are inside joints, except that of the last one.
    add(new CylinderGeometry(radius * 0.72, radius * 0.98, length, 12, 1, !last), length / 2, 'robot-link');
    if (last) {
      // The tip of the ball is exactly at the foot of the kinematics.
      add(new SphereGeometry(radius * 0.95, 12, 8), length - radius * 0.95, 'leg', l);
      add(new CapsuleGeometry(radius * 0.8, radius, 2, 12), length - radius * 1.8, 'leg', l);
    }
  }
  return parts;
}

/** Turns a geometry with an upright axis along a direction, and moves it by `at` in that direction. */
function turned(geometry, direction, at = 0) {
  return geometry.applyMatrix4(new Matrix4().makeRotationFromQuaternion(towards(direction)).setPosition(direction.clone().multiplyScalar(at)));
}

/** Returns the rotation of the unit vector up into a direction. */
export function towards(direction) {
  return new Quaternion().setFromUnitVectors(UP, direction);
}

