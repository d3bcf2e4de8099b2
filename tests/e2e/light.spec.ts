import type { Page } from '@playwright/test';
import {
  dragLamp,
  drop,
  follow,
  lampPlace,
  middleOf,
  openPlayground,
  readDrawing,
  ready,
  refreshes,
  writtenHash,
} from '../../tools/browser/playground.js';
import { BOX_CORNERS, BOX_FACES } from '../../tools/modelFiles/box.js';
import { GltfBuilder } from '../../tools/modelFiles/GltfBuilder.js';
import { file, octahedronObj } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { angleBetween, changedShare, meanInk, type Region, strokeDirection } from './pictures.js';

test.use({ viewport: { width: 640, height: 480 } });

/** Within the face of the cube that looks at the camera. */
const FACE: Region = { left: 0.42, top: 0.36, right: 0.58, bottom: 0.64 };
const LEFT_HALF: Region = { left: 0.3, top: 0.2, right: 0.5, bottom: 0.8 };
const RIGHT_HALF: Region = { left: 0.5, top: 0.2, right: 0.7, bottom: 0.8 };
/** The technique and the light of the paper by Suarez et al., for which the reference below holds. */
const PAPER =
  'exposure=fixed&technique=adjacency&strokeTurn=towards&lightStrength=100&reflectedLight=0&mapStyle=hatching&';
/** Mean darkness of the darkest hatch image of the style. */
const MAX_INK = 0.95;
/** Tolerance of directions, degrees: the strokes of a map vary slightly. */
const MAX_DEVIATION = 8;

/** Direction to the light, by the label of its handle. The camera looks along −z. */
async function towardsLight(page: Page): Promise<{ x: number; y: number; z: number }> {
  const { azimuth, elevation } = await lampPlace(page);
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  return { x: Math.sin(a) * Math.cos(e), y: Math.sin(e), z: Math.cos(a) * Math.cos(e) };
}

/** Algorithm 1 for a face with the normal (0, 0, 1): B is the light's direction projected onto the face, T = B × N. */
async function expectFaceAsReference(page: Page, along: 'T' | 'B'): Promise<void> {
  const light = await towardsLight(page);
  const picture = await readDrawing(page);
  const towards = (Math.atan2(light.y, light.x) * 180) / Math.PI;
  const expected = along === 'B' ? towards : towards + 90;
  expect(angleBetween(strokeDirection(picture, FACE), expected), 'degrees between strokes and reference').toBeLessThan(
    MAX_DEVIATION,
  );
  expect(meanInk(picture, FACE), 'mean ink against the tone 1 − N·L').toBeCloseTo(MAX_INK * (1 - light.z), 1);
}

test('strokes and tone of a face follow the light when it is dragged', async ({ page }) => {
  await openPlayground(
    page,
    `${PAPER}model=cube&camera=0,0,5,0,0,0&lightAzimuth=45&lightElevation=5&tilesPerObjectUnit=5`,
  );
  await expectFaceAsReference(page, 'B');
  const before = await lampPlace(page);
  await dragLamp(page, { x: -40, y: -90 });
  const after = await lampPlace(page);
  expect(after.azimuth).toBeLessThan(before.azimuth - 5);
  expect(after.elevation).toBeGreaterThan(before.elevation + 15);
  await expectFaceAsReference(page, 'B');

  await follow(page, `${(await writtenHash(page)).slice(1)}&strokeTurn=along`);
  await expectFaceAsReference(page, 'T');
});

test('the light moves across in front of the model from its first place, also if the pointer wavers at the edge', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, `${PAPER}model=cube`);
  const lamp = await middleOf(page, '#lamp');
  await page.mouse.move(lamp.x, lamp.y);
  await page.mouse.down();
  await page.mouse.move(lamp.x - 4, lamp.y - 9);
  await page.mouse.move(lamp.x + 160, lamp.y + 40, { steps: 6 });
  await page.mouse.up();
  await expect(page.locator('#lamp')).not.toHaveClass(/is-behind/);
  await expect(page.getByRole('slider', { name: 'Light' })).toHaveAttribute('aria-valuetext', /in front of the model/);
});

test('the side that faces the light is lighter, and the light goes behind the model past the edge', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, `${PAPER}model=sphere&camera=0,0,6,0,0,0&lightAzimuth=-60&lightElevation=0`);
  const fromLeft = await readDrawing(page);
  expect(meanInk(fromLeft, RIGHT_HALF)).toBeGreaterThan(meanInk(fromLeft, LEFT_HALF) + 0.2);

  const { x } = await middleOf(page, '#lamp');
  const { x: centre } = await middleOf(page, '#viewport');
  await dragLamp(page, { x: 2 * (centre - x), y: 0 });
  const fromRight = await readDrawing(page);
  expect(meanInk(fromRight, LEFT_HALF)).toBeGreaterThan(meanInk(fromRight, RIGHT_HALF) + 0.2);
  expect(meanInk(fromRight, RIGHT_HALF)).toBeCloseTo(meanInk(fromLeft, LEFT_HALF), 1);

  const lamp = await middleOf(page, '#lamp');
  await page.mouse.move(lamp.x, lamp.y);
  await page.mouse.down();
  await page.mouse.move(lamp.x + 160, lamp.y, { steps: 4 });
  await page.mouse.move(lamp.x - 120, lamp.y, { steps: 4 });
  await page.mouse.up();
  expect(Math.abs((await lampPlace(page)).azimuth)).toBeGreaterThan(90);
  await expect(page.locator('#lamp')).toHaveClass(/is-behind/);
  expect(meanInk(await readDrawing(page), RIGHT_HALF)).toBeGreaterThan(meanInk(fromRight, RIGHT_HALF) + 0.2);

  await page.locator('#lamp').dblclick();
  expect(await lampPlace(page)).toMatchObject({ azimuth: -54, elevation: 38 });
});

test('a second sun lightens its side, and crosses the strokes unless there is one layer', { tag: '@all' }, async ({
  page,
}) => {
  const view = `${PAPER}model=sphere&camera=0,0,6,0,0,0&lightAzimuth=-70&lightElevation=20`;
  await openPlayground(page, view);
  const alone = await readDrawing(page);
  await openPlayground(page, `${view}&secondLight=right`);
  const crossed = await readDrawing(page);
  await openPlayground(page, `${view}&secondLight=right&strokeLayers=single`);
  const single = await readDrawing(page);
  expect(meanInk(crossed, RIGHT_HALF)).toBeLessThan(meanInk(alone, RIGHT_HALF) - 0.05);
  expect(changedShare(crossed, single)).toBeGreaterThan(0.01);
  // Two layers are as dark as one.
  expect(meanInk(crossed, RIGHT_HALF)).toBeCloseTo(meanInk(single, RIGHT_HALF), 1);
});

test('no lamp hides its model when the page opens, on any sheet, and its label has no box', { tag: '@all' }, async ({
  page,
}) => {
  test.slow();
  // A view that colours all of the model, and nothing else.
  const all = 'debugView=frames&outlines=off&technique=triangle&mapSize=64&mapTones=4';
  await openPlayground(page, `model=cube&${all}`);
  await expect(page.locator('#lamp .hint')).toHaveCSS('background-color', 'rgba(0, 0, 0, 0)');
  for (const model of [
    'dragon4&shadows=on&ground=shadow',
    'bunny',
    'bust&lightAzimuth=-62&lightElevation=34',
    'hand',
  ]) {
    await page.goto('about:blank');
    for (const [width, height] of [
      [1000, 700],
      [390, 844],
      [360, 640],
    ] as const) {
      await page.setViewportSize({ width, height });
      if (width === 1000) await openPlayground(page, `model=${model}&${all}`);
      const picture = await readDrawing(page);
      const view = (await page.locator('#viewport').boundingBox())!;
      const lamp = await middleOf(page, '#lamp');
      let hidden = 0;
      const paper = picture.data.readUInt32LE(0);
      for (let y = 0; y < picture.height; y++) {
        for (let x = 0; x < picture.width; x++) {
          if (Math.hypot(x - lamp.x + view.x, y - lamp.y + view.y) > 22) continue;
          if (picture.data.readUInt32LE(4 * (y * picture.width + x)) !== paper) hidden++;
        }
      }
      expect(hidden, `${model}, ${width} wide`).toBe(0);
    }
  }
});

test('a second light is dragged by a lamp of its own', { tag: '@all' }, async ({ page }) => {
  await openPlayground(
    page,
    `${PAPER}model=sphere&camera=0,0,6,0,0,0&lightAzimuth=-70&lightElevation=20&secondLight=right&secondStrength=100`,
  );
  const first = await lampPlace(page);
  expect(await lampPlace(page, '#second-lamp')).toMatchObject({ azimuth: 20, elevation: 20 });
  const before = await readDrawing(page);
  await dragLamp(page, { x: 60, y: 40 }, '#second-lamp');
  const second = await lampPlace(page, '#second-lamp');
  expect(second.azimuth).toBeGreaterThan(35);
  expect(second.elevation).toBeLessThan(15);
  expect(await lampPlace(page)).toEqual(first);
  expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.05);

  // The second lamp no longer follows the first.
  await dragLamp(page, { x: 20, y: 30 });
  expect(await lampPlace(page)).not.toEqual(first);
  expect(await lampPlace(page, '#second-lamp')).toEqual(second);
  await page.locator('#second-lamp').press('ArrowLeft');
  expect((await lampPlace(page, '#second-lamp')).azimuth).toBeCloseTo(second.azimuth - 5, 0);
  expect(await writtenHash(page)).toContain('secondLight=free');
  const dragged = await readDrawing(page);
  const place = await lampPlace(page);
  await page.reload();
  expect(changedShare(dragged, await readDrawing(page))).toBe(0);
  expect(await lampPlace(page)).toEqual(place);
});

test.describe('on a narrow sheet', () => {
  test.use({ viewport: { width: 320, height: 640 } });

  test('each light goes behind the model without leaving the sheet', { tag: '@all' }, async ({ page }) => {
    const isOnSheet = async () => {
      const { x, y } = await middleOf(page, '#lamp');
      const sheet = (await page.locator('#viewport').boundingBox())!;
      return x >= sheet.x && x <= sheet.x + sheet.width && y >= sheet.y && y <= sheet.y + sheet.height;
    };
    for (const kind of ['directional', 'point']) {
      // Near enough for the outline of the lamp's sphere to lie beyond both edges.
      await openPlayground(
        page,
        `model=sphere&mapSize=64&mapTones=4&outlines=off&camera=0,0,4,0,0,0&lightKind=${kind}&lightAzimuth=30&lightDistance=2.5`,
      );
      const from = await middleOf(page, '#lamp');
      const sheet = (await page.locator('#viewport').boundingBox())!;
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(sheet.x + sheet.width - 2, from.y, { steps: 4 });
      await refreshes(page, 2);
      expect(await isOnSheet()).toBe(true);
      await page.mouse.move(sheet.x + sheet.width / 2 + 40, from.y, { steps: 4 });
      await page.mouse.up();
      expect(Math.abs((await lampPlace(page)).azimuth), kind).toBeGreaterThan(90);
      expect(await isOnSheet()).toBe(true);
    }
  });
});

test('arrow keys move the light by 5°, with Shift by 1°', async ({ page }) => {
  await openPlayground(
    page,
    `${PAPER}model=cube&camera=0,0,5,0,0,0&lightAzimuth=40&lightElevation=10&tilesPerObjectUnit=5`,
  );
  await page.locator('#lamp').focus();
  await page.keyboard.press('ArrowRight');
  expect(await lampPlace(page)).toMatchObject({ azimuth: 45, elevation: 10 });
  await page.keyboard.press('Shift+ArrowUp');
  expect(await lampPlace(page)).toMatchObject({ azimuth: 45, elevation: 11 });
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowLeft');
  expect(await lampPlace(page)).toMatchObject({ azimuth: 44, elevation: 41 });
  await expectFaceAsReference(page, 'B');
});

test.describe('by touch', () => {
  test.use({ hasTouch: true });

  test('a finger moves the light, a second one changes its distance', { tag: '@all' }, async ({ page }) => {
    await openPlayground(
      page,
      `${PAPER}model=cube&camera=0,0,5,0,0,0&lightAzimuth=40&lightElevation=10&lightKind=point&tilesPerObjectUnit=5`,
    );
    const before = { place: await lampPlace(page), picture: await readDrawing(page) };
    const session = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((point, id) => ({ ...point, id })) });

    const from = await middleOf(page, '#lamp');
    const to = { x: from.x - 50, y: from.y - 80 };
    await touch('touchStart', [from]);
    for (const share of [0.25, 0.5, 0.75, 1]) {
      await touch('touchMove', [{ x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) }]);
    }
    const moved = await lampPlace(page);
    expect(moved.elevation).toBeGreaterThan(before.place.elevation + 4);
    expect(moved.distance).toBe(before.place.distance);

    const centre = await middleOf(page, '#viewport');
    await touch('touchStart', [to, { x: centre.x, y: centre.y + 100 }]);
    await touch('touchMove', [to, { x: centre.x, y: centre.y + 125 }]);
    await touch('touchMove', [to, { x: centre.x, y: centre.y + 150 }]);
    await touch('touchEnd', []);
    await ready(page);
    expect((await lampPlace(page)).distance / before.place.distance).toBeCloseTo(1.5, 1);
    const picture = await readDrawing(page);
    expect(angleBetween(strokeDirection(picture, FACE), strokeDirection(before.picture, FACE))).toBeGreaterThan(8);
  });
});

test('a light that stays with the viewer is dragged where the pointer goes, and lights the side that is seen', {
  tag: '@all',
}, async ({ page }) => {
  const seenFrom = (camera: string) =>
    `model=sphere&mapSize=64&mapTones=4&camera=${camera},0,0,0&lightAzimuth=-90&lightElevation=0&outlines=off`;
  const left = async () => {
    const picture = await readDrawing(page);
    return meanInk(picture, LEFT_HALF) - meanInk(picture, RIGHT_HALF);
  };
  // From behind, a light that stays with the model comes from the other side.
  await openPlayground(page, seenFrom('0,0,-6'));
  expect(await left()).toBeGreaterThan(0.1);
  await openPlayground(page, `${seenFrom('0,0,-6')}&lightFollows=viewer`);
  expect(await left()).toBeLessThan(-0.1);

  const middle = await middleOf(page, '#lamp');
  await dragLamp(page, { x: 30, y: -50 });
  const moved = await middleOf(page, '#lamp');
  expect(Math.abs(moved.x - middle.x - 30)).toBeLessThan(3);
  expect(Math.abs(moved.y - middle.y + 50)).toBeLessThan(3);
});

test('a model moves aside for its shadow, and returns to the middle without one', { tag: '@all' }, async ({ page }) => {
  await page.setViewportSize({ width: 840, height: 480 });
  const look = 'technique=engraving&outlines=off&model=knot&ground=shadow&lightAzimuth=-70&lightElevation=18';
  await openPlayground(page, look);
  const alone = await readDrawing(page);
  await openPlayground(page, `${look}&shadows=on`);
  const aside = await readDrawing(page);
  await page.getByRole('button', { name: 'Light', exact: true }).press('Enter');
  const shadows = page.getByRole('combobox', { name: 'Shadows' });
  await shadows.selectOption('None');
  expect(changedShare(alone, await readDrawing(page))).toBe(0);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(changedShare(aside, await readDrawing(page))).toBe(0);
  await page.getByRole('button', { name: 'Redo' }).click();
  expect(changedShare(alone, await readDrawing(page))).toBe(0);
});

test('a light that illustrators use is one press, and one undo', { tag: '@all' }, async ({ page }) => {
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, 'model=sphere&mapSize=64&mapTones=4&lightAzimuth=60&lightElevation=5&outlines=off');
  const before = await readDrawing(page);
  await page.getByRole('button', { name: 'Light', exact: true }).press('Enter');
  await page.getByRole('button', { name: 'From below' }).press('Enter');
  const after = await readDrawing(page);
  expect(changedShare(before, after)).toBeGreaterThan(0.05);
  expect((await lampPlace(page)).elevation).toBeLessThan(-20);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await lampPlace(page)).elevation).toBeCloseTo(5, 0);
});

test('hollows become darker when asked for, by the light of the page', { tag: '@all' }, async ({ page }) => {
  const view = 'model=teapot&mapSize=64&mapTones=4&outlines=off&debugView=tone&lightAzimuth=30&lightElevation=60';
  await openPlayground(page, view);
  const open = await readDrawing(page);
  await openPlayground(page, `${view}&occlusion=100`);
  const hollow = await readDrawing(page);
  expect(changedShare(open, hollow)).toBeGreaterThan(0.01);
  const [before, after] = [open, hollow].map((picture) => meanInk(picture, { left: 0, top: 0, right: 1, bottom: 1 }));
  expect(after).toBeGreaterThan(before + 0.002);
});

test('a model that is opened is lit from the upper front, and Undo takes its light back', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(
    page,
    'model=cube&mapSize=64&mapTones=4&outlines=off&camera=0,0,5,0,0,0&lightAzimuth=170&lightElevation=-30',
  );
  await drop(page, [file('octahedron.obj', octahedronObj)]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.obj');
  await ready(page);
  const suiting = await lampPlace(page);
  expect(suiting.elevation).toBeGreaterThan(15);
  await expect(page.locator('#lamp')).toHaveAttribute('aria-valuetext', /in front of the model/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('#model-name')).not.toHaveText('octahedron.obj');
  await ready(page);
  expect(await lampPlace(page)).toMatchObject({ azimuth: 170, elevation: -30 });
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(page.locator('#model-name')).toHaveText('octahedron.obj');
  await ready(page);
  expect(await lampPlace(page)).toEqual(suiting);
});

test('a room of one-sided walls that is seen through from outside is lit inside', async ({ page }) => {
  const builder = new GltfBuilder();
  const corners = Float32Array.from(BOX_CORNERS.flat());
  const inward = BOX_FACES.flatMap(([a, b, c, d]) => [a, c, b, a, d, c]);
  builder.json.meshes[0].primitives[0] = {
    attributes: { POSITION: builder.accessor(corners, 'VEC3') },
    indices: builder.accessor(Uint16Array.from(inward), 'SCALAR'),
  };
  const room = file('room.glb', Buffer.from(builder.glb()));
  const inks: number[] = [];
  for (const shadows of ['on', 'off']) {
    await openPlayground(page, `exposure=fixed&technique=hatching&occlusion=0&ground=none&shadows=${shadows}`);
    await drop(page, [room]);
    await ready(page);
    inks.push(meanInk(await readDrawing(page), { left: 0.42, top: 0.36, right: 0.58, bottom: 0.64 }));
  }
  expect(inks[0]).toBeLessThan(inks[1] + 0.05);
});
