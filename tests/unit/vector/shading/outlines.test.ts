import { describe, expect, test } from 'vitest';
import { normalize, type Vec3 } from '../../../../src/look/vectors.js';
import { lineWeightAt, strideOf, suggestiveShare } from '../../../../src/vector/shading/outlines.js';

describe('the line weight of an outline', () => {
  test('is all paper, without accent, where only paper lies behind', () => {
    expect(lineWeightAt(1, () => 1)).toEqual({ paper: 1, accent: 0 });
    expect(lineWeightAt(0.1, () => 0.1)).toEqual({ paper: 0, accent: 0 });
  });

  test('its accent grows towards the place where the depth behind it jumps', () => {
    // The jump lies between two steps, farther and farther away: 7, 5, 3 and 1 eighths of the accent are left.
    for (const [i, left] of [7, 5, 3, 1].entries()) {
      const gapAt = (step: number) => (step > i ? 1 : 0.2);
      expect(lineWeightAt(0.2, gapAt).accent).toBeCloseTo(left / 8, 12);
    }
    expect(lineWeightAt(0.2, () => 0.2).accent).toBe(0);
  });

  test('a jump counts from a fiftieth of the height of the view, and in full from three', () => {
    const jump = (size: number) => lineWeightAt(0.2, (step) => 0.2 + (step > 0 ? size : 0)).accent;
    expect(jump(0.019)).toBe(0);
    expect(jump(0.04)).toBeCloseTo(0.5 * (7 / 8), 12);
    expect(jump(0.06)).toBeCloseTo(7 / 8, 12);
  });

  test('the search ends at the own surface, and at the rim of the picture', () => {
    expect(lineWeightAt(0.2, (step) => (step === 1 ? 0.01 : 1)).accent).toBeCloseTo(7 / 8, 12);
    expect(lineWeightAt(0.2, (step) => (Math.abs(step) === 1 ? 0.01 : 1)).accent).toBe(0);
    expect(lineWeightAt(0.2, () => undefined)).toEqual({ paper: 0, accent: 0 });
  });

  test('the weight changes gradually from paper to surface', () => {
    const papers = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map(
      (place) => lineWeightAt(place > 0 ? 1 : 0.1, (step) => (place + step > 0 ? 1 : 0.1)).paper,
    );
    expect(papers[0]).toBe(0);
    for (let i = 1; i < papers.length; i++) expect(papers[i]).toBeGreaterThanOrEqual(papers[i - 1]);
    expect(papers[8]).toBeGreaterThan(0.97);
  });

  test('the search reaches eight widths of an outline to either side', () => {
    expect(4 * strideOf(1.8)).toBeCloseTo(14.4, 12);
  });
});

describe('suggestive contours', () => {
  // A triangle that faces (0, 0, 1), with a curvature that grows along x.
  const normal: Vec3 = [0, 0, 1];
  const triangle = (growth: number) =>
    ([0, 1, 2] as const).map((k) => {
      const position: Vec3 = [0.1 * Number(k === 1), 0.1 * Number(k === 2), 0];
      return { position, normal, bend: growth * position[0] };
    }) as unknown as Parameters<typeof suggestiveShare>[0];

  test('begin where the curvature grows towards the eye, and have their full weight from three times that growth on', () => {
    const toEye: Vec3 = normalize([1, 0, 1]);
    expect(suggestiveShare(triangle(20), toEye, 1)).toBe(0);
    expect(suggestiveShare(triangle(40), toEye, 1)).toBeCloseTo(0.5, 9);
    expect(suggestiveShare(triangle(60), toEye, 1)).toBe(1);
    expect(suggestiveShare(triangle(20), toEye, 3)).toBe(1);
    expect(suggestiveShare(triangle(-60), toEye, 1)).toBe(0);
  });

  test('are absent face on, and where the curvature grows sideways', () => {
    expect(suggestiveShare(triangle(1000), [0, 0, 1], 1)).toBe(0);
    expect(suggestiveShare(triangle(1000), normalize([0, 1, 1]), 1)).toBe(0);
  });
});
