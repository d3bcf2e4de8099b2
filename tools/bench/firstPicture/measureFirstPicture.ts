import {
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  Group,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { applyHatching, TonalArtMap } from 'three-hatching';
import { loadModel } from '../loadModel.js';

const SIZE = 256;
const LOOK = { material: { technique: 'hatching' }, outlines: true } as const;

/** The order of the work before the first picture: in sequence or in parallel. */
export type Arrangement = 'inTurn' | 'together';

/** Milliseconds by phase, from the loaded model to the first hatched picture that can be read. */
export async function measureFirstPicture(
  model: string,
  parts: number,
  arrangement: Arrangement,
): Promise<Record<string, number>> {
  const root = inParts(await loadModel(model), parts);
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  const scene = new Scene().add(root, sun);
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(0, 0.3, 3.2);
  camera.lookAt(0, 0, 0);
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(SIZE, SIZE, false);
  document.body.append(renderer.domElement);
  const gl = renderer.getContext();

  const times: Record<string, number> = {};
  const start = performance.now();
  let last = start;
  const note = (phase: string): void => {
    const now = performance.now();
    times[phase] = now - last;
    last = now;
  };
  if (arrangement === 'together') {
    // A map of its own, since a shared one would be drawn already the second time.
    await applyHatching(root, { ...LOOK, tonalArtMap: { seed: 1 }, renderer, camera });
    note('all before');
  } else {
    const { materials } = await applyHatching(root, { ...LOOK, tonalArtMap: null });
    note('bake');
    const map = await TonalArtMap.generate();
    for (const material of materials) material.tonalArtMap = map;
    note('map');
    await renderer.compileAsync(scene, camera);
    note('programs');
  }
  renderer.render(scene, camera);
  // Only reading a pixel waits until the frame is drawn.
  gl.readPixels(SIZE / 2, SIZE / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  note('first frame');
  times.whole = performance.now() - start;
  return times;
}

/** Divides a model among meshes with as many triangles each, as a file of several parts has them. */
function inParts({ index, attributes }: BufferGeometry, count: number): Group {
  const root = new Group();
  const corners = index!.count / 3;
  for (let part = 0; part < count; part++) {
    const [from, to] = [part, part + 1].map((i) => 3 * Math.round((corners * i) / count));
    const places = new Map<number, number>();
    const indices: number[] = [];
    for (let i = from; i < to; i++) {
      const vertex = index!.getX(i);
      if (!places.has(vertex)) places.set(vertex, places.size);
      indices.push(places.get(vertex)!);
    }
    const geometry = new BufferGeometry().setIndex(indices);
    for (const name of ['position', 'normal']) {
      const values = new Float32Array(3 * places.size);
      for (const [vertex, place] of places) {
        for (let axis = 0; axis < 3; axis++) values[3 * place + axis] = attributes[name].getComponent(vertex, axis);
      }
      geometry.setAttribute(name, new BufferAttribute(values, 3));
    }
    root.add(new Mesh(geometry, new MeshStandardMaterial()));
  }
  return root;
}
