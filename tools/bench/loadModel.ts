import { type BufferGeometry, TorusGeometry } from 'three';
import { loadModel as loadNamed, type ModelName } from '../metrics/loadModel.js';

/**
 * A model with smooth normals, centred, with a bounding radius of 1: a model of the metrics, such as `dragon48k`, or a
 * torus of so many thousand triangles, such as `torus500k`.
 */
export async function loadModel(name: string): Promise<BufferGeometry> {
  const thousands = /^torus(\d+)k$/.exec(name)?.[1];
  if (thousands === undefined) return loadNamed(name as ModelName);
  const segments = Math.sqrt(500 * Number(thousands));
  return new TorusGeometry(1 / 1.4, 0.4 / 1.4, segments, segments);
}
