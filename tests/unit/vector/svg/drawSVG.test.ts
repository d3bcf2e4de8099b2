import { BoxGeometry, Mesh, MeshBasicMaterial, SphereGeometry, TorusGeometry } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { type DrawSVGOptions, drawSVG, type SVGDrawing } from '../../../../src/vector/svg/index.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** Outlines of one weight. */
const ALIKE = { weights: { innerContours: 1, creases: 1, lit: 1, shade: 1 }, lostEdges: 0 };
const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};

const SMALL = { sheet: [80, 80], margin: 0 } as const;

describe('outlines are joined', () => {
  test('a cube is nine paths', async () => {
    const mesh = await hatchedMesh(new BoxGeometry(1.2, 1.2, 1.2), { outlines: ALIKE, material: BLANK });
    const { svg, paths } = await drawSVG(sceneOf(mesh), cameraAt(2.2, 1.7, 2.9), SMALL);
    expect(paths).toBe(9);
    expect(pathsOf(svg, 'outlines').length).toBe(9);
  });

  test.each([
    ['print', false],
    ['pen', false],
    ['print', true],
  ] as const)('the contour of a sphere is one closed path (%s, orthographic: %s)', async (kind, isOrthographic) => {
    const mesh = await hatchedMesh(new SphereGeometry(1, 64, 48), { outlines: ALIKE, material: BLANK });
    const { svg, paths } = await drawSVG(sceneOf(mesh), cameraAt(0, 0.6, 3.6, isOrthographic), { ...SMALL, kind });
    expect(paths).toBe(1);
    const [data] = pathsOf(svg);
    expect(data.match(/z/g)?.length).toBe(kind === 'print' ? 2 : 1);
    const [points] = ringsOf(data);
    const [xs, ys] = [points.filter((_, i) => i % 2 === 0), points.filter((_, i) => i % 2 === 1)];
    const size = Math.max(...xs) - Math.min(...xs);
    // A circle that fills the camera's picture.
    expect(Math.abs(Math.max(...ys) - Math.min(...ys) - size)).toBeLessThan(0.3);
    expect(size).toBeGreaterThan(0.9 * 80);
  });

  test('the two contours of a torus are closed paths, and the hidden part of a third is none', async () => {
    const mesh = await hatchedMesh(new TorusGeometry(0.7, 0.3, 48, 96), { outlines: ALIKE, material: BLANK });
    const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 1, 2.8), { ...SMALL, kind: 'pen' });
    const closed = pathsOf(svg).filter((data) => data.endsWith('z'));
    expect(closed.length).toBe(2);
    expect(pathsOf(svg).length).toBe(2);
  });
});

describe('the tone is what is covered', () => {
  const side = 80;
  // The middle of the sheet, away from the ends of lines.
  const box = [8, 8, 64, 64] as const;
  // Dashes and order do not matter here, and take time.
  const QUICK = { sheet: [side, side], margin: 0, leastWidth: 0, order: 'drawn' } as const;

  test.each(cases([0.2, 0.7], [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]))(
    'tone %s of one family',
    { tags: ['more'] },
    async (tone) => {
      const { svg } = await drawSVG(sceneOf(await planeOfTone(tone)), cameraAt(0, 0, 1), QUICK);
      expect(Math.abs(coverageOf(pathsOf(svg), box) - tone)).toBeLessThan(0.01);
    },
  );

  test.each(cases([0.7], [0.5, 0.7, 0.9]))('tone %s of lines that cross', { tags: ['more'] }, async (tone) => {
    const mesh = await planeOfTone(tone, { crossFrom: 0.3 });
    const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), QUICK);
    expect(pathsOf(svg, 'crossing').length).toBeGreaterThan(20);
    expect(Math.abs(coverageOf(pathsOf(svg), box) - tone)).toBeLessThan(0.01);
  });

  test.each(cases([0.5], [0.2, 0.5, 0.8]))(
    'tone %s of a pen is the length of its lines times its width',
    { tags: ['more'] },
    async (tone) => {
      const mesh = await planeOfTone(tone);
      const { drawn } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), {
        ...QUICK,
        leastWidth: undefined,
        kind: 'pen',
        penWidth: 0.4,
      });
      expect(Math.abs((drawn * 0.4) / side ** 2 - tone)).toBeLessThan(0.02);
    },
  );
});

describe('the sheet', () => {
  test('has its true size, named layers, and no paper that a pen would draw', async () => {
    const mesh = await hatchedMesh(new SphereGeometry(1, 48, 32));
    const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { kind: 'pen', sheet: 'A5', penWidth: 0.5 });
    expect(svg).toMatch(/^<svg [^>]*width="148mm" height="210mm" viewBox="0 0 148 210">/);
    expect(svg).not.toContain('<rect');
    expect([...svg.matchAll(/inkscape:groupmode="layer" inkscape:label="([^"]*)"/g)].map(([, label]) => label)).toEqual(
      ['1 outlines', '2 lines', '3 crossing'],
    );
    expect(svg).toContain('stroke-width="0.5"');
  });

  test.each([
    ['print', 0],
    ['print', 12],
    ['pen', 0],
    ['pen', 12],
  ] as const)('holds all ink: %s, margin %s', async (kind, margin) => {
    // A body larger than the camera's picture, which clips it.
    const mesh = await hatchedMesh(new SphereGeometry(1.6, 32, 24), { material: { direction: 'y' } });
    const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0.3, 0.2, 1), {
      kind,
      margin,
      sheet: [100, 100],
      penWidth: kind === 'pen' ? 0.6 : undefined,
    });
    const least = kind === 'pen' ? Math.max(margin, 0.3) : margin;
    const numbers = pathsOf(svg).flatMap((data) => ringsOf(data).flat());
    expect(numbers.length).toBeGreaterThan(1000);
    expect(Math.min(...numbers)).toBeGreaterThanOrEqual(least - 0.011);
    expect(Math.max(...numbers)).toBeLessThanOrEqual(100 - least + 0.011);
  });

  test('has a layer for each ink', async () => {
    const red = await hatchedMesh(new SphereGeometry(0.5, 32, 24), { outlines: false, material: { ink: 'red' } });
    const blue = await hatchedMesh(new SphereGeometry(0.4, 32, 24), { outlines: false, material: { ink: 'blue' } });
    blue.position.x = 0.8;
    const { svg } = await drawSVG(sceneOf(red, blue), cameraAt(0, 0, 1), SMALL);
    expect(svg).toContain('lines #ff0000" fill="#ff0000"');
    expect(svg).toContain('lines #0000ff" fill="#0000ff"');
  });
});

describe('a torus', () => {
  const draw = async (options: DrawSVGOptions = {}) => {
    const mesh = await hatchedMesh(new TorusGeometry(0.7, 0.3, 24, 48));
    return drawSVG(sceneOf(mesh), cameraAt(0, 1, 2), { paper: '#f7f3e8', ...options });
  };
  let one: SVGDrawing;

  beforeAll(async () => {
    one = await draw();
  });

  test('gives the same bytes again, and pens travel less than unordered', { tags: ['all'] }, async () => {
    expect((await draw()).svg).toBe(one.svg);
    expect(one.travelAfter).toBeLessThan(0.2 * one.travelBefore);
    const unordered = await draw({ order: 'drawn' });
    expect(unordered.travelAfter).toBe(unordered.travelBefore);
    expect(unordered.paths).toBe(one.paths);
  });

  test('is a well-formed file', () => {
    const { svg } = one;
    const open: string[] = [];
    for (const [, slash, name, attributes, empty] of svg.matchAll(/<(\/?)(\w+)((?: [\w:-]+="[^"<>&]*")*)(\/?)>/g)) {
      if (slash) expect(open.pop()).toBe(name);
      else if (!empty) open.push(name);
      const names = [...attributes.matchAll(/ ([\w:-]+)=/g)].map(([, attribute]) => attribute);
      expect(new Set(names).size).toBe(names.length);
    }
    expect(open).toEqual([]);
    // There is no text between the tags.
    expect(svg.replace(/<[^<>]*>/g, '').trim()).toBe('');
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
  });
});

test('hard shadows darken what they fall on, and what receives none stays as it is', async () => {
  const ball = await hatchedMesh(new SphereGeometry(0.3, 48, 32), { outlines: false });
  const wall = await planeOfTone(0, { toneCurve: 'linear', composition: { exposure: 1 } });
  ball.position.set(0.3, 0.1, 0.6);
  const scene = sceneOf(wall, ball);
  const sun = scene.children[0];
  sun.castShadow = ball.castShadow = true;
  const sheet = [50, 50] as const;
  const inkOf = async () => (await drawSVG(scene, cameraAt(0, 0, 1), { kind: 'pen', sheet })).drawn;
  const without = await inkOf();
  wall.receiveShadow = true;
  const withShadow = await inkOf();
  expect(withShadow).toBeGreaterThan(without + 50);
  expect((await drawSVG(scene, cameraAt(0, 0, 1), { kind: 'pen', sheet, shadows: false })).drawn).toBe(without);
});

test('what cannot be drawn as lines is listed, and still hides what is behind it', async () => {
  const behind = await hatchedMesh(new SphereGeometry(0.6, 32, 24));
  const before = new Mesh(new BoxGeometry(3, 3, 0.1), new MeshBasicMaterial());
  before.name = 'door';
  before.position.z = 1;
  const stippled = await hatchedMesh(new SphereGeometry(0.1, 16, 12), { material: { technique: 'hatching' } });
  const { paths, leftOut } = await drawSVG(sceneOf(behind, before, stippled), cameraAt(0, 0, 1), SMALL);
  expect(paths).toBe(0);
  expect(leftOut.map(({ object, reason }) => [object === before || object === stippled, reason])).toEqual([
    [true, 'The Mesh "door" at Scene/door has no lines: its material is no HatchingMaterial.'],
    [true, "The Mesh at Scene/Mesh[3] has no lines: strokes of the technique 'hatching' are drawn from images."],
  ]);
});
