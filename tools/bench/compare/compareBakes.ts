import type { PrepareHatchingGeometryOptions } from 'three-hatching';
import { loadModel } from '../loadModel.js';
import { alternate, type Effort, type Times } from './alternate.js';
import { loadLibraries } from './loadLibraries.js';

/** Time of `prepareHatchingGeometry` in both libraries, the way to the worker and back included. */
export async function compareBakes(
  model: string,
  layout: PrepareHatchingGeometryOptions['layout'],
  effort: Effort,
): Promise<Times> {
  const libraries = await loadLibraries();
  const source = await loadModel(model);
  return alternate(effort, async (side) => {
    const start = performance.now();
    await libraries[side].prepareHatchingGeometry(source, { layout });
    return performance.now() - start;
  });
}
