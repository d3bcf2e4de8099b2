import { existsSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';

const folder = new URL('../../../shared/models/', import.meta.url);

export const NO_MODELS = 'The folder ../shared/models with sample models is not there.';

export const hasSharedModels = (): boolean => existsSync(folder);

export const sharedModelPath = (name: string): string => new URL(name, folder).pathname;

/** Serves the sample models to the page below `models/`; an ochre pixel in the place of pictures that are not there. */
export async function serveSharedModels(page: Page): Promise<void> {
  await page.route('**/tests/gpu/models/*', (route) => {
    const path = sharedModelPath(new URL(route.request().url()).pathname.split('/').pop()!);
    return route.fulfill(existsSync(path) ? { path } : { body: ochrePixel(), contentType: 'image/png' });
  });
}

function ochrePixel(): Buffer {
  const picture = new PNG({ width: 1, height: 1 });
  picture.data.set([204, 136, 34, 255]);
  return PNG.sync.write(picture);
}
