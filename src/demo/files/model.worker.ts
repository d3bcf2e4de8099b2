import { ModelError } from './ModelError.js';
import { meshBuffers } from './PlainMesh.js';
import { type ModelFile, type ReadModel, readModel } from './readModel.js';

/** What the worker says: where it is, what it read, or why it cannot. */
export type ModelWorkerMessage =
  | { kind: 'stage'; stage: string }
  | { kind: 'done'; model: ReadModel }
  | { kind: 'failed'; message: string; isModelError: boolean };

const post = (message: ModelWorkerMessage, transfer: Transferable[] = []): void => postMessage(message, { transfer });

/** The buffers to hand over; several views may share one. */
function buffersOf(model: ReadModel): ArrayBuffer[] {
  if (model.kind === 'mesh') return meshBuffers(model.mesh);
  return [...new Set(model.parts.buffers.map(({ buffer }) => buffer as ArrayBuffer))];
}

addEventListener('message', async ({ data }: MessageEvent<ModelFile[]>) => {
  try {
    const model = await readModel(data, (stage) => post({ kind: 'stage', stage }));
    post({ kind: 'done', model }, buffersOf(model));
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    post({ kind: 'failed', message, isModelError: error instanceof ModelError });
  }
});
