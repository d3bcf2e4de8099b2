import { toModelError } from '../../files/common/ModelError.js';
import { withPictures } from '../../files/decodePictures.js';
import { checkTriangleCount } from '../../files/mesh/checkTriangleCount.js';
import { meshBuffers, triangleCount } from '../../files/mesh/PlainMesh.js';
import { type ModelFile, type OnStage, type ReadMesh, type ReadModel, readModel } from '../../files/readModel.js';
import { PAGE_SURROUNDINGS } from './pageSurroundings.js';
import { coarseModel, isTooFine, simplified } from './readLarge.js';

/** Messages of the worker: its progress, its result, or the sentence of its error. */
export type ModelWorkerMessage =
  | { kind: 'stage'; stage: string; bytes: number | undefined }
  | { kind: 'coarse'; model: ReadModel }
  | { kind: 'done'; model: ReadModel }
  | { kind: 'failed'; sentence: string };

/** How often the worker says how far it is, in milliseconds. */
const STAGE_MS = 500;

const post = (message: ModelWorkerMessage, transfer: Transferable[] = []): void => postMessage(message, { transfer });

/** The buffers and bitmaps to transfer. Several pictures may share a bitmap. */
function transferables(model: ReadModel): Transferable[] {
  if (model.kind === 'mesh') {
    const bitmaps = model.pictures.flatMap((picture) => (picture ? [picture.bitmap] : []));
    // The stand-in may share the normals of the mesh.
    const buffers = new Set([...meshBuffers(model.mesh), ...(model.plainNormals ? [model.plainNormals.buffer] : [])]);
    return [...buffers, ...new Set(bitmaps)] as Transferable[];
  }
  const { arrays, bitmaps } = model.parts;
  return [...arrays, ...(bitmaps.filter((bitmap) => bitmap !== undefined) as Transferable[])];
}

/** Shows a coarse copy of a model at once, and simplifies the model. Where that fails, the model is drawn as it is, if it can be. */
async function lessOf(model: ReadMesh, onStage: OnStage): Promise<ReadMesh> {
  const coarse = coarseModel(model);
  post({ kind: 'coarse', model: coarse }, transferables(coarse));
  const stage = `simplifying ${triangleCount(model.mesh).toLocaleString('en')} triangles`;
  onStage(stage);
  let said = performance.now();
  const onProgress = (progress: number): void => {
    if (performance.now() < said + STAGE_MS) return;
    said = performance.now();
    onStage(`${stage}: ${Math.floor(100 * progress)} %`);
  };
  try {
    return await simplified(model, onProgress);
  } catch (error) {
    console.warn(`The model is drawn with all its triangles, because it could not be simplified. ${error}`);
    return model;
  }
}

addEventListener('message', async ({ data }: MessageEvent<ModelFile[]>) => {
  try {
    const onStage: OnStage = (stage, bytes) => post({ kind: 'stage', stage, bytes });
    const model = await withPictures(await readModel(data, onStage, PAGE_SURROUNDINGS), onStage, PAGE_SURROUNDINGS);
    const drawn = isTooFine(model) ? await lessOf(model, onStage) : model;
    if (drawn.kind === 'mesh') checkTriangleCount(triangleCount(drawn.mesh));
    post({ kind: 'done', model: drawn }, transferables(drawn));
  } catch (error) {
    post({ kind: 'failed', sentence: toModelError('The file', error).message });
  }
});
