import { BoxGeometry, OrthographicCamera } from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingBackground, type HatchingBackgroundParameters } from '../../../../src/material/HatchingBackground.js';
import { lineWidth } from '../../../../src/vector/shading/background.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { hatchedMesh, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** A box in the middle of a picture of 100 mm, a fifth of it wide, lit from the left. */
async function draw(parameters: HatchingBackgroundParameters, kind: 'print' | 'pen' = 'print', sunX = -1) {
  const box = await hatchedMesh(new BoxGeometry(1, 1, 1), {
    outlines: false,
    material: {
      toneCurve: [
        [0, 0],
        [1, 0],
      ],
      hollowStrength: 0,
    },
  });
  const scene = sceneOf(box);
  scene.children[0].position.set(sunX, 0, 0);
  scene.add(new HatchingBackground(box, { extent: 3, ...parameters }));
  const camera = new OrthographicCamera(-2.5, 2.5, 2.5, -2.5, 0.1, 20);
  camera.position.z = 5;
  return drawSVG(scene, camera, { kind, sheet: [100, 100], margin: 0 });
}

describe('the field behind a subject', () => {
  test('lies in a layer of its own, ruled at its angle, and is hidden by the subject', async () => {
    const { svg, leftOut } = await draw({ direction: Math.PI / 6 }, 'pen');
    expect(leftOut).toEqual([]);
    const lines = pathsOf(svg, 'background').map((data) => ringsOf(data)[0]);
    expect(lines.length).toBeGreaterThan(20);
    for (const points of lines) {
      const [x0, y0] = points;
      const [x1, y1] = points.slice(-2);
      // Picture coordinates run down.
      const angle = Math.atan2(y0 - y1, x1 - x0);
      expect(Math.abs(Math.sin(angle - Math.PI / 6))).toBeLessThan(0.02);
    }
    expect(coverageOf(pathsOf((await draw({})).svg), [40.5, 40.5, 19, 19])).toBeLessThan(1e-9);
  });

  test('covers its share of the paper, and is darker behind the lit side', async () => {
    const [left, right] = [[32, 44, 7, 12] as const, [61, 44, 7, 12] as const];
    const even = pathsOf((await draw({ extent: 8, contrast: 0, tone: 0.3 })).svg, 'background');
    expect(Math.abs(coverageOf(even, left) - 0.3)).toBeLessThan(0.03);
    expect(Math.abs(coverageOf(even, right) - 0.3)).toBeLessThan(0.03);
    const lit = pathsOf((await draw({ extent: 8, tone: 0.3 })).svg, 'background');
    expect(coverageOf(lit, left)).toBeGreaterThan(0.45);
    expect(coverageOf(lit, right)).toBeLessThan(0.15);
    const otherwise = pathsOf((await draw({ extent: 8, tone: 0.3 }, 'print', 1)).svg, 'background');
    expect(coverageOf(otherwise, right)).toBeGreaterThan(0.45);
  });
});

test('a line thins out to its end, earlier at one end than at the other', () => {
  const field = {
    ...{ tone: 0.5, contrast: 0, spacing: 6, extent: 1 },
    direction: [1, 0] as const,
    sheet: [4000, 4000] as const,
    centre: [2000, 2000] as const,
    half: [500, 500] as const,
    lit: [0, 0] as const,
  };
  const widthAt = (line: number, along: number) => lineWidth(field, line, [2000 + along, 2000 + 6 * (line + 0.5)]);
  expect(widthAt(0, 0)).toBeCloseTo(3, 9);
  const ends = [0, 1, 2, 3, 4, 5].flatMap((line) =>
    [-1, 1].map((side) => {
      let along = 0;
      while (widthAt(line, side * along) > 0) along += 1;
      return along;
    }),
  );
  expect(new Set(ends).size).toBeGreaterThan(8);
  // 1 ∓ 0.2 of the extent.
  expect(Math.min(...ends)).toBeGreaterThanOrEqual(399);
  expect(Math.max(...ends)).toBeLessThanOrEqual(601);
});
