import { describe, expect, test } from 'vitest';
import { ColourReader } from '../../../../src/vector/paint/ColourReader.js';
import type { MapLook, PaintLook } from '../../../../src/vector/paint/PaintLook.js';

const TEXELS = 64;

/** Stripes of black and white, each so many texels wide. @param alpha of the black ones */
function stripes(width: number, alpha = 1): MapLook {
  const data = new Float32Array(4 * TEXELS * TEXELS);
  for (let i = 0; i < TEXELS * TEXELS; i++) {
    const isWhite = Math.floor((i % TEXELS) / width) % 2 === 1;
    const grey = Number(isWhite);
    data.set([grey, grey, grey, isWhite ? 1 : alpha], 4 * i);
  }
  const image = { width: TEXELS, height: TEXELS, data };
  return { image, uv: 0, transform: [1, 0, 0, 0, 1, 0], wrapU: 'repeat', wrapV: 'repeat', isSharp: false };
}

/** The darkness at the middles of texels along a row of a map on a triangle that shows each texel as two pixels. */
function darknesses(map: MapLook, mapBlur: number): number[] {
  const none = { emissiveMap: null, aoMap: null, lightMap: null, alphaMap: null, normalMap: null, bumpMap: null };
  const look: PaintLook = {
    ...{ map, ...none, mapBlur, color: [1, 1, 1], opacity: 1, emissive: [0, 0, 0], vertexColor: null },
    ...{
      aoMapIntensity: 1,
      lightMapIntensity: 1,
      normalScale: [1, 1],
      normalToWorld: null,
      bumpScale: 1,
      alphaTest: 0,
    },
    tones: {
      colorHatching: 1,
      colorExposure: 1,
      colorFilter: [0.2126, 0.7152, 0.0722, 0],
      valueKnots: [0, 0, 0, 0],
      valueBends: [0, 0, 0, 0],
    },
  };
  const size = 2 * TEXELS;
  const numbers = [0, 0, 1, 0, 0, 1];
  const details = { firstTriangle: 0, corners: [0, 1, 2], stride: 2, numbers, viewToField: null };
  const reader = new ColourReader(look, details);
  reader.goTo(0, { bb: size * size, bc: 0, cc: size * size }, [
    [0, 0, 0],
    [size, 0, 0],
    [0, size, 0],
  ]);
  return Array.from({ length: 16 }, (_, i) => reader.paintAt([(i + 0.5) / TEXELS, 0.25], 2).darkness);
}

const spread = (values: readonly number[]): number => Math.max(...values) - Math.min(...values);

describe('a map whose values are planned', () => {
  test('has no details that are finer than lines can show', () => {
    expect(spread(darknesses(stripes(1), 0))).toBeCloseTo(1, 9);
    expect(spread(darknesses(stripes(1), 3))).toBeLessThan(0.01);
  });

  test('keeps those that are coarser', () => {
    expect(spread(darknesses(stripes(8), 3))).toBeGreaterThan(0.5);
  });

  test('is read as it is where some of it is cut out', () => {
    expect(spread(darknesses(stripes(1, 0), 3))).toBeCloseTo(1, 9);
  });
});
