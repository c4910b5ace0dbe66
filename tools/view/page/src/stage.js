// The robot on its floor, in three dimensions. Lengths in mm.

import { AmbientLight, Color, DirectionalLight, Fog, Group, HemisphereLight, PerspectiveCamera, Scene, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { colour } from './dom.js';
import { belly, centreOfMass, feet, hull, placed } from './kinematics.js';
import { Labels } from './labels.js';
import { Marks, PLACES } from './marks.js';
import { REHEARSAL } from './rehearsal.js';
import { RobotSolid, reach } from './robot.js';
import { Screen } from './screen.js';
import { Surroundings } from './surroundings.js';

/** Length of the trails of feet, ms. */
const TRAIL = 4000;
/** Time around a slip in which it is marked, ms. */
const MARKED = 1500;
/** Height above the floor up to which a corner of the body's lower side counts as support, mm. */
const TOUCHES = 0.5;
const GRAVITY = 9.80665;

export class Stage {
  /** Creates a stage that shows nothing before `begin`, but compiles its shaders. */
  constructor(canvas) {
    this.canvas = canvas;
    this.shows = { follow: true, trails: true, forces: true, labels: true, support: true };
    this.screen = new Screen(canvas, () => this.render());
    this.camera = new PerspectiveCamera(32);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.screen.draw());
    this.followed = new Vector3();
    this.begin(REHEARSAL);
    setTimeout(() => this.screen.settle());
  }

  /** Shows the robot and the surroundings of a recording, in place of the previous ones. */
  begin(recording = this.recording) {
    const before = this.scene;
    const { robot } = recording;
    [this.known, this.place] = [];
    this.recording = recording;
    this.scene = new Scene();
    this.robot = robot;
    this.size = robot.body ? reach(robot) + Math.max(...[robot.body.x, robot.body.y].flat().map(Math.abs)) : reach(robot) * 1.6;
    Object.assign(this.camera, { near: this.size / 50, far: this.size * 60 });
    const { controls } = this;
    controls.maxPolarAngle = robot.planar ? Math.PI : Math.PI * 0.495;
    [controls.minDistance, controls.maxDistance] = [this.size * 0.4, this.size * 20];
    // In the scene y is up; in the world of a walking robot z is.
    this.world = new Group();
    if (!robot.planar) this.world.rotation.x = -Math.PI / 2;
    this.scene.add(this.world);
    this.light();
    this.solid = new RobotSolid(robot);
    // Software rendering has no time for shadows on the robot, only for those on the floor.
    if (this.screen.isSoftware) this.solid.receiveShadow = false;
    this.surroundings = new Surroundings(this.recording, this.size);
    this.marks = new Marks(this.size, robot.legs.length);
    this.labels = new Labels(robot);
    this.world.add(this.solid, this.surroundings, this.marks, this.labels);
    if (this.other) this.compare(this.other, this.timeOf);
    this.recolour();
    this.resize();
    this.resetView();
    this.screen.prepareFor(this.scene, this.camera);
    // The old scene is released last, so that resources which both scenes use are kept.
    if (before) release(before);
  }

  /** Shows the robot of another recording as well, as a ghost; `timeOf` gives its time. */
  compare(other, timeOf) {
    Object.assign(this, { other, timeOf });
    this.ghost = new RobotSolid(other.robot);
    this.ghost.castShadow = false;
    Object.assign(this.ghost.material, { transparent: true, opacity: 0.35, depthWrite: false });
    this.world.add(this.ghost);
  }

  light() {
    this.scene.add(new HemisphereLight(0xffffff, 0x989a9f, 2), new AmbientLight(0xffffff, 0.48));
    this.sun = new DirectionalLight(0xffffff, 1.05);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(512, 512);
    const half = this.size * 1.3;
    Object.assign(this.sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 1, far: this.size * 8 });
    this.sun.shadow.bias = -0.0008;
    this.sun.shadow.normalBias = this.size / 300;
    this.scene.add(this.sun, this.sun.target);
  }

  /** Applies the colours of the page's scheme. */
  recolour() {
    const background = new Color(colour('stage'));
    this.scene.background = background;
    this.scene.fog = new Fog(background, this.size * 5, this.size * 14);
    this.surroundings.recolour();
    this.marks.recolour();
    this.solid.recolour();
    this.ghost?.recolour();
    this.labels.recolour();
    this.screen.draw();
  }

  resetView() {
    const [distance, middle] = [this.size * 3.1, this.focus()];
    const from = this.robot.planar ? new Vector3(0.32, 0.22, 1) : new Vector3(0.78, 0.5, -0.8);
    this.followed.copy(middle);
    this.controls.target.copy(middle);
    this.camera.position.copy(from.normalize().multiplyScalar(distance)).add(middle);
    this.controls.update();
    this.screen.draw();
  }

  /** Returns the centre of the view, in the axes of the scene. */
  focus() {
    if (this.robot.planar) return new Vector3(0, -this.size * 0.32, 0);
    const place = this.place ?? this.recording.between(0);
    const { pose } = this.postureAt(place);
    const [x, y] = pose ?? [0, 0];
    const height = this.recording.scene.height + this.size * (pose ? 0.2 : 0.1);
    return new Vector3(x, y, height).applyQuaternion(this.world.quaternion);
  }

  /** Returns the posture at a place between frames. A robot whose pose nobody knows, such as a real one, stands on the floor. */
  postureAt(place) {
    const posture = this.recording.posture(place);
    if (posture.pose || !this.robot.body) return posture;
    const lowest = Math.min(...feet(this.robot, posture).map(({ z }) => z));
    return { ...posture, pose: [0, 0, this.recording.scene.height - lowest, 0, 0, 0] };
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.screen.resize(width, height);
    this.camera.aspect = width / height;
    // A narrow page gets a wider field of view, so that the robot keeps its width.
    this.camera.fov = this.camera.aspect < 1.2 ? 2 * Math.atan(Math.tan(0.28) * (1.2 / this.camera.aspect)) * (180 / Math.PI) : 32;
    this.camera.updateProjectionMatrix();
    this.screen.draw();
  }

  /** Shows the robot as it was at a time. */
  show(time) {
    const { recording } = this;
    this.time = time;
    this.place = recording.between(time);
    this.posture = this.postureAt(this.place);
    this.solid.pose(this.posture);
    this.solid.collide(recording.at('collision', recording.cycleAt(time)) ?? []);
    if (this.ghost) {
      const posture = this.other.posture(this.other.between(this.timeOf(time)));
      // Recordings of real robots have no pose. Then both robots are shown at the same place.
      if (!recording.has('pose.0') || !posture.pose) posture.pose = this.posture.pose;
      this.ghost.pose(posture);
    }
    this.surroundings.move(this.place, this.posture.pose);
    this.ends = feet(this.robot, this.posture);
    this.marks.begin();
    if (this.shows.trails) this.showTrails();
    if (this.shows.support && this.robot.body) this.showSupport();
    if (this.shows.forces) this.showForces();
    this.showSlips();
    this.showLabels();
    this.marks.end();
    if (this.shows.follow && !this.robot.planar) this.follow();
    this.screen.draw();
  }

  follow() {
    const focus = this.focus();
    const moved = focus.clone().sub(this.followed);
    this.followed.copy(focus);
    this.controls.target.add(moved);
    this.camera.position.add(moved);
  }

  /** Returns the places of the feet in a frame, which are computed once. */
  feetOf(frame) {
    this.known ??= [];
    this.known[frame] ??= feet(this.robot, this.postureAt({ before: frame, after: frame, share: 0 }));
    return this.known[frame];
  }

  /** Forgets the feet of frames from one on, which have changed. */
  forget(frame) {
    if (this.known?.length > frame) this.known.length = frame;
  }

  showTrails() {
    const first = this.recording.between(this.time - TRAIL).before;
    const last = this.place.before;
    const stride = Math.ceil((last - first + 1) / PLACES);
    const frames = [];
    for (let frame = Math.ceil(first / stride) * stride; frame <= last; frame += stride) frames.push(frame);
    this.ends.forEach((end, leg) => this.marks.trail(leg, [...frames.map((frame) => this.feetOf(frame)[leg].toArray()), end.toArray()]));
  }

  showSupport() {
    const ground = (x, y) => this.surroundings.ground(x, y);
    const touches = this.recording.touchesAt(this.recording.cycleAt(this.time));
    const lies = belly(this.robot, this.posture).filter(({ x, y, z }) => z - ground(x, y) < TOUCHES);
    const carrying = [...this.ends.filter((_, leg) => touches[leg]), ...lies];
    const corners = hull(carrying.map(({ x, y }) => [x, y]));
    const margin = this.recording.value('margin', this.place);
    this.marks.support(corners, centreOfMass(this.robot, this.posture), margin === undefined || margin >= 0, ground);
  }

  showForces() {
    const { recording, place } = this;
    const value = (name) => recording.value(name, place) ?? 0;
    const mass = this.robot.legs.flatMap((leg) => leg.joints).reduce((sum, joint) => sum + joint.mass, this.robot.body?.mass ?? 0);
    const whole = this.robot.planar ? 8 : Math.max(mass * GRAVITY, 1);
    this.ends.forEach((end, leg) => {
      const force = this.robot.planar
        ? new Vector3(value(`push.${leg}.0`), value(`push.${leg}.1`), value(`push.${leg}.2`))
        : new Vector3(value(`force.${leg}.0`), value(`force.${leg}.1`), recording.value(`force.${leg}.2`, place) ?? value(`load.${leg}`));
      const length = (force.length() / whole) * this.size * 0.8;
      if (length > this.size * 0.004) this.marks.force(end, force.normalize(), length);
    });
  }

  showSlips() {
    const { recording } = this;
    this.ends.forEach((end, leg) => {
      const { cycles } = recording.entries(`slip.${leg}`);
      if (cycles.some((cycle) => Math.abs(recording.endOf(cycle) - this.time) < MARKED)) this.marks.slip(end, this.surroundings.ground(end.x, end.y));
    });
  }

  /** Shows the names of feet and axes, the axes of the robot's frame, and an arrow forward on the floor. */
  showLabels() {
    this.labels.visible = this.shows.labels;
    if (!this.shows.labels) return;
    const frame = placed(this.posture.pose);
    const [centre, length] = [new Vector3().setFromMatrixPosition(frame), this.size * 0.3];
    const axes = [0, 1, 2].map((axis) => new Vector3().setFromMatrixColumn(frame, axis).multiplyScalar(length).add(centre));
    this.marks.axes(centre, axes);
    let front;
    if (this.robot.body) {
      const ahead = new Vector3().setFromMatrixColumn(frame, 1).setZ(0).normalize();
      const from = ahead.clone().multiplyScalar(Math.max(...this.robot.body.y) + this.size * 0.12).add(centre);
      front = this.marks.forward(from, ahead, this.size * 0.32, (x, y) => this.surroundings.ground(x, y));
    }
    this.labels.put(this.ends, axes, front);
  }

  /** Draws immediately, in full resolution. */
  drawNow() {
    this.screen.drawNow();
  }

  /** Draws immediately, in the best resolution. */
  drawFine() {
    this.screen.drawFine();
  }

  render() {
    if (this.recording === REHEARSAL) return;
    const middle = this.controls.target;
    this.sun.target.position.copy(middle);
    this.sun.position.set(-0.9, 2.6, 1.1).multiplyScalar(this.size).add(middle);
    this.screen.renderer.render(this.scene, this.camera);
  }
}

/** Releases the graphics resources of a scene. */
function release(scene) {
  scene.traverse(({ isLight, shadow, geometry, material }) => {
    if (isLight) shadow?.dispose();
    geometry?.dispose();
    material?.map?.dispose();
    material?.dispose();
  });
}
