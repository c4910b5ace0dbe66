// The surroundings of the robot: floor or table, blocks on the floor, objects. Lengths in mm.

import {
  BoxGeometry, CanvasTexture, CylinderGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, LinearMipmapNearestFilter, Mesh, MeshBasicMaterial,
  MeshLambertMaterial, PlaneGeometry, RepeatWrapping, ShadowMaterial, Vector3,
} from 'three';
import { colour } from './dom.js';

/** Side of a tile of the floor, mm. */
const TILE = 500;

export class Surroundings extends Group {
  /** Creates the surroundings of a recording, for a robot of a size. */
  constructor(recording, size) {
    super();
    this.recording = recording;
    this.size = size;
    this.floor = new Group();
    this.add(this.floor);
    if (recording.robot.planar) this.makeTable();
    else this.makeFloor();
    this.blocks = recording.scene.blocks.map((block) => this.makeBlock(block));
    this.things = recording.scene.objects.map((outline) => this.makeThing(outline));
  }

  /** Adds the table that the slider of a hand carries. */
  makeTable() {
    const { height, slope } = this.recording.scene;
    const thick = 10;
    this.table = new Mesh(new BoxGeometry(this.size * 1.5, thick, this.size * 0.7), new MeshLambertMaterial());
    this.table.receiveShadow = true;
    this.table.position.y = -thick / 2;
    this.table.rotation.z = Math.atan(slope[0]);
    this.floor.add(this.table);
    this.tableHeight = height;
    this.floor.position.y = (this.recording.robot.slider?.[1] ?? 0) + height;
  }

  makeFloor() {
    const { height, slope } = this.recording.scene;
    const span = this.size * 30;
    const shadow = new Mesh(new PlaneGeometry(span, span), new ShadowMaterial({ opacity: 0.22, depthWrite: false }));
    shadow.receiveShadow = true;
    // The lines are a texture, which is smooth at every distance.
    this.tile = document.createElement('canvas');
    this.tile.width = this.tile.height = 512;
    const map = new CanvasTexture(this.tile);
    map.wrapS = map.wrapT = RepeatWrapping;
    map.minFilter = LinearMipmapNearestFilter;
    const tiles = 2 * Math.ceil(span / TILE / 2);
    map.repeat.set(tiles, tiles);
    this.grid = new Mesh(new PlaneGeometry(tiles * TILE, tiles * TILE), new MeshBasicMaterial({ map, depthWrite: false }));
    this.grid.renderOrder = -1;
    this.floor.add(shadow, this.grid);
    const normal = new Vector3(-slope[0], -slope[1], 1).normalize();
    this.floor.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
    this.floor.position.z = height - 0.6;
  }

  /** Adds a block that reaches down to the lowest place of the floor under it. */
  makeBlock({ x, y, height }) {
    const corners = x.flatMap((x) => y.map((y) => this.plane(x, y)));
    const foot = Math.min(...corners, height) - 0.6;
    const geometry = new BoxGeometry(x[1] - x[0], y[1] - y[0], height - foot);
    const mesh = new Mesh(geometry, new MeshLambertMaterial());
    mesh.position.set((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (height + foot) / 2);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.edges = new LineSegments(new EdgesGeometry(geometry), new LineBasicMaterial());
    mesh.add(mesh.edges);
    this.add(mesh);
    return mesh;
  }

  makeThing(outline) {
    // An object with width and height is a standing cylinder; one with a radius is a cylinder along z.
    const cylinder = (radius, length) => new CylinderGeometry(radius, radius, length, 48);
    const geometry = 'disc' in outline ? cylinder(outline.disc, this.size * 0.42).rotateX(Math.PI / 2) : cylinder(outline.box[0] / 2, outline.box[1]);
    const mesh = new Mesh(geometry, new MeshLambertMaterial({ transparent: true, opacity: 0.82 }));
    // It is drawn after the forces inside, which show through.
    mesh.renderOrder = 1;
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    this.add(mesh);
    return mesh;
  }

  /** Applies the colours of the page's scheme. */
  recolour() {
    if (this.grid) this.drawTile();
    this.table?.material.color.set(colour('table'));
    this.things.forEach((thing) => thing.material.color.set(colour('thing')));
    this.blocks.forEach((block) => {
      block.material.color.set(colour('grid-strong'));
      block.edges.material.color.set(colour('muted'));
    });
  }

  /** Draws a tile of the floor: a line every 100 mm and a stronger border. */
  drawTile() {
    const [pen, { width }] = [this.tile.getContext('2d'), this.tile];
    pen.fillStyle = colour('stage');
    pen.fillRect(0, 0, width, width);
    for (let line = 0; line <= 5; line++) {
      const strong = line % 5 === 0;
      pen.fillStyle = colour(strong ? 'grid-strong' : 'grid');
      const half = strong ? 1.6 : 1.1;
      const at = (line * width) / 5;
      pen.fillRect(at - half, 0, 2 * half, width);
      pen.fillRect(0, at - half, width, 2 * half);
    }
    this.grid.material.map.needsUpdate = true;
  }

  /** Moves everything to its place between frames. The grid moves with the robot at `pose`. */
  move(place, pose) {
    const value = (name) => this.recording.value(name, place);
    const y = value('slider.1');
    if (y !== undefined) this.floor.position.set(value('slider.0'), y + this.tableHeight, 0);
    this.things.forEach((thing, n) => {
      thing.visible = this.recording.has(`thing.${n}.0`);
      if (!thing.visible) return;
      thing.position.set(value(`thing.${n}.0`), value(`thing.${n}.1`), 0);
      thing.rotation.z = (value(`thing.${n}.2`) * Math.PI) / 180;
    });
    const [x, y0] = pose ?? [0, 0];
    this.grid?.position.set(Math.round(x / TILE) * TILE, Math.round(y0 / TILE) * TILE, 0);
  }

  /** Returns the height of the floor without blocks. */
  plane(x, y) {
    const { height, slope } = this.recording.scene;
    return height + slope[0] * x + slope[1] * y;
  }

  /** Returns the height of the floor or of a block at a place. */
  ground(x, y) {
    const under = this.recording.scene.blocks.filter((block) => x >= block.x[0] && x <= block.x[1] && y >= block.y[0] && y <= block.y[1]);
    return Math.max(this.plane(x, y), ...under.map(({ height }) => height));
  }
}
