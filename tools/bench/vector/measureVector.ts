import { DirectionalLight, Mesh, PerspectiveCamera, Scene, Vector3 } from 'three';
import {
  disposeHatchingWorkers,
  HatchingMaterial,
  type HatchingMaterialParameters,
  HatchingOutlines,
  prepareHatchingGeometry,
} from 'three-hatching';
import { type DrawSVGOptions, drawSVG } from 'three-hatching/svg';
import { loadModel } from '../loadModel.js';

/** The look of a vector drawing, and its shadows. */
const DRAWINGS: Record<string, { direction: HatchingMaterialParameters['direction']; options: DrawSVGOptions }> = {
  light: { direction: 'light', options: { shadows: false } },
  form: { direction: 'form', options: { shadows: false } },
  'light, hard shadow': { direction: 'light', options: { shadows: 'hard' } },
  'light, soft shadow': { direction: 'light', options: { shadows: 'soft' } },
  'light, one pen': { direction: 'light', options: { shadows: false, kind: 'pen' } },
};

/** Milliseconds of each drawing: the bake of its geometry, and the repeated drawing. */
export interface VectorTimes {
  triangles: number;
  drawings: Record<string, { bake: number; times: number[]; paths: number; kilobytes: number }>;
}

/** Draws a model as lines on a sheet of 200 mm, as often as `repeats` says, the ways of drawing in turn. */
export async function measureVector(model: string, repeats: number): Promise<VectorTimes> {
  const plain = await loadModel(model);
  const camera = new PerspectiveCamera(28, 1, 0.1, 50);
  camera.position.copy(new Vector3(0.5, 0.4, 2).setLength(4.4));
  camera.lookAt(0, 0, 0);
  const sun = new DirectionalLight('white', Math.PI);
  sun.position.set(-2.7, 3.7, 3);
  sun.castShadow = true;
  const found: VectorTimes = { triangles: (plain.index?.count ?? 0) / 3, drawings: {} };
  const scenes: Record<string, Scene> = {};
  for (const [name, { direction }] of Object.entries(DRAWINGS)) {
    const start = performance.now();
    const form = direction === 'form';
    const geometry = await prepareHatchingGeometry(plain, { technique: 'engraving', outlines: true, form });
    found.drawings[name] = { bake: performance.now() - start, times: [], paths: 0, kilobytes: 0 };
    const mesh = new Mesh(geometry, new HatchingMaterial({ preset: 'engraving', technique: 'engraving', direction }));
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.add(new HatchingOutlines(mesh));
    scenes[name] = new Scene().add(mesh, sun.clone());
  }
  for (let i = 0; i < repeats; i++) {
    for (const [name, { options }] of Object.entries(DRAWINGS)) {
      const { seconds, paths, svg } = await drawSVG(scenes[name], camera, { sheet: [200, 200], ...options });
      const row = found.drawings[name];
      row.times.push(1000 * seconds);
      Object.assign(row, { paths, kilobytes: svg.length / 1000 });
    }
  }
  disposeHatchingWorkers();
  return found;
}
