/** Draws what the reference in double precision is asked for. */
import { LinearSRGBColorSpace, WebGLRenderer } from 'three';
import { HatchingMaterial } from 'three-hatching';
import type { HatchingSpec } from './hatchingSpec.js';
import { inBase64 } from './inBase64.js';
import { specScene } from './specScene.js';

// Scenes test one thing each and are odd on purpose, so warnings about looks are off.
HatchingMaterial.silent = true;

const renderer = new WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
renderer.outputColorSpace = LinearSRGBColorSpace;
renderer.shadowMap.enabled = true;
document.body.append(renderer.domElement);

/** Renders a picture and returns its pixels (RGBA, bottom row first) in base64, which is passed much faster than a list of numbers. */
async function renderHatching(spec: HatchingSpec): Promise<string> {
  const { scene, camera, dispose } = await specScene(spec, (parameters) => new HatchingMaterial(parameters));
  renderer.setSize(spec.width, spec.height, false);
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(spec.width * spec.height * 4);
  gl.readPixels(0, 0, spec.width, spec.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const error = gl.getError();
  if (error !== gl.NO_ERROR) throw new Error(`WebGL error ${error}`);
  dispose();
  return inBase64(pixels);
}

declare global {
  interface Window {
    /** The subpixel precision of the GPU in bits: vertices are moved to this grid. */
    subpixelBits: number;
    renderHatching: typeof renderHatching;
  }
}
const gl = renderer.getContext();
window.subpixelBits = gl.getParameter(gl.SUBPIXEL_BITS);
// Tests draw in the same turn in which they make their materials.
await HatchingMaterial.preload();
window.renderHatching = renderHatching;
