/** Draws of nodes what the reference in double precision is asked for; the page's address names the backend: `?forceWebGL`, `?webgpu`. */
import { HatchingMaterial } from 'three-hatching';
import { HatchingNodeMaterial } from 'three-hatching/webgpu';
import { lackOfWebGPU } from '../../tools/browser/lackOfWebGPU.js';
import type { HatchingSpec } from '../gpu/hatchingSpec.js';
import { inBase64 } from '../gpu/inBase64.js';
import { specScene } from '../gpu/specScene.js';
import { type Drawer, drawerOfNodes } from './drawing.js';

// What is measured is one thing by itself, and not a scene that somebody would draw.
HatchingMaterial.silent = true;

const drawn = location.search === '?webgpu' ? 'webgpu' : 'forceWebGL';
const lack = drawn === 'webgpu' ? await lackOfWebGPU() : null;

let drawer: Promise<Drawer> | undefined;

/** Renders a picture and returns its pixels (RGBA, bottom row first) in base64, as the page of GLSL does. */
async function renderHatching(spec: HatchingSpec): Promise<string> {
  const materials: HatchingNodeMaterial[] = [];
  const { dispose, ...stage } = await specScene(spec, (parameters) => {
    const material = new HatchingNodeMaterial(parameters);
    materials.push(material);
    return material;
  });
  await Promise.all(materials.map(({ ready }) => ready));
  drawer ??= drawerOfNodes(drawn, spec.width);
  const { renderer, draw, read } = await drawer;
  renderer.shadowMap.enabled = true;
  draw(stage);
  const pixels = await read();
  dispose();
  return inBase64(pixels);
}

const gl = document.createElement('canvas').getContext('webgl2')!;
window.subpixelBits = gl.getParameter(gl.SUBPIXEL_BITS);

declare global {
  interface Window {
    /** Why the page cannot draw, as a sentence; null where it can. */
    lack: string | null;
  }
}
window.lack = lack;
window.renderHatching = renderHatching;
