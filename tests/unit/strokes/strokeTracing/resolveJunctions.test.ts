import { describe, expect, test } from 'vitest';
import { resolveJunctions } from '../../../../src/strokes/strokeTracing/resolveJunctions.js';
import type { Branch, SkeletonGraph } from '../../../../src/strokes/strokeTracing/SkeletonGraph.js';

const RADIUS = 5;

/** Lines of pixels from one junction at (0, 0), each in a direction and so many pixels long, as they are thinned from strokes 10 pixels wide. */
const star = (...arms: readonly (readonly [x: number, y: number, length: number])[]): SkeletonGraph => ({
  nodes: [{ x: 0, y: 0, radius: RADIUS }],
  branches: arms.map(([x, y, length]): Branch => {
    const steps = Array.from({ length }, (_, i) => i + 1);
    return { points: steps.flatMap((step) => [x * step, y * step]), radii: steps.map(() => RADIUS), from: 0, to: -1 };
  }),
});

describe('a branch of a stroke', () => {
  test('is a spur where it is hardly longer than the stroke is wide to one side, and leaves no trace', () => {
    const chains = resolveJunctions(star([-1, 0, 50], [1, 0, 50], [0, 1, 8]));
    expect(chains).toHaveLength(1);
    expect(chains[0].points.filter((_, i) => i % 2 === 1).every((y) => y === 0)).toBe(true);
    expect([chains[0].startRadius, chains[0].endRadius]).toEqual([0, 0]);
  });

  test('is a stroke of its own where it is longer, and begins at the other', () => {
    const chains = resolveJunctions(star([-1, 0, 50], [1, 0, 50], [0, 1, 12]));
    expect(chains).toHaveLength(2);
    const aside = chains.find(({ points }) => points[1] !== 0)!;
    expect(aside.radii).toHaveLength(12);
    expect([aside.startRadius, aside.endRadius].sort()).toEqual([0, RADIUS]);
  });

  test('leaves the two longest branches where all are short', () => {
    const chains = resolveJunctions(star([-1, 0, 7], [1, 0, 8], [0, 1, 6]));
    expect(chains).toHaveLength(1);
    // Without what lies within the junction.
    expect(chains[0].points.filter((_, i) => i % 2 === 0).sort((a, b) => a - b)).toEqual([-7, -6, 6, 7, 8]);
  });
});
