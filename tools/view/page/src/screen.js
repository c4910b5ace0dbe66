// Draws a scene into a canvas, with as many pixels as the machine is quick enough for.

import { ColorManagement, LinearSRGBColorSpace, PCFShadowMap, WebGLRenderer } from 'three';

// Colours are mixed as screens have them: no powers are taken for each pixel.
ColorManagement.enabled = false;

/** A frame that comes so late is slow: ms. */
const SLOW = 30;
/** Which share of the pixels along each side is drawn, from fast machines to slow ones. */
const SHARES = [1, 0.7, 0.5, 0.35];
/** After so long without motion all pixels are drawn: ms. */
const REST = 300;
/** Where edges are not smooth of themselves, so many pixels along each side of one make them so at rest. */
const FINE = 2;

export class Screen {
  /** `prepare` is called before each frame. */
  constructor(canvas, prepare) {
    this.prepare = prepare;
    this.isSoftware = isSoftware();
    this.sparing = this.isSoftware ? 1 : 0;
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.isSoftware, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    // Nothing waits until a shader is compiled.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.frame = 0;
  }

  resize(width, height) {
    this.renderer.setSize(width, height, false);
    this.share = undefined;
    this.usePixels(1);
  }

  /** Lets the graphics compile what a scene needs, while the page does something else. */
  prepareFor(scene, camera) {
    this.renderer.compile(scene, camera);
  }

  /** Waits for what they compile, before a frame would. */
  settle() {
    this.renderer.info.programs.forEach((program) => program.getUniforms());
  }

  /** Draws before the browser shows the page again, however often it is asked to. */
  draw() {
    if (this.due) return;
    const asked = performance.now();
    this.due = requestAnimationFrame(() => {
      this.adapt(performance.now() - asked);
      this.render();
    });
  }

  /** A machine whose frames come late draws fewer pixels while things move, and all of them at rest. */
  adapt(late) {
    if (late > SLOW) this.sparing = Math.min(this.sparing + 1, SHARES.length - 1);
    else if (late < SLOW / 3 && this.sparing) this.sparing = Math.max(this.sparing - 0.02, 0);
    this.usePixels(SHARES[Math.ceil(this.sparing)]);
    this.rest();
  }

  rest() {
    clearTimeout(this.resting);
    const best = this.isSoftware ? FINE : 1;
    this.resting = setTimeout(() => {
      if (this.share < best) this.drawFine();
    }, REST);
  }

  usePixels(share) {
    if (this.share === share) return;
    this.share = share;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2) * share);
  }

  /** Draws at once, with all pixels. */
  drawNow() {
    this.usePixels(1);
    this.render();
    this.rest();
  }

  /** Draws at once, as well as it can. */
  drawFine() {
    this.usePixels(this.isSoftware ? FINE : 1);
    this.render();
  }

  render() {
    cancelAnimationFrame(this.due);
    this.due = undefined;
    // Where frames come late, shadows follow in every third one.
    this.frame += 1;
    this.renderer.shadowMap.autoUpdate = this.share >= 1;
    this.renderer.shadowMap.needsUpdate = this.frame % 3 === 0;
    this.prepare();
  }
}

/** Whether the processor draws. */
function isSoftware() {
  const probe = document.createElement('canvas').getContext('webgl2');
  const named = probe?.getExtension('WEBGL_debug_renderer_info');
  const renderer = probe?.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : probe.RENDERER) ?? '';
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(renderer);
}
