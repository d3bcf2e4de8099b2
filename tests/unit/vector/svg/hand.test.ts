import { expect, test } from 'vitest';
import type { Hand } from '../../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../../../src/strokes/hands/exampleHabits.js';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, planeOfTone, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

const hand = learnHand(drawSwatches(exampleHabits.finePen, 1));

/** A square of even tone, 60 mm wide, that a hand hatches. */
async function drawn(chosen: Hand, tone: number, options: DrawSVGOptions = {}) {
  const mesh = await planeOfTone(tone);
  Object.assign(mesh.material, { technique: 'pen', direction: 'y', hand: chosen, screenSpaceShare: 1 });
  return drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), { sheet: [60, 60], margin: 0, ...options });
}

/** The extents of shapes along their rows. */
const lengthsOf = (svg: string): number[] =>
  pathsOf(svg)
    .flatMap(ringsOf)
    .map((ring) => {
      const xs = ring.filter((_, i) => i % 2 === 0);
      return Math.max(...xs) - Math.min(...xs);
    });

const median = (values: readonly number[]): number => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

test('each stroke of a hand is one path, as long as drawn, in print and by a pen', async () => {
  const print = await drawn(hand, 0.15);
  const pen = await drawn(hand, 0.15, { kind: 'pen', penWidth: 0.25 });
  // Six CSS pixels are a millimetre of the sheet on which the hand drew.
  const expected = (hand.numbers.length * 6 * 25.4) / 96;
  for (const { svg } of [print, pen]) expect(Math.abs(median(lengthsOf(svg)) / expected - 1)).toBeLessThan(0.3);
  expect(print.paths).toBeGreaterThan(25);
  expect(Math.abs(pen.paths / print.paths - 1)).toBeLessThan(0.1);
  expect(print.leftOut).toEqual([]);
});

test('the second layer of a hand crosses the first, to the side that it was drawn to', { tags: ['more'] }, async () => {
  const numbers = { ...hand.numbers, crossingFrom: 0.2, angleSpread: 0, curvature: 0, wobble: 0 };
  const steepOf = async (crossingAngle: number): Promise<number> => {
    const { svg } = await drawn({ ...hand, numbers: { ...numbers, crossingAngle } }, 0.6, {
      kind: 'pen',
      penWidth: 0.25,
    });
    const slopes = pathsOf(svg)
      .flatMap(ringsOf)
      .map((line) => Math.sign(line.at(-2)! - line[0]) * (line.at(-1)! - line[1]));
    return slopes.filter((slope) => Math.abs(slope) > 2).reduce((sum, slope) => sum + Math.sign(slope), 0);
  };
  const [one, other] = [await steepOf(50), await steepOf(-50)];
  expect(Math.abs(one)).toBeGreaterThan(8);
  expect(Math.abs(other)).toBeGreaterThan(8);
  expect(Math.sign(one)).toBe(-Math.sign(other));
});
