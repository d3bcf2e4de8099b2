import { describe, expect, it } from 'vitest';
import { countPieces } from '../../../../tools/metrics/measures/countPieces.js';
import { edgeJump } from '../../../../tools/metrics/measures/edgeJump.js';
import { greyness } from '../../../../tools/metrics/measures/greyness.js';
import { meanInk } from '../../../../tools/metrics/measures/meanInk.js';
import { pieceLengths } from '../../../../tools/metrics/measures/pieceLengths.js';
import { strokeCoherence } from '../../../../tools/metrics/measures/strokeCoherence.js';
import { strokeLength } from '../../../../tools/metrics/measures/strokeLength.js';
import { halfSpread, strokeSpacing } from '../../../../tools/metrics/measures/strokeSpacing.js';
import { toneSpectrum } from '../../../../tools/metrics/measures/toneSpectrum.js';
import { noise, picture, stripes } from './images.js';

describe('greyness', () => {
  it('counts what is neither ink nor paper', () => {
    const row = [0, 0.1, 0.19, 0.21, 0.5, 0.79, 0.81, 1];
    expect(greyness(picture(8, 1, (x) => row[x]))).toBeCloseTo(3 / 8);
  });

  it('looks at the surface only', () => {
    expect(
      greyness(
        picture(
          4,
          1,
          () => 0.5,
          (x) => x === 0,
        ),
      ),
    ).toBe(1);
    expect(
      greyness(
        picture(
          4,
          1,
          (x) => (x === 0 ? 1 : 0.5),
          (x) => x === 0,
        ),
      ),
    ).toBe(0);
  });
});

describe('meanInk', () => {
  it('is the mean darkness of the surface', () => {
    expect(
      meanInk(
        picture(
          4,
          1,
          (x) => [0, 1, 0.5, 0][x],
          (x) => x < 3,
        ),
      ),
    ).toBeCloseTo(0.5);
  });
});

describe('edgeJump', () => {
  it('compares where both show an edge', () => {
    const own = picture(
      20,
      1,
      () => 0.25,
      (x) => x < 10,
    );
    const twin = picture(
      20,
      1,
      (x) => (x === 3 ? 1 : 0.25),
      (x) => x !== 0,
    );
    const jump = edgeJump(own, twin);
    expect(jump.samples).toBe(9);
    expect(jump.mean).toBeCloseTo(0.75 / 9);
    expect(jump.p95).toBe(0);
  });
});

describe('strokeSpacing', () => {
  it.each([
    [8, 0],
    [8, Math.PI / 2],
    [8, 0.3],
    [12, 0.8],
    [6.5, 2.2],
  ])('measures stripes %f px apart at an angle of %f', (spacing, angle) => {
    const measured = strokeSpacing(stripes(200, spacing, angle, 0.43));
    expect(Math.abs(measured / spacing - 1)).toBeLessThan(0.04);
  });

  it('leaves out windows that reach beyond the surface', () => {
    const image = stripes(200, 8, 0);
    const half = { ...image, surface: image.surface.map((s, i) => (i % 200 < 100 ? s : 0)) };
    // Beyond the surface lies what would halve the spacing.
    half.luminance.forEach((_, i) => {
      if (i % 200 >= 100) half.luminance[i] = i % 2;
    });
    expect(strokeSpacing(half)).toBeCloseTo(8, 0);
  });

  it('spreads by half the range', () => {
    expect(halfSpread([8.5, 10, 11.5])).toBeCloseTo(0.15);
  });
});

describe('strokeCoherence', () => {
  it('is 1 for straight strokes at any angle', () => {
    for (const angle of [0, 0.4, 1.2]) expect(strokeCoherence(stripes(120, 8, angle))).toBeGreaterThan(0.97);
  });

  it('is low for noise and for crossed strokes', () => {
    const random = noise(1);
    expect(strokeCoherence(picture(120, 120, () => (random() < 0.5 ? 0 : 1)))).toBeLessThan(0.3);
    const crossed = picture(120, 120, (x, y) => (x % 8 < 3 || y % 8 < 3 ? 0 : 1));
    expect(strokeCoherence(crossed)).toBeLessThan(0.1);
  });

  it('falls steadily as strokes are broken up', () => {
    const values = [0, 0.1, 0.3, 0.6].map((share) => {
      const random = noise(2);
      const image = stripes(120, 8, 0.4);
      return strokeCoherence({
        ...image,
        luminance: image.luminance.map((l) => (random() < share ? Math.round(random()) : l)),
      });
    });
    for (let i = 1; i < values.length; i++) expect(values[i]).toBeLessThan(values[i - 1] - 0.02);
  });

  it('does not take the outline of the model for a stroke', () => {
    const image = stripes(120, 8, 0);
    const surface = image.surface.map((_, i) => (i % 120 < 60 === Math.floor(i / 120) < 60 ? 255 : 0));
    const luminance = image.luminance.map((l, i) => (surface[i] ? l : 0));
    expect(strokeCoherence({ ...image, luminance, surface })).toBeGreaterThan(0.97);
  });
});

describe('strokeLength', () => {
  /** Strokes of a length along a direction, gaps as long between them, staggered. */
  const strokes = (length: number, angle: number) =>
    picture(240, 240, (x, y) => {
      const across = x * Math.cos(angle) + y * Math.sin(angle);
      const along = y * Math.cos(angle) - x * Math.sin(angle);
      const line = Math.floor(across / 9);
      const way = (along + 37 * line) / (2 * length);
      return across / 9 - line < 0.35 && way - Math.floor(way) < 0.5 ? 0 : 1;
    });

  it.each([0, 0.4, 1.2])('is the length of the strokes, at an angle of %d', (angle) => {
    for (const length of [20, 40]) expect(Math.abs(strokeLength(strokes(length, angle)) - length)).toBeLessThan(4);
  });

  it('leaves out strokes that run off the surface', () => {
    expect(strokeLength(stripes(120, 8, 0.4))).toBeNaN();
    const whole = strokes(30, 0.4);
    const surface = whole.surface.map((_, i) => (i % 240 > 120 ? 0 : 255));
    expect(Math.abs(strokeLength({ ...whole, surface }) - 30)).toBeLessThan(4);
  });
});

describe('countPieces', () => {
  it('counts dots on paper, and specks of paper between dots', () => {
    // A dot of two pixels by three in each square of ten.
    const dots = picture(100, 100, (x, y) => (x % 10 < 2 && y % 10 < 3 ? 0 : 1));
    expect(countPieces(dots)).toEqual({ ink: 100, inkArea: 6, paper: 1, paperArea: 9400 });
    const specks = { ...dots, luminance: dots.luminance.map((l) => 1 - l) };
    expect(countPieces(specks)).toEqual({ ink: 1, inkArea: 9400, paper: 100, paperArea: 6 });
  });

  it('joins at sides and not at corners', () => {
    expect(countPieces(picture(100, 100, (x, y) => (x + y) % 2)).ink).toBe(5000);
  });
});

describe('pieceLengths', () => {
  it('measures separate strokes along themselves, whichever way they run, down to their thin ends', () => {
    // Bars of 30 by 3, whose last 5 pixels cover little of the paper.
    const bars = picture(100, 100, (x, y) => (x < 20 || x >= 50 || y % 10 > 2 ? 1 : x < 45 ? 0 : 0.7));
    const lying = pieceLengths(bars);
    // The first lies at the rim.
    expect(lying).toHaveLength(9);
    for (const { length, area } of lying) expect([Math.round(length), area]).toEqual([30, 90]);
    const diagonal = pieceLengths(picture(100, 100, (x, y) => (x === y && x > 9 && x < 60 ? 0 : 1)));
    expect(diagonal).toHaveLength(1);
    expect(Math.abs(diagonal[0].length - 50 * Math.SQRT2)).toBeLessThan(1);
  });

  it('leaves out strokes that reach where the surface ends', () => {
    const whole = picture(100, 100, (_x, y) => (y % 10 > 2 ? 1 : 0));
    expect(pieceLengths(whole)).toEqual([]);
  });
});

describe('toneSpectrum', () => {
  it('finds a wave in the band of its wavelength, with its deviation', () => {
    for (const [band, wavelength] of [3, 6, 12, 24, 48].entries()) {
      const wave = picture(256, 256, (x, y) => 0.5 + 0.2 * Math.sin((2 * Math.PI * (0.6 * x + 0.8 * y)) / wavelength));
      const bands = toneSpectrum(wave);
      expect(bands[band]).toBeCloseTo(0.2 / Math.SQRT2, 2);
      for (const [other, deviation] of bands.entries()) if (other !== band) expect(deviation).toBeLessThan(0.03);
    }
  });

  it('shares noise among bands by the waves that they hold', () => {
    const random = noise(3);
    const bands = toneSpectrum(picture(256, 256, () => random()));
    for (let i = 1; i < bands.length; i++) expect(bands[i - 1] / bands[i]).toBeCloseTo(2, 0);
    expect(bands[0]).toBeCloseTo(Math.sqrt((Math.PI * (1 / 4 - 1 / 16)) / 12), 2);
  });

  it('is nothing for an even grey', () => {
    for (const deviation of toneSpectrum(picture(64, 64, () => 0.3))) expect(deviation).toBeLessThan(1e-6);
  });
});
