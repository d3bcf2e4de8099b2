/** A page that has a scene with a knot, a camera, a renderer and nothing else, and runs the first lines of the README. */
import * as three from 'three';
import { Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, TorusKnotGeometry, WebGLRenderer } from 'three';
import * as hatching from 'three-hatching';

/** The number of equal frames after which nothing more is to come. */
const EQUAL_FRAMES = 5;

const nextFrame = (): Promise<number> => new Promise(requestAnimationFrame);

type AsyncFunction = (...values: unknown[]) => Promise<void>;
const AsyncFunction = Object.getPrototypeOf(async () => {}).constructor as new (...source: string[]) => AsyncFunction;

/**
 * Runs code that draws again and again.
 *
 * @param width of the canvas, in pixels
 * @returns what it draws in the end, as the address of a PNG
 */
async function drawThreeLines(code: string, width: number, height: number): Promise<string> {
  const scene = new Scene().add(new Mesh(new TorusKnotGeometry(0.7, 0.24, 200, 32), new MeshBasicMaterial()));
  const camera = new PerspectiveCamera(26, width / height);
  camera.position.z = 6.2;
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(width, height);
  document.body.append(renderer.domElement);
  const known: Record<string, unknown> = { ...three, ...hatching, scene, camera, renderer };
  const names = Object.keys(known).filter((name) => new RegExp(`\\b${name}\\b`).test(code));
  await new AsyncFunction(...names, code)(...names.map((name) => known[name]));
  let picture = '';
  for (let equal = 0; equal < EQUAL_FRAMES; ) {
    await nextFrame();
    const next = renderer.domElement.toDataURL('image/png');
    equal = next === picture ? equal + 1 : 0;
    picture = next;
  }
  renderer.setAnimationLoop(null);
  return picture;
}

declare global {
  interface Window {
    drawThreeLines?: typeof drawThreeLines;
  }
}
window.drawThreeLines = drawThreeLines;
