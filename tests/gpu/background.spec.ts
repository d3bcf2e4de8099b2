import { type BackgroundField, lineAt, lineWidth, placeOnLine } from '../../src/vector/shading/background.js';
import { expect } from '../browser/test.js';
import { coverage } from './engravingDarkness.js';
import { expectEqualPictures, pictureError } from './pictureError.js';
import { test } from './toolkitPage.js';

/** The ink of a background on both sides of a ball, and in its middle where the ball hides it, under lights from both sides. */
test('a background is darker behind the lit side, lighter behind the dark one, and hidden by objects before it', async ({
  page,
}) => {
  const { sides, programs, calls } = await page.evaluate(async () => {
    const { THREE, HatchingBackground, makeRenderer, pixelsOf, sceneOf, sun, SIZE } = window.toolkit;
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.7), new THREE.MeshBasicMaterial({ color: 'white' }));
    const background = new HatchingBackground(ball, { spacing: 4, extent: 2 });
    const light = sun();
    const scene = sceneOf(ball, light, background);
    scene.background = new THREE.Color('white');
    const renderer = makeRenderer();
    // A frame before it has a subject.
    const { subject } = background;
    background.subject = null;
    pixelsOf(scene, renderer);
    background.subject = subject;
    const inkIn = (pixels: number[], from: number, to: number) => {
      let ink = 0;
      for (let y = SIZE / 3; y < (2 * SIZE) / 3; y++)
        for (let x = from; x < to; x++) ink += 1 - pixels[4 * (y * SIZE + x)] / 255;
      return ink;
    };
    const sides = [-3, 3].map((x) => {
      light.position.set(x, 0, 1);
      background.direction = x > 0 ? 0.4 : -0.9;
      const pixels = pixelsOf(scene, renderer);
      return { left: inkIn(pixels, 4, 20), middle: inkIn(pixels, 40, 56), right: inkIn(pixels, 76, 92) };
    });
    const { programs, render } = renderer.info;
    const { calls } = render;
    background.subject = null;
    pixelsOf(scene, renderer);
    return { sides, programs: programs!.length, calls: [calls, render.calls] };
  });
  const [fromLeft, fromRight] = sides;
  expect(fromLeft.left).toBeGreaterThan(2 * fromLeft.right);
  expect(fromRight.right).toBeGreaterThan(2 * fromRight.left);
  expect(fromLeft.right).toBeGreaterThan(1);
  expect(fromLeft.middle).toBe(0);
  expect(fromRight.middle).toBe(0);
  expect(programs).toBe(2);
  // A background without a subject draws nothing.
  expect(calls).toEqual([2, 1]);
});

test('a background has the tone that is asked for where nothing lights it, and ends before the rim', async ({
  page,
}) => {
  const { tones, rim } = await page.evaluate(async () => {
    const { THREE, HatchingBackground, makeRenderer, pixelsOf, sceneOf, SIZE } = window.toolkit;
    // The subject hides nothing there, and the field is as wide as the sheet.
    const subject = new THREE.Mesh(new THREE.PlaneGeometry(9, 9));
    subject.visible = false;
    const background = new HatchingBackground(subject, { spacing: 6, direction: 0.5, extent: 3 });
    const scene = sceneOf(background, subject);
    scene.background = new THREE.Color('white');
    const renderer = makeRenderer();
    let rim = 0;
    const tones = [0.1, 0.25, 0.5].map((tone) => {
      background.tone = tone;
      const pixels = pixelsOf(scene, renderer);
      let ink = 0;
      for (let p = 0; p < SIZE * SIZE; p++) {
        const [x, y] = [p % SIZE, Math.floor(p / SIZE)];
        const darkness = 1 - pixels[4 * p] / 255;
        if (Math.max(Math.abs(x - 48), Math.abs(y - 48)) < 12) ink += darkness / 23 ** 2;
        if (x === 0 || y === 0 || x === SIZE - 1 || y === SIZE - 1) rim += darkness;
      }
      return ink;
    });
    return { tones, rim };
  });
  for (const [i, tone] of [0.1, 0.25, 0.5].entries()) expect(Math.abs(tones[i] - tone)).toBeLessThan(0.03);
  expect(rim / (4 * 96 * 3)).toBeLessThan(0.01);
});

test('every pixel of a background is that of the lines of vector files', async ({ page }) => {
  const lamp = [3, 1, 1] as const;
  const { pixels, size, sheet, subject } = await page.evaluate(async ([x, y, z]) => {
    const { THREE, HatchingBackground, pixelsOf, sceneOf, sun, SIZE } = window.toolkit;
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.5));
    ball.position.x = 0.2;
    // It hides nothing.
    ball.visible = false;
    const background = new HatchingBackground(ball, {
      spacing: 6,
      direction: 0.5,
      extent: 2,
      tone: 0.4,
      contrast: 0.7,
    });
    background.ink.set('black');
    const scene = sceneOf(ball, background, sun(Math.PI, [x, y, z]));
    scene.background = new THREE.Color('white');
    const pixels = pixelsOf(scene);
    const { sheet, subject } = background.material.uniforms;
    return { pixels, size: SIZE, sheet: sheet.value.toArray(), subject: subject.value.toArray() };
  }, lamp);
  const away = Math.hypot(...lamp);
  const field: BackgroundField = {
    ...{ tone: 0.4, contrast: 0.7, spacing: 6, direction: [Math.cos(0.5), Math.sin(0.5)], extent: 2 },
    ...{ sheet: [sheet[2], sheet[3]], centre: [subject[0], subject[1]], half: [subject[2], subject[3]] },
    lit: [lamp[0] / away, lamp[1] / away],
  };
  const expected = new Map<number, [number, number, number]>();
  for (let pixel = 0; pixel < size * size; pixel++) {
    const place = [(pixel % size) + 0.5, Math.floor(pixel / size) + 0.5] as const;
    const line = lineAt(field, place);
    const middle = placeOnLine(field, line, 0);
    const [dx, dy] = [place[0] - middle[0], place[1] - middle[1]];
    const half = 0.5 * lineWidth(field, line, place);
    const blank = 1 - coverage(Math.abs(dy * field.direction[0] - dx * field.direction[1]), half);
    expected.set(pixel, [blank, blank, blank]);
  }
  const inked = [...expected.values()].filter(([blank]) => blank < 0.9).length;
  expect(inked).toBeGreaterThan(1000);
  expectEqualPictures(pictureError(pixels, expected));
});
