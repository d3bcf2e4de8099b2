import { describe, expect, test } from 'vitest';
import { lightness } from '../../../../src/look/vectors.js';
import { planValues } from '../../../../src/material/exposure/planValues.js';
import { WeightedColors } from '../../../../src/material/exposure/WeightedColors.js';

type Rgb = readonly [number, number, number];

/** The luminance of a lightness. */
const luminanceOf = (light: number): number => (light <= 0.08 ? light / 9.032963 : ((light + 0.16) / 1.16) ** 3);
const grey = (light: number): Rgb => [luminanceOf(light), luminanceOf(light), luminanceOf(light)];

/** The share of a look's `colorHatching` that presets have. */
const OF_PRESETS = 0.8;

/** The tone in full light of each of some colours of a scene, by their shares of the surface. */
function tonesOf(scene: readonly (readonly [color: Rgb, share: number])[], asked = scene): number[] {
  const colors = new WeightedColors();
  for (const [color, share] of scene) colors.add(color, share);
  const { filter, knots, bends } = planValues(colors.means);
  return asked.map(([color]) => {
    const light = lightness(filter[0] * color[0] + filter[1] * color[1] + filter[2] * color[2]);
    return OF_PRESETS * knots.reduce((sum, knot, i) => sum + bends[i] * Math.max(knot - light, 0), 0);
  });
}

describe('a plan of values', () => {
  test('leaves a model of one colour blank, whichever it is, and one that is nearly black in a light grey', () => {
    for (const light of [1, 0.7, 0.5, 0.35]) expect(tonesOf([[grey(light), 1]])).toEqual([0]);
    const [black] = tonesOf([[grey(0.02), 1]]);
    expect(black).toBeGreaterThan(0.15);
    expect(black).toBeLessThan(0.25);
  });

  test('leaves the lighter half blank in a scene that is dark all over, as in a light one', () => {
    for (const darker of [0, 0.4]) {
      const tones = tonesOf([
        [grey(0.95 - darker), 0.45],
        [grey(0.7 - darker), 0.25],
        [grey(0.5 - darker), 0.2],
        [grey(0.3 - darker), 0.1],
      ]);
      expect(tones[0]).toBe(0);
      // Four bends of the curve leave a step a tenth short.
      for (let i = 1; i < tones.length; i++) expect(tones[i] - tones[i - 1]).toBeGreaterThan(0.108);
      expect(tones[3]).toBeGreaterThan(0.4);
      expect(tones[3]).toBeLessThanOrEqual(0.56 + 1e-9);
    }
  });

  test('draws a fox of orange, white and dark brown with blank white, light orange and dark legs', () => {
    const [white, orange, brown] = tonesOf([
      [grey(0.95), 0.2],
      [[0.6, 0.2, 0.04], 0.65],
      [[0.04, 0.02, 0.015], 0.15],
    ]);
    expect(white).toBe(0);
    expect(orange).toBeGreaterThanOrEqual(0.12 - 1e-9);
    expect(orange).toBeLessThan(0.2);
    expect(brown).toBeGreaterThan(0.35);
  });

  test('leaves a large dark mass to the paper where lighter ones have less than half of the surface', () => {
    const [walls, roofs, asphalt, windows] = tonesOf([
      [grey(0.7), 0.2],
      [grey(0.55), 0.2],
      [grey(0.2), 0.5],
      [grey(0.05), 0.1],
    ]);
    expect(walls).toBe(0);
    expect(roofs).toBeGreaterThan(0.03);
    expect(asphalt).toBeCloseTo(0.12, 9);
    expect(windows).toBeGreaterThan(0.4);
  });

  test('leaves nearly all blank that is darker than a small light part alone, and rises with its share', () => {
    const tones = [0.02, 0.1, 0.15, 0.2, 0.3].map((share) => {
      const [, tone] = tonesOf([
        [grey(0.95), share],
        [grey(0.6), 1 - share],
      ]);
      return tone;
    });
    expect(tones[0]).toBeLessThan(0.02);
    for (let i = 1; i < 4; i++) expect(tones[i]).toBeGreaterThan(tones[i - 1] + 0.02);
    expect(tones[3]).toBeCloseTo(0.12, 9);
    expect(tones[4]).toBeCloseTo(0.12, 9);
  });

  test('has tones for darker colours that come after it was made', () => {
    for (const planned of [1, 0.6]) {
      const later = [0.45, 0.25, 0.05].map((light): readonly [Rgb, number] => [grey(light), 1]);
      const tones = tonesOf([[grey(planned), 1]], later);
      expect(tones[0]).toBeGreaterThan(0.1);
      for (let i = 1; i < tones.length; i++) expect(tones[i] - tones[i - 1]).toBeGreaterThan(0.1);
      expect(tones[2]).toBeLessThanOrEqual(0.56 + 1e-9);
    }
  });

  test('does not make a coarse difference of a faint one', () => {
    const [light, dark] = tonesOf([
      [grey(0.95), 0.5],
      [grey(0.89), 0.5],
    ]);
    expect(dark - light).toBeLessThan(0.1);
    expect(dark - light).toBeGreaterThan(0.04);
  });

  test('keeps the spot that is darkest darkest', () => {
    const [, , coat, eyes] = tonesOf([
      [grey(1), 0.5],
      [grey(0.8), 0.2],
      [grey(0.3), 0.29],
      [grey(0.05), 0.01],
    ]);
    expect(eyes).toBeGreaterThanOrEqual(coat);
  });

  test('tells stripes of another hue and the same lightness apart', () => {
    // Light grey, blue and green of a luminance of 0.5.
    const tones = tonesOf([
      [[0.5, 0.5, 0.5], 0.5],
      [[0.25, 0.5315, 0.925], 0.25],
      [[0.2, 0.62, 0.195], 0.25],
    ]);
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < i; j++) expect(Math.abs(tones[i] - tones[j])).toBeGreaterThanOrEqual(0.12 - 1e-9);
    // The colour that most of them have is left blank.
    expect(tones[0]).toBe(0);
  });

  test('keeps the plain lightness where colours differ in it', () => {
    const colors = new WeightedColors();
    colors.add([0.8, 0.75, 0.7], 1);
    colors.add([0.3, 0.05, 0.02], 1);
    const [red, green, blue] = planValues(colors.means).filter;
    expect([red, green, blue]).toEqual([0.2126, 0.7152, 0.0722]);
  });

  test('leaves the light colours of a car of 45 blank, and makes only the darkest dark', () => {
    const tones = tonesOf(Array.from({ length: 45 }, (_, i) => [grey(1 - i / 50), 1 / 45] as const));
    for (let i = 1; i < tones.length; i++) expect(tones[i]).toBeGreaterThanOrEqual(tones[i - 1] - 1e-9);
    expect(tones.filter((tone) => tone < 0.09).length / 45).toBeGreaterThan(0.4);
    expect(tones.at(-1)).toBeCloseTo(0.56, 1);
  });

  test('is made anew only where its colours are others than before', () => {
    const colors = new WeightedColors();
    const found = [grey(0.5), grey(0.5), grey(0.4), grey(0.4)].map((color) => {
      colors.clear();
      colors.add(color, 2);
      return [colors.isUnchanged, colors.means.length];
    });
    expect(found).toEqual([
      [false, 1],
      [true, 1],
      [false, 1],
      [true, 1],
    ]);
  });

  test('of no colours is that of white, and colours that are no numbers are left out', () => {
    const colors = new WeightedColors();
    colors.add([Number.NaN, 0, 0], 1);
    colors.add([0, 0, 0], Number.POSITIVE_INFINITY);
    const white = new WeightedColors();
    white.add([1, 1, 1], 1);
    const [none, ofWhite] = [colors, white].map(({ means }) => planValues(means));
    for (const name of ['knots', 'bends'] as const)
      none[name].forEach((value, i) => {
        expect(value).toBeCloseTo(ofWhite[name][i], 6);
      });
  });
});
