// Names of feet, of the axes of the robot's frame, and of its front in the scene. Their size does not depend on the distance.

import { CanvasTexture, Group, Sprite, SpriteMaterial } from 'three';
import { colour, legColour } from './dom.js';
import { whenSpoken, word } from './words.js';

/** Height of a name relative to the height of the view, and of its picture, px. */
const [TALL, PIXELS] = [0.026, 48];
const AXES = ['x', 'y', 'z'];

export class Labels extends Group {
  constructor(robot) {
    super();
    this.feet = robot.legs.map((_, leg) => this.label(`F${leg + 1}`, () => legColour(leg)));
    this.axes = AXES.map((axis) => this.label(axis, () => colour(`axis-${axis}`)));
    this.front = robot.body && this.label('', () => colour('text'));
    if (this.front) {
      whenSpoken(() => {
        this.front.text = word('front');
        draw(this.front);
      });
    }
  }

  label(text, tint) {
    const map = new CanvasTexture(document.createElement('canvas'));
    const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }));
    Object.assign(sprite, { text, tint, renderOrder: 3 });
    sprite.center.set(0.5, -0.25);
    this.add(sprite);
    return sprite;
  }

  /** Applies the colours of the page's scheme. */
  recolour() {
    this.children.forEach(draw);
  }

  /** Moves the names to feet, ends of axes and the front. */
  put(feet, axes, front) {
    feet.forEach((foot, leg) => this.feet[leg].position.copy(foot));
    axes.forEach((end, axis) => this.axes[axis].position.copy(end));
    if (front) this.front.position.copy(front);
  }
}

/** Draws the text of a sprite, with an outline that keeps it legible on any background. */
function draw(sprite) {
  const { map } = sprite.material;
  const { image } = map;
  const pen = image.getContext('2d');
  const font = `600 ${PIXELS * 0.75}px system-ui, sans-serif`;
  pen.font = font;
  const width = Math.ceil(pen.measureText(sprite.text).width) + 12;
  if (image.width !== width) {
    // A texture cannot change its size; the next upload makes a new one.
    map.dispose();
    [image.width, image.height] = [width, PIXELS];
  }
  pen.clearRect(0, 0, width, PIXELS);
  Object.assign(pen, { font, textBaseline: 'middle', textAlign: 'center', lineJoin: 'round', lineWidth: 6, strokeStyle: colour('stage'), fillStyle: sprite.tint() });
  pen.strokeText(sprite.text, width / 2, PIXELS / 2);
  pen.fillText(sprite.text, width / 2, PIXELS / 2);
  map.needsUpdate = true;
  sprite.scale.set((TALL * width) / PIXELS, TALL, 1);
}
