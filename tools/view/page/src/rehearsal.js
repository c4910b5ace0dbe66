// An empty recording, with which the graphics compile their shaders while the real one loads.

const joint = { axis: [0, 0, 1], link: [0, 0, 1], mass: 0 };

export const REHEARSAL = {
  robot: { legs: [{ base: [0, 0, 0], joints: [joint] }], body: { x: [0, 1], y: [0, 1], z: [0, 1] } },
  scene: { height: 0, slope: [0, 0], blocks: [], objects: [] },
  between: () => ({}),
  posture: () => ({ angles: [[0]] }),
};
