import type { Camera } from 'three';
import { describe, expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** The middle of a sheet of 100 mm, away from the ends of lines. */
const BOX = [10, 10, 80, 80] as const;

describe('tone 1 is solid', () => {
  const looks = [
    [0, 1],
    [0.5, 1],
    [1, 1],
    [0.5, 0.3],
  ] as const;

  test.each(cases(looks.slice(3), looks.slice()))(
    'irregularity %s, crossed from %s',
    { tags: ['more'] },
    async (irregularity, crossFrom) => {
      const mesh = await planeOfTone(1, { irregularity, crossFrom });
      const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0.2, 0.3, 1), { sheet: [100, 100] });
      expect(coverageOf(pathsOf(svg), [20, 20, 60, 60], 300)).toBeGreaterThan(0.9999);
    },
  );

  test('and the tones before it are what they were', { tags: ['all'] }, async () => {
    for (const tone of [0.9, 0.95]) {
      const mesh = await planeOfTone(tone, { irregularity: 0.4 });
      const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { sheet: [100, 100], margin: 0 });
      expect(Math.abs(coverageOf(pathsOf(svg), BOX) - tone)).toBeLessThan(0.015);
    }
  });
});

describe('lines that are thinner than a press holds', { tags: ['all'] }, () => {
  const draw = async (tone: number, leastWidth?: number, camera: Camera = cameraAt(0, 0, 1, true)) => {
    const mesh = await planeOfTone(tone, { direction: 'y' });
    return pathsOf((await drawSVG(sceneOf(mesh), camera, { sheet: [105, 105], margin: 0, leastWidth })).svg);
  };
  /** The left end, length and height of lines that run to the right. */
  const sizesOf = (paths: readonly string[]) =>
    paths.map((data) => {
      const [points] = ringsOf(data);
      const [xs, ys] = [points.filter((_, i) => i % 2 === 0), points.filter((_, i) => i % 2 === 1)];
      return {
        left: Math.min(...xs),
        top: Math.min(...ys),
        length: Math.max(...xs) - Math.min(...xs),
        width: Math.max(...ys) - Math.min(...ys),
      };
    });

  test.each(cases([0.035], [0.025, 0.035]))(
    'are dashes of the least width that keep the tone %s',
    { tags: ['more'] },
    async (tone) => {
      const plain = await draw(tone, 0);
      expect(Math.max(...sizesOf(plain).map(({ width }) => width))).toBeLessThan(0.1);
      const dashes = await draw(tone, 0.12);
      for (const { width } of sizesOf(dashes)) expect(Math.abs(width - 0.12)).toBeLessThan(0.011);
      expect(dashes.length).toBeGreaterThan(10 * plain.length);
      expect(Math.abs(coverageOf(dashes, [10, 10, 85, 85], 1000) - tone)).toBeLessThan(0.0015);
    },
  );

  test('end where a dash would be a dot, and are lines where they are as wide', async () => {
    expect(await draw(0.004, 0.12)).toEqual([]);
    expect((await draw(0.2, 0.12)).length).toBe((await draw(0.2, 0)).length);
  });

  test('stay where they are as the camera moves', async () => {
    const one = sizesOf(await draw(0.02, 0.12));
    const moved = cameraAt(0, 0, 1, true);
    moved.position.x += 0.1;
    // A shift by a hundredth of the picture is half a millimetre.
    const other = sizesOf(await draw(0.02, 0.12, moved)).map((dash) => ({ ...dash, left: dash.left + 5 }));
    const inner = one.filter(({ left, length }) => left > 10 && left + length < 95);
    expect(inner.length).toBeGreaterThan(100);
    for (const dash of inner) {
      const same = other.some(
        ({ left, top, length }) =>
          Math.abs(left - dash.left) + Math.abs(top - dash.top) + Math.abs(length - dash.length) < 0.06,
      );
      expect(same).toBe(true);
    }
  });
});
