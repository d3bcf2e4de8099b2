import type { Page } from '@playwright/test';
import { drop, idle } from '../browser/playground.js';
import { watchProblems } from '../browser/watchProblems.js';
import { file, octahedronObj } from '../modelFiles/modelFiles.js';

/** Features that browsers may lack. Each function runs in a page before its own scripts, and removes one feature. */
export const LACKS: Readonly<Record<string, () => void>> = {
  'without workers': () => {
    Reflect.deleteProperty(window, 'Worker');
  },
  'with storage that never answers': () => {
    indexedDB.open = () => new EventTarget() as IDBOpenDBRequest;
  },
};

/**
 * Opens the playground in a page of its own whose browser lacks something, has a model of the user's own drawn, and reloads it.
 *
 * @param lack a key of {@link LACKS}
 * @throws Error if the page complains, or does not draw the model
 */
export async function visitPoor(page: Page, lack: string): Promise<void> {
  const visit = await page.context().browser()!.newPage({ viewport: page.viewportSize() });
  try {
    const problems = watchProblems(visit);
    await visit.addInitScript(LACKS[lack]);
    await visit.goto(`${new URL('.', page.url())}#model=cube&mapSize=64&mapTones=4`);
    await idle(visit);
    await drop(visit, [file('octahedron.obj', octahedronObj)]);
    await idle(visit);
    const name = await visit.locator('#model-name').textContent();
    const isError = await visit.locator('#status.is-error').count();
    if (name !== 'octahedron.obj' || isError > 0) {
      throw new Error(`A browser ${lack} draws ${name}: ${await visit.locator('#status').textContent()}`);
    }
    // The page writes a little later into its address that the model is kept.
    await visit.waitForFunction(() => history.state !== null);
    await visit.reload();
    await idle(visit);
    if (problems.length > 0) throw new Error(`A browser ${lack}: ${problems.join('\n')}`);
  } finally {
    await visit.close();
  }
}
