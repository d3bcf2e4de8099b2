import { describe, expect, test } from 'vitest';
import { type FittedToneCurve, fitToneCurve, type ToneCurvePoint } from '../../../src/material/fitToneCurve.js';

/** The sum that the shader computes. */
function valueAt({ start, spans, cubics }: FittedToneCurve, tone: number): number {
  let value = start;
  for (let i = 0; i < spans.length / 2; i++) {
    const t = Math.min(1, Math.max(0, (tone - spans[2 * i]) * spans[2 * i + 1]));
    value += t * (cubics[3 * i] + t * (cubics[3 * i + 1] + t * cubics[3 * i + 2]));
  }
  return value;
}

const engraver: ToneCurvePoint[] = [
  [0, 0],
  [0.2, 0.05],
  [0.3, 0.7],
  [0.6, 0.72],
  [0.8, 0.5],
  [1, 1],
];

describe('fitToneCurve', () => {
  test('meets every point, and is constant before the first and after the last', () => {
    const curve = fitToneCurve([
      [0.2, 0.6],
      [0.5, 0.1],
      [0.7, 0.9],
    ]);
    for (const [tone, value] of [
      [0, 0.6],
      [0.2, 0.6],
      [0.5, 0.1],
      [0.7, 0.9],
      [1, 0.9],
    ] as const) {
      expect(valueAt(curve, tone)).toBeCloseTo(value, 6);
    }
  });

  test('never leaves the range between two neighbouring points', () => {
    const curve = fitToneCurve(engraver);
    for (let i = 0; i + 1 < engraver.length; i++) {
      const [[x0, y0], [x1, y1]] = [engraver[i], engraver[i + 1]];
      let before = y0;
      for (let step = 1; step <= 50; step++) {
        const y = valueAt(curve, x0 + ((x1 - x0) * step) / 50);
        expect((y - before) * Math.sign(y1 - y0), `span ${i}, step ${step}`).toBeGreaterThanOrEqual(-1e-6);
        before = y;
      }
    }
  });

  test('has no corner at its points', () => {
    const curve = fitToneCurve(engraver);
    for (const [tone] of engraver.slice(1, -1)) {
      const slope = (from: number) => (valueAt(curve, from + 1e-3) - valueAt(curve, from)) / 1e-3;
      expect(slope(tone)).toBeCloseTo(slope(tone - 1e-3), 0);
    }
  });

  test('two points give a straight line', () => {
    const curve = fitToneCurve([
      [0.1, 0.2],
      [0.9, 0.6],
    ]);
    for (const share of [0, 0.25, 0.5, 0.8])
      expect(valueAt(curve, 0.1 + 0.8 * share)).toBeCloseTo(0.2 + 0.4 * share, 6);
  });

  test('takes eight points', () => {
    const points = Array.from({ length: 8 }, (_, i): ToneCurvePoint => [i / 7, (i / 7) ** 2]);
    for (const [tone, value] of points) expect(valueAt(fitToneCurve(points), tone)).toBeCloseTo(value, 6);
  });

  test.each([
    ['one point', [[0, 0]], '1 points are not a curve'],
    ['nine points', Array.from({ length: 9 }, (_, i) => [i / 8, i / 8]), '9 points are not a curve'],
    ['no list', 'dark', `"dark" is neither 'linear' nor 'perceptual' nor 'printed' nor a list of points`],
    ['no pair', [[0, 0], [1]], 'point 1, [1], is not a pair of tones in [0, 1]'],
    [
      'a tone out of range',
      [
        [0, 0],
        [1, 1.2],
      ],
      'point 1, [1,1.2], is not a pair',
    ],
    [
      'NaN',
      [
        [0, Number.NaN],
        [1, 1],
      ],
      'point 0, [0,null], is not a pair',
    ],
    [
      'lights that do not rise',
      [
        [0.5, 0],
        [0.5, 1],
      ],
      'point 1 is not at a darker light',
    ],
  ])('refuses %s, and says what to give', (_name, points, message) => {
    const fit = () => fitToneCurve(points as unknown as ToneCurvePoint[]);
    expect(fit).toThrow(`HatchingMaterial.toneCurve: ${message}`);
    expect(fit).toThrow('give 2 to 8 pairs [light, printed].');
  });
});
