import type { Page } from '@playwright/test';
import suzanne from '@pmndrs/assets/models/suzi.glb.js';
import { NodeSurroundings } from '../../src/command/draw/NodeSurroundings.js';
import { dataOf } from '../../src/viewer/files/common/ModelFile.js';
import { readModel } from '../../src/viewer/files/readModel.js';
import { drop, openPlayground, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { tetrahedron } from '../../tools/modelFiles/GltfBuilder.js';
import { file } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { changedShare } from './pictures.js';

const SMALL = 'model=cube&mapSize=64&mapTones=4&outlines=off';

// Wide enough for the card.
test.use({ viewport: { width: 1000, height: 420 } });

/** The azimuth of the camera of the page's link, in degrees; undefined if the model is framed. */
async function azimuth(page: Page): Promise<number | undefined> {
  const camera = new URLSearchParams(await writtenHash(page)).get('camera');
  if (camera === null) return undefined;
  const [x, , z] = camera.split(',').map(Number);
  return (Math.atan2(x, z) * 180) / Math.PI;
}

/** A head that faces −z. */
async function turnedHead(): Promise<string> {
  const files = [{ name: 'suzanne.glb', content: new Blob([dataOf(suzanne)!]) }];
  const read = await readModel(files, () => {}, new NodeSurroundings('.'));
  if (read.kind !== 'mesh') throw new Error('expected a mesh');
  const { positions, indices } = read.mesh;
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${-positions[i]} ${positions[i + 1]} ${-positions[i + 2]}`);
  const corner = (at: number): number => 1 + (indices ? indices[at] : at);
  const corners = indices?.length ?? positions.length / 3;
  for (let at = 0; at < corners; at += 3) lines.push(`f ${corner(at)} ${corner(at + 1)} ${corner(at + 2)}`);
  return lines.join('\n');
}

test('a file opens in its first camera that sees the model, and V goes on to the others', async ({ page }) => {
  const builder = tetrahedron();
  const { json } = builder;
  json.cameras = [{ type: 'perspective', perspective: { yfov: 0.5, znear: 0.1 } }];
  // Aside of the model, in front of it, and behind it.
  json.nodes.push(
    { name: 'aside', camera: 0, translation: [30, 0, 6] },
    { name: 'front', camera: 0, translation: [0, 0, 9] },
    { name: 'back', camera: 0, translation: [0, 0, -9], rotation: [0, 1, 0, 0] },
  );
  json.scenes[0].nodes = [0, 1, 2, 3];
  await openPlayground(page, SMALL);
  await drop(page, [file('seen.glb', Buffer.from(builder.glb()))]);
  await ready(page);
  expect(await azimuth(page)).toBeCloseTo(0, 1);
  await expect(page.locator('#model-notes')).toContainText(
    '1 camera left out, from which nothing of the model is seen',
  );
  await page.locator('#drawing').press('v');
  const status = page.getByRole('status').first();
  await expect(status).toHaveText(/^View 2 of \d: back$/);
  expect(Math.abs((await azimuth(page))!)).toBeCloseTo(180, 1);
  await page.locator('#drawing').press('v');
  await expect(status).toHaveText(/^View 3 of \d$/);
  expect(await azimuth(page)).toBeUndefined();
});

test('a head that is dropped is seen from its face, and V goes through other views', async ({ page }) => {
  await openPlayground(page, SMALL);
  await drop(page, [file('head.obj', await turnedHead())]);
  await ready(page);
  expect(await azimuth(page)).toBeUndefined();
  const first = await readDrawing(page);
  // A view of the user's own is in the link.
  await page.locator('#drawing').press('Shift+ArrowLeft');
  const turned = (await azimuth(page))!;
  expect(180 - Math.abs(turned)).toBeLessThanOrEqual(45);
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.locator('#drawing').press('v');
  const status = page.getByRole('status').first();
  await expect(status).toHaveText('View 2 of 4');
  await ready(page);
  const second = await readDrawing(page);
  expect(changedShare(first, second)).toBeGreaterThan(0.05);
  expect(await azimuth(page)).toBeDefined();
  await page.getByRole('button', { name: 'Undo' }).click();
  await ready(page);
  expect(await azimuth(page)).toBeUndefined();
  await page.getByRole('button', { name: 'Redo' }).click();
  for (const number of [3, 4, 1]) {
    await page.getByRole('button', { name: 'Another view' }).click();
    await expect(status).toHaveText(`View ${number} of 4`);
  }
  await ready(page);
  expect(await azimuth(page)).toBeUndefined();
  expect(changedShare(first, await readDrawing(page))).toBe(0);
});
