// The robot on its floor, in three dimensions. Lengths in mm.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, Fog, Group, HemisphereLight, Line,
  LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PerspectiveCamera, RingGeometry, Scene, SphereGeometry, Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { colour, legColour } from './dom.js';
import { belly, centreOfMass, feet, hull } from './kinematics.js';
import { RobotSolid, reach, towards } from './robot.js';
import { Screen } from './screen.js';
import { Surroundings } from './surroundings.js';

/** How long foot trails are: ms. */
const TRAIL = 4000;
/** How many places a trail has at most. */
const PLACES = 240;
/** How long a slip stays marked: ms. */
const MARKED = 1500;
/** A belly so far above the floor carries as well: mm. */
const TOUCHES = 0.5;
const GRAVITY = 9.80665;

export class Stage {
  constructor(canvas, recording) {
    this.canvas = canvas;
    this.recording = recording;
    this.shows = { follow: true, trails: true, forces: true, support: true };
    this.screen = new Screen(canvas, () => this.render());
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.screen.draw());
    this.followed = new Vector3();
    this.begin();
  }

  /** The robot of the recording and its surroundings, in the place of those before. */
  begin() {
    this.clear();
    const { robot } = this.recording;
    this.robot = robot;
    this.size = robot.body ? reach(robot) + Math.max(...[robot.body.x, robot.body.y].flat().map(Math.abs)) : reach(robot) * 1.6;
    Object.assign(this.camera, { near: this.size / 50, far: this.size * 60 });
    const { controls } = this;
    controls.maxPolarAngle = robot.planar ? Math.PI : Math.PI * 0.495;
    [controls.minDistance, controls.maxDistance] = [this.size * 0.4, this.size * 20];
    // The page's up is y; a walker's is z.
    this.world = new Group();
    if (!robot.planar) this.world.rotation.x = -Math.PI / 2;
    this.scene.add(this.world);
    this.light();
    this.solid = new RobotSolid(robot);
    // The processor has shadows to draw on the floor, and no time for those on the robot.
    if (this.screen.isSoftware) this.solid.traverse((part) => (part.receiveShadow = false));
    this.surroundings = new Surroundings(this.recording, this.size);
    this.world.add(this.solid, this.surroundings);
    this.makeMarks();
    this.recolour();
    this.resize();
    this.resetView();
  }

  /** Forgets all that belongs to a robot. */
  clear() {
    this.sun?.dispose();
    this.scene.traverse(({ geometry, material }) => {
      geometry?.dispose();
      material?.map?.dispose();
      material?.dispose();
    });
    this.scene.clear();
    [this.known, this.place] = [];
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

  /** What marks are of: one program of the graphics draws them all. */
  paint(options = {}) {
    return new MeshBasicMaterial({ transparent: true, side: DoubleSide, ...options });
  }

  makeMarks() {
    const line = (points, material) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(points * 3), 3));
      const made = new Line(geometry, material);
      made.frustumCulled = false;
      this.world.add(made);
      return made;
    };
    this.trails = this.robot.legs.map(() => line(PLACES + 1, new LineBasicMaterial({ transparent: true, opacity: 0.85 })));
    this.polygon = new Mesh(new BufferGeometry(), this.paint({ opacity: 0.2, depthWrite: false }));
    this.polygon.geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * 3 * 13), 3));
    this.polygon.frustumCulled = false;
    this.edge = line(14, new LineBasicMaterial({ transparent: true }));
    this.plumb = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true }));
    this.plumb.geometry.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    this.plumb.frustumCulled = false;
    this.centre = new Mesh(new SphereGeometry(this.size * 0.014, 16, 12), this.paint({ depthTest: false }));
    this.centre.renderOrder = 2;
    this.spot = new Mesh(new RingGeometry(this.size * 0.014, this.size * 0.021, 32), this.paint());
    this.world.add(this.polygon, this.plumb, this.centre, this.spot);
    this.arrows = this.robot.legs.map(() => this.makeArrow());
    this.rings = this.robot.legs.map(() => {
      const ring = new Mesh(new RingGeometry(this.size * 0.04, this.size * 0.05, 32), this.paint());
      this.world.add(ring);
      return ring;
    });
  }

  makeArrow() {
    const arrow = new Group();
    const material = this.paint();
    const thick = this.size * 0.006;
    arrow.shaft = new Mesh(new CylinderGeometry(thick, thick, 1, 10).translate(0, 0.5, 0), material);
    arrow.head = new Mesh(new ConeGeometry(thick * 3, thick * 7, 14).translate(0, thick * 3.5, 0), material);
    arrow.material = material;
    arrow.add(arrow.shaft, arrow.head);
    this.world.add(arrow);
    return arrow;
  }

  /** Takes the colours of the page's scheme. */
  recolour() {
    const background = new Color(colour('stage'));
    this.scene.background = background;
    this.tints = { good: new Color(colour('good')), bad: new Color(colour('bad')) };
    this.scene.fog = new Fog(background, this.size * 5, this.size * 14);
    this.surroundings.recolour();
    this.trails.forEach((trail, leg) => trail.material.color.set(legColour(leg)));
    this.rings.forEach((ring) => ring.material.color.set(colour('bad')));
    this.arrows.forEach((arrow) => arrow.material.color.set(colour('force')));
    this.solid.recolour();
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

  /** What the view is about, in the page's axes. */
  focus() {
    if (this.robot.planar) return new Vector3(0, -this.size * 0.32, 0);
    const place = this.place ?? this.recording.between(0);
    const { pose } = this.recording.posture(place);
    const [x, y] = pose ?? [0, 0];
    const height = this.recording.scene.height + this.size * (pose ? 0.2 : 0.1);
    return new Vector3(x, y, height).applyQuaternion(this.world.quaternion);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.screen.resize(width, height);
    this.camera.aspect = width / height;
    // On a narrow page the robot keeps its width.
    this.camera.fov = this.camera.aspect < 1.2 ? 2 * Math.atan(Math.tan(0.28) * (1.2 / this.camera.aspect)) * (180 / Math.PI) : 32;
    this.camera.updateProjectionMatrix();
    this.screen.draw();
  }

  /** Shows the robot as it was at a time. */
  show(time) {
    const { recording } = this;
    this.time = time;
    this.place = recording.between(time);
    this.posture = recording.posture(this.place);
    this.solid.pose(this.posture);
    this.surroundings.move(this.place, this.posture.pose);
    this.ends = feet(this.robot, this.posture);
    this.showTrails();
    this.showSupport();
    this.showForces();
    this.showSlips();
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

  /** Where the feet were in a frame; looked up once. */
  feetOf(frame) {
    this.known ??= [];
    this.known[frame] ??= feet(this.robot, this.recording.posture({ before: frame, after: frame, share: 0 }));
    return this.known[frame];
  }

  /** Frames from one on are other ones now. */
  forget(frame) {
    if (this.known?.length > frame) this.known.length = frame;
  }

  showTrails() {
    const first = this.recording.between(this.time - TRAIL).before;
    const last = this.place.before;
    const stride = Math.ceil((last - first + 1) / PLACES);
    const frames = [];
    for (let frame = Math.ceil(first / stride) * stride; frame <= last; frame += stride) frames.push(frame);
    this.trails.forEach((trail, leg) => {
      trail.visible = this.shows.trails;
      const places = trail.geometry.attributes.position;
      frames.forEach((frame, n) => places.setXYZ(n, ...this.feetOf(frame)[leg].toArray()));
      places.setXYZ(frames.length, ...this.ends[leg].toArray());
      places.needsUpdate = true;
      trail.geometry.setDrawRange(0, frames.length + 1);
    });
  }

  showSupport() {
    const visible = this.shows.support && Boolean(this.robot.body);
    [this.polygon, this.edge, this.plumb, this.centre, this.spot].forEach((mark) => (mark.visible = visible));
    if (!visible) return;
    const ground = (x, y) => this.surroundings.ground(x, y);
    const touches = this.recording.touchesAt(this.recording.cycleAt(this.time));
    const lies = belly(this.robot, this.posture).filter(({ x, y, z }) => z - ground(x, y) < TOUCHES);
    const carrying = [...this.ends.filter((_, leg) => touches[leg]), ...lies];
    const corners = hull(carrying.map(({ x, y }) => [x, y]));
    const raised = ([x, y]) => [x, y, ground(x, y) + 1.2];
    const [fill, edge] = [this.polygon.geometry, this.edge.geometry];
    let n = 0;
    for (let corner = 1; corner + 1 < corners.length; corner++) {
      [corners[0], corners[corner], corners[corner + 1]].forEach((at) => fill.attributes.position.setXYZ(n++, ...raised(at)));
    }
    fill.setDrawRange(0, n);
    [...corners, corners[0]].forEach((at, n) => at && edge.attributes.position.setXYZ(n, ...raised(at)));
    edge.setDrawRange(0, corners.length > 1 ? corners.length + 1 : 0);
    fill.attributes.position.needsUpdate = edge.attributes.position.needsUpdate = true;
    const centre = centreOfMass(this.robot, this.posture);
    const under = ground(centre.x, centre.y) + 1.6;
    this.centre.position.copy(centre);
    this.spot.position.set(centre.x, centre.y, under);
    const plumb = this.plumb.geometry.attributes.position;
    plumb.setXYZ(0, ...centre.toArray()).setXYZ(1, centre.x, centre.y, under);
    plumb.needsUpdate = true;
    const margin = this.recording.value('margin', this.place);
    const tint = margin === undefined || margin >= 0 ? this.tints.good : this.tints.bad;
    [this.polygon, this.edge, this.spot, this.plumb, this.centre].forEach((mark) => mark.material.color.set(tint));
  }

  showForces() {
    const { recording, place } = this;
    const value = (name) => recording.value(name, place) ?? 0;
    const mass = this.robot.legs.flatMap((leg) => leg.joints).reduce((sum, joint) => sum + joint.mass, this.robot.body?.mass ?? 0);
    const whole = this.robot.planar ? 8 : Math.max(mass * GRAVITY, 1);
    this.arrows.forEach((arrow, leg) => {
      const force = this.robot.planar
        ? new Vector3(value(`push.${leg}.0`), value(`push.${leg}.1`), value(`push.${leg}.2`))
        : new Vector3(value(`force.${leg}.0`), value(`force.${leg}.1`), recording.value(`force.${leg}.2`, place) ?? value(`load.${leg}`));
      const length = (force.length() / whole) * this.size * 0.8;
      arrow.visible = this.shows.forces && length > this.size * 0.004;
      if (!arrow.visible) return;
      arrow.position.copy(this.ends[leg]);
      arrow.quaternion.copy(towards(force.normalize()));
      arrow.shaft.scale.y = length;
      arrow.head.position.y = length;
    });
  }

  showSlips() {
    const { recording } = this;
    this.rings.forEach((ring, leg) => {
      const slip = recording.slips.find((slip) => slip.leg === leg && Math.abs(recording.endOf(slip.cycle) - this.time) < MARKED);
      ring.visible = Boolean(slip);
      const { x, y } = this.ends[leg];
      ring.position.set(x, y, this.surroundings.ground(x, y) + 1.8);
    });
  }

  /** Draws at once, with all pixels. */
  drawNow() {
    this.screen.drawNow();
  }

  /** Draws at once, as well as it can. */
  drawFine() {
    this.screen.drawFine();
  }

  render() {
    const middle = this.controls.target;
    this.sun.target.position.copy(middle);
    this.sun.position.set(-0.9, 2.6, 1.1).multiplyScalar(this.size).add(middle);
    this.screen.renderer.render(this.scene, this.camera);
  }
}
