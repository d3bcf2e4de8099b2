import { toModelError } from '../../files/common/ModelError.js';
import { withPictures } from '../../files/decodePictures.js';
import { meshBuffers } from '../../files/mesh/PlainMesh.js';
import { type ModelFile, type OnStage, type ReadModel, readModel } from '../../files/readModel.js';
import { PAGE_SURROUNDINGS } from './pageSurroundings.js';

/** Messages of the worker: its progress, its result, or the sentence of its error. */
export type ModelWorkerMessage =
  | { kind: 'stage'; stage: string; bytes: number | undefined }
  | { kind: 'done'; model: ReadModel }
  | { kind: 'failed'; sentence: string };

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

addEventListener('message', async ({ data }: MessageEvent<ModelFile[]>) => {
  try {
    const onStage: OnStage = (stage, bytes) => post({ kind: 'stage', stage, bytes });
    const model = await withPictures(await readModel(data, onStage, PAGE_SURROUNDINGS), onStage, PAGE_SURROUNDINGS);
    post({ kind: 'done', model }, transferables(model));
  } catch (error) {
    post({ kind: 'failed', sentence: toModelError('The file', error).message });
  }
});
