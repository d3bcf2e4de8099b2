import { Color, Vector2, Vector4 } from 'three';
import { expect, test } from 'vitest';
import { fitTones, WeightedValues } from '../../../../src/material/exposure/ExposureFit.js';
import { writeFit } from '../../../../src/material/exposure/writeFit.js';

/** A hundred values, evenly spread over a range. */
function spread(from: number, to: number): WeightedValues {
  const values = new WeightedValues();
  for (let i = 0; i < 100; i++) values.add(from + ((to - from) * i) / 99, 1);
  return values;
}

const NONE = new WeightedValues();

test('light with the wanted contrast is scaled, without an offset', () => {
  const { scale, offset, white } = fitTones(spread(0, 2), spread(0, 1), NONE);
  expect(scale).toBeCloseTo(0.5, 2);
  expect([offset, white]).toEqual([0, 1]);
});

test('a surface without dark parts gets them, with its bright parts kept, at a contrast of at most four', () => {
  const half = fitTones(spread(1, 2), spread(0, 1), NONE);
  // From [1.1, 1.9] to [0.1, 0.9].
  expect(half.scale).toBeCloseTo(1, 2);
  expect(half.offset).toBeCloseTo(-1, 2);
  const faint = fitTones(spread(1.99, 2), spread(0, 1), NONE);
  expect(faint.scale).toBeCloseTo((4 * 0.9) / 2, 2);
  expect(2 * faint.scale + faint.offset).toBeCloseTo(0.9, 1);
});

test('darks are not lifted: of more contrast than asked, only the brights are fitted', () => {
  const { scale, offset } = fitTones(spread(0, 1), spread(0.5, 1), NONE);
  expect(scale).toBeCloseTo(0.95 / 0.9, 2);
  expect(offset).toBe(0);
});

test('the lightest colours are white, but not those that are nearly black', () => {
  const whiteOf = (from: number, to: number) => fitTones(spread(0, 1), spread(0, 1), spread(from, to)).white;
  expect(whiteOf(0, 0.6)).toBeCloseTo(0.54, 2);
  expect(whiteOf(0, 0.1)).toBe(0.3);
  expect(whiteOf(2, 3)).toBe(1);
});

test('without light nothing is fitted but the colours', () => {
  const dark = new WeightedValues();
  dark.add(0, 1);
  expect(fitTones(dark, spread(0, 1), NONE)).toEqual({ scale: 1, offset: 0, white: 1 });
  expect(fitTones(NONE, spread(0, 1), spread(0, 0.6)).white).toBeCloseTo(0.54, 2);
});

const PAINT = { name: '', color: new Color(), map: null, vertexColors: false };

test('a material takes a fit with its compensation, colours divided by what is white, and a share of the plan of values', () => {
  const uniforms = {
    exposure: { value: new Vector2() },
    colorExposure: { value: 1 },
    colorFilter: { value: new Vector4() },
    openOcclusion: { value: 0 },
    valueKnots: { value: new Vector4() },
    valueBends: { value: new Vector4() },
  };
  const plan = { filter: [1, 0, 0], knots: [0.8, 0.5, 0.2, 0], bends: [1, 2, -3, 0], tones: null } as const;
  const composition = { exposureCompensation: 1.5, plannedValues: 0.5 };
  writeFit({ scale: 2, offset: -0.5, white: 0.4, openOcclusion: 0.6, plan }, { ...PAINT, composition }, uniforms);
  expect([...uniforms.exposure.value, uniforms.colorExposure.value]).toEqual([3, -0.75, 2.5]);
  expect(uniforms.openOcclusion.value).toBe(0.6);
  expect(uniforms.valueKnots.value.toArray()).toEqual(plan.knots);
  expect(uniforms.valueBends.value.toArray()).toEqual(plan.bends);
  const [red, green, blue, share] = uniforms.colorFilter.value.toArray();
  expect(red).toBeCloseTo(0.606, 3);
  expect(red + green + blue).toBeCloseTo(1, 6);
  expect(share).toBe(0.5);
});
