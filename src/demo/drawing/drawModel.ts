import { damaged } from '../files/ModelError.js';
import { triangleCount } from '../files/PlainMesh.js';
import type { ReadModel } from '../files/readModel.js';
import type { MadeScene } from '../models/MadeScene.js';
import type { DrawnModel } from './DrawnModel.js';
import { drawMesh } from './drawMesh.js';
import type { Report } from './Report.js';

/** Makes a drawing of what was read, telling how it gets on. `broken`: how much of it was left out. */
export async function drawModel(
  read: ReadModel | MadeScene,
  report: Report,
  signal: AbortSignal,
): Promise<{ model: DrawnModel; broken: number }> {
  if (read.kind === 'mesh') {
    const count = triangleCount(read.mesh).toLocaleString('en');
    const onProgress = (progress: number): void => report(`joining ${count} triangles`, progress);
    return { model: await drawMesh(read.mesh, { signal, onProgress }), broken: read.broken };
  }
  report('putting the parts together');
  try {
    const { drawScene } = await import('./drawScene.js');
    const scene =
      read.kind === 'scene' ? read.scene : await (await import('../files/parseGltf.js')).parseGltf(read.parts);
    signal.throwIfAborted();
    return await drawScene(scene, { signal, onProgress: (progress) => report('joining triangles', progress) });
  } catch (error) {
    signal.throwIfAborted();
    throw damaged(read.name, error);
  }
}
