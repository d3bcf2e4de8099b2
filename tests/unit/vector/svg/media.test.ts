import { TorusGeometry } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** Side of the sheet, millimetres, which the plane fills; and a box away from the ends of lines. */
const SIDE = 80;
const BOX = [5, 5, 70, 70] as const;
const PIXEL = 25.4 / 96;

/** The longer side of the bounding box of a path. */
function extentOf(data: string): number {
  const points = ringsOf(data).flat();
  const sides = [0, 1].map((axis) => points.filter((_, i) => i % 2 === axis));
  return Math.max(...sides.map((side) => Math.max(...side) - Math.min(...side)));
}

describe('a pen', () => {
  const draw = async (tone: number, kind: 'print' | 'pen' = 'print', irregularity = 0.6) => {
    const mesh = await planeOfTone(tone, {
      technique: 'pen',
      strokeLength: 60,
      lineSpacing: 5,
      crossFrom: 1,
      irregularity,
    });
    return drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { kind, sheet: [SIDE, SIDE], margin: 0 });
  };

  test.each(cases([0.5], [0.1, 0.5, 0.8]))('prints tone %s in strokes', { tags: ['more'] }, async (tone) => {
    const { svg, leftOut } = await draw(tone);
    expect(leftOut).toEqual([]);
    // On so small a sheet strokes are few, and in the darks they overlap.
    expect(Math.abs(coverageOf(pathsOf(svg), BOX) - tone)).toBeLessThan(0.035);
  });

  test.each(cases([0.15], [0.15, 0.5]))('plots tone %s in strokes of one width', { tags: ['more'] }, async (tone) => {
    const { drawn } = await draw(tone, 'pen');
    expect(Math.abs((drawn * 0.3) / SIDE ** 2 - tone)).toBeLessThan(0.03);
  });

  test('begins and ends strokes on its lines', { tags: ['all'] }, async () => {
    const lengths = pathsOf((await draw(0.25)).svg, 'lines').map(extentOf);
    lengths.sort((a, b) => a - b);
    const pixels = (share: number) => lengths[Math.floor(share * lengths.length)] / PIXEL;
    // Strokes are 60 pixels long, give or take half an octave; where two meet they form one path.
    expect(lengths.length).toBeGreaterThan(60);
    expect(pixels(0.5)).toBeGreaterThan(25);
    expect(pixels(0.5)).toBeLessThan(85);
    expect(pixels(0.9)).toBeLessThan(170);
  });

  test('strays from its lines by hand, and not with a ruler', async () => {
    /** The agreement of strokes on a direction: 1 if all are parallel. */
    const agreement = async (irregularity: number) => {
      const { svg } = await draw(0.3, 'pen', irregularity);
      const paths = pathsOf(svg, 'lines').map((data) => {
        const [points] = ringsOf(data);
        const last = points.length - 2;
        return 2 * Math.atan2(points[last + 1] - points[1], points[last] - points[0]);
      });
      const mean = (of: (angle: number) => number) => paths.reduce((sum, angle) => sum + of(angle), 0) / paths.length;
      return Math.hypot(mean(Math.cos), mean(Math.sin));
    };
    expect(await agreement(0)).toBeGreaterThan(1 - 2e-5);
    expect(await agreement(1)).toBeLessThan(1 - 1e-4);
  });
});

describe('a woodcut', () => {
  const draw = async (tone: number, kind: 'print' | 'pen' = 'print', side = SIDE) => {
    const mesh = await planeOfTone(tone, { technique: 'woodcut', strokeLength: 100, lineSpacing: 7 });
    return drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { kind, sheet: [side, side], margin: 0 });
  };

  test.each(cases([0.5], [0.1, 0.5, 0.9]))('tone %s is what is left between cuts', { tags: ['more'] }, async (tone) => {
    const { svg, leftOut } = await draw(tone);
    expect(leftOut).toEqual([]);
    expect(Math.abs(coverageOf(pathsOf(svg), BOX) - tone)).toBeLessThan(0.03);
  });

  test('is solid where nothing is cut', { tags: ['all'] }, async () => {
    expect(coverageOf(pathsOf((await draw(1)).svg), BOX)).toBeGreaterThan(0.999);
  });

  test('is filled by the strokes of a plotter', { tags: ['all'] }, async () => {
    const side = 80;
    // Rows are a pen's width apart, or up to twice as close.
    const { drawn: all } = await draw(1, 'pen', side);
    expect((all * 0.3) / side ** 2).toBeGreaterThan(1);
    expect((all * 0.3) / side ** 2).toBeLessThan(2);
    const { drawn } = await draw(0.5, 'pen', side);
    expect(drawn / all).toBeGreaterThan(0.45);
    expect(drawn / all).toBeLessThan(0.65);
  });
});

describe.each(['pen', 'woodcut'] as const)('a ring drawn with %s', (technique) => {
  const draw = async (leastWidth: number): Promise<string[]> => {
    const mesh = await hatchedMesh(new TorusGeometry(0.6, 0.3, 32, 64), { outlines: false, material: { technique } });
    const options = { sheet: [105, 105], margin: 0, leastWidth } as const;
    return pathsOf((await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), options)).svg);
  };
  let paths: string[];

  beforeAll(async () => {
    paths = await draw(0.05);
  });

  test('stays within the surface', () => {
    // At 50 mm per unit: inside a circle of 45 mm, and outside one of 15.
    const away = paths.flatMap((data) =>
      ringsOf(data).flatMap((ring) =>
        ring.flatMap((x, i) => (i % 2 === 0 ? [Math.hypot(x - 52.5, ring[i + 1] - 52.5)] : [])),
      ),
    );
    expect(away.length).toBeGreaterThan(3000);
    const beyond = away.filter((distance) => distance > 45.3 || distance < 14.7).length;
    expect(beyond / away.length).toBeLessThan(0.01);
  });

  test('has its ink also where a press holds no thinner line', { tags: ['all'] }, async () => {
    const inkOf = (drawn: string[]): number => coverageOf(drawn, [5, 5, 100, 100]);
    const whole = inkOf(await draw(0));
    expect(whole).toBeGreaterThan(0.1);
    expect(Math.abs(inkOf(paths) / whole - 1)).toBeLessThan(0.03);
  });
});
