import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { vi } from 'vitest';
import { BUILT_IN_MODELS, type BuiltInModel } from '../../../../src/playground/models/models.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { type ModelFile, readModel } from '../../../../src/viewer/files/readModel.js';

const root = fileURLToPath(new URL('../../../..', import.meta.url));
const { signal } = new AbortController();

/** Where models lie that are no part of this repository. */
export const SHARED = `${root}/../shared/models`;

/** Serves what Vite addresses from the root of the repository, as its server does. Call it before models are loaded. */
export function serveFiles(): void {
  vi.stubGlobal('ProgressEvent', class {});
  vi.stubGlobal(
    'Request',
    class {
      constructor(readonly url: string) {}
    },
  );
  vi.stubGlobal('fetch', async (asked: string | { url: string }) => {
    const url = typeof asked === 'string' ? asked : asked.url;
    return new Response(readFileSync(`${root}${url.replace(/\?.*/, '')}`));
  });
}

/** A model of the page, as it is drawn. */
export async function builtInModel(name: BuiltInModel): Promise<HatchedModel> {
  const read = await BUILT_IN_MODELS[name].load({ signal, onStage() {} });
  return (await buildModel(read, () => {}, signal)).model;
}

/** A model of {@link SHARED}, as it is drawn. */
export async function sharedModel(...names: readonly string[]): Promise<HatchedModel> {
  const files: ModelFile[] = names.map((name) => ({ name, content: new Blob([readFileSync(`${SHARED}/${name}`)]) }));
  return (await buildModel(await readModel(files, () => {}), () => {}, signal)).model;
}
