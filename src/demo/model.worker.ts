import { ModelError } from './ModelError.js';
import { meshBuffers } from './PlainMesh.js';
import { type ModelFile, type ReadModel, readModel } from './readModel.js';

/** What the worker says: where it is, what it read, or why it cannot. */
export type ModelWorkerMessage =
  | { kind: 'stage'; stage: string }
  | { kind: 'done'; model: ReadModel }
  | { kind: 'failed'; message: string; isModelError: boolean };

const post = (message: ModelWorkerMessage, transfer: Transferable[] = []): void => postMessage(message, { transfer });

addEventListener('message', async ({ data }: MessageEvent<ModelFile[]>) => {
  try {
    const model = await readModel(data, (stage) => post({ kind: 'stage', stage }));
    post({ kind: 'done', model }, meshBuffers(model.mesh));
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    post({ kind: 'failed', message, isModelError: error instanceof ModelError });
  }
});
