// Draws a scene into a canvas, with a resolution that suits the speed of the machine.

import { ColorManagement, LinearSRGBColorSpace, PCFShadowMap, WebGLRenderer } from 'three';

// Colours are mixed in sRGB, which saves conversions of each pixel.
ColorManagement.enabled = false;

/** Delay of a frame above which the machine is slow, ms. */
const SLOW = 30;
/** Resolutions relative to the screen, from fast machines to slow ones. */
const SHARES = [1, 0.7, 0.5, 0.35];
/** Time without motion after which the full resolution is drawn, ms. */
const REST = 300;
/** Resolution at rest for software rendering, which has no antialiasing. */
const FINE = 2;

export class Screen {
  /** `prepare` is called before each frame. */
  constructor(canvas, prepare) {
    this.prepare = prepare;
    this.isSoftware = isSoftware();
    this.sparing = this.isSoftware ? 1 : 0;
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.isSoftware, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    // This check would wait for the compilation of each shader.
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

  /** Starts to compile the shaders of a scene in the background. */
  prepareFor(scene, camera) {
    this.renderer.compile(scene, camera);
  }

  /** Waits until the shaders are compiled, so that the first frame need not. */
  settle() {
    this.renderer.info.programs.forEach((program) => program.getUniforms());
  }

  /** Draws once in the next frame of the browser, for any number of calls. */
  draw() {
    if (this.due) return;
    const asked = performance.now();
    this.due = requestAnimationFrame(() => {
      this.adapt(performance.now() - asked);
      this.render();
    });
  }

  /** Lowers the resolution during motion if frames come late, and raises it again. */
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

  /** Draws immediately, in full resolution. */
  drawNow() {
    this.usePixels(1);
    this.render();
    this.rest();
  }

  /** Draws immediately, in the best resolution. */
  drawFine() {
    this.usePixels(this.isSoftware ? FINE : 1);
    this.render();
  }

  render() {
    cancelAnimationFrame(this.due);
    this.due = undefined;
    // With a lowered resolution, shadows are updated only in every third frame.
    this.frame += 1;
    this.renderer.shadowMap.autoUpdate = this.share >= 1;
    this.renderer.shadowMap.needsUpdate = this.frame % 3 === 0;
    this.prepare();
  }
}

/** Returns true if the processor draws, not a graphics card. */
function isSoftware() {
  const probe = document.createElement('canvas').getContext('webgl2');
  const named = probe?.getExtension('WEBGL_debug_renderer_info');
  const renderer = probe?.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : probe.RENDERER) ?? '';
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(renderer);
}
