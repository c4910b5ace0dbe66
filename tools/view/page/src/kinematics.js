// Forward kinematics, equal to that of tip-view's skeleton, in mm and degrees in the robot's frame.

import { Matrix4, Quaternion, Vector3 } from 'three';

const RADIANS = Math.PI / 180;

/** Returns the robot's frame in the world: yaw about z, then pitch about x, then roll about y. */
export function placed(pose) {
  if (!pose) return new Matrix4();
  const [x, y, z, roll, pitch, yaw] = pose;
  const turn = new Matrix4().makeRotationZ(yaw * RADIANS);
  turn.multiply(new Matrix4().makeRotationX(pitch * RADIANS));
  turn.multiply(new Matrix4().makeRotationY(roll * RADIANS));
  return turn.setPosition(x, y, z);
}

/** Returns the frame of each link of a leg, with its origin in its joint. */
export function links(leg, angles) {
  const frame = new Matrix4().makeTranslation(...leg.base);
  return leg.joints.map(({ axis, link }, j) => {
    const turn = new Quaternion().setFromAxisAngle(new Vector3(...axis), angles[j] * RADIANS);
    frame.multiply(new Matrix4().makeRotationFromQuaternion(turn));
    const own = frame.clone();
    frame.multiply(new Matrix4().makeTranslation(...link));
    return own;
  });
}

/**
 * Returns the place of each foot in the world. Trails need hundreds of them, so it makes no frames: it goes from the foot back to
 * the body, and each joint turns the part of the leg after it.
 */
export function feet({ legs }, { pose, angles }) {
  const [body, part] = [placed(pose), new Vector3()];
  return legs.map(({ base, joints }, l) => {
    const turn = (end, { axis, link }, j) => end.add(part.fromArray(link)).applyAxisAngle(part.fromArray(axis), angles[l][j] * RADIANS);
    return joints.reduceRight(turn, new Vector3()).add(part.fromArray(base)).applyMatrix4(body);
  });
}

/** Returns the corners of the body's lower side in the world. */
export function belly({ body }, { pose }) {
  const frame = placed(pose);
  const corners = body.x.flatMap((x) => body.y.map((y) => new Vector3(x, y, body.z[0])));
  return corners.map((corner) => corner.applyMatrix4(frame));
}

/**
 * Returns the centre of mass in the world. By default, the mass of a link is in its middle, and that of the body in its
 * origin.
 */
export function centreOfMass(robot, { pose, angles }) {
  let mass = robot.body?.mass ?? 0;
  const sum = new Vector3(...(robot.body?.centre ?? [0, 0, 0])).multiplyScalar(mass);
  robot.legs.forEach((leg, l) => {
    const frames = links(leg, angles[l]);
    leg.joints.forEach((joint, j) => {
      const centre = joint.centre ?? joint.link.map((part) => part / 2);
      sum.addScaledVector(new Vector3(...centre).applyMatrix4(frames[j]), joint.mass);
      mass += joint.mass;
    });
  });
  return mass > 0 ? sum.divideScalar(mass).applyMatrix4(placed(pose)) : undefined;
}

/** Returns the convex hull of points [x, y], counter-clockwise (Andrew's monotone chain). */
export function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const side = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const half = (ordered) => {
    const chain = [];
    for (const point of ordered) {
      while (chain.length > 1 && side(chain.at(-2), chain.at(-1), point) <= 0) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.toReversed())];
}
