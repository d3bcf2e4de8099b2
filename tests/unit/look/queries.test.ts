import { describe, expect, test } from 'vitest';
import type { HatchingPropertyName, HatchingTechnique } from '../../../src/look/hatchingProperties.js';
import { counts, measureOf, pixelPower, scaledSizes } from '../../../src/look/measuredFacts.js';
import {
  drawsLines,
  followsForm,
  formOf,
  type HatchingLook,
  needsAdjacency,
  needsMap,
  usesThresholds,
} from '../../../src/look/queries.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { PropertyRow } from '../../../tools/properties/PropertyRow.js';
import { PROPERTIES } from '../../../tools/properties/table.js';
import { TECHNIQUES } from '../../../tools/properties/techniques.js';

describe('queries of a look', () => {
  test.each([
    [{}, true, false],
    [{ technique: 'triangle' }, true, true],
    [{ technique: 'adjacency' }, true, true],
    [{ technique: 'adjacency', perTriangle: { sharpInk: true } }, true, true],
    [{ technique: 'hatching' }, true, false],
    [{ technique: 'dryMedia' }, true, false],
    [{ technique: 'stipple' }, false, false],
    [{ technique: 'engraving' }, false, false],
    [{ technique: 'woodcut' }, false, false],
    [{ preset: 'pen' }, false, false],
    [{ preset: 'pencil' }, true, false],
    [{ preset: 'stipple' }, false, false],
    [{ preset: 'engraving' }, false, false],
    [{ preset: 'engraving', technique: 'adjacency' }, true, true],
  ] as const)('%j: a map is needed: %s, adjacency: %s', (look, map, adjacency) => {
    expect([needsMap(look), needsAdjacency(look)]).toEqual([map, adjacency]);
    const material = new HatchingMaterial(look);
    expect([needsMap(material), needsAdjacency(material)]).toEqual([map, adjacency]);
  });

  test.each([
    [{}, true],
    [{ technique: 'adjacency' }, false],
    [{ technique: 'adjacency', perTriangle: { sharpInk: true } }, true],
    [{ technique: 'hatching' }, true],
    [{ technique: 'dryMedia' }, true],
    // Dots are drawn without a map.
    [{ technique: 'stipple' }, false],
    // The crispness of another technique.
    [{ technique: 'engraving', perTriangle: { sharpInk: true } }, false],
  ] as const)('%j decides ink from thresholds: %s', (look, expected) => {
    expect(usesThresholds(look)).toBe(expected);
  });

  test.each([
    [{}, false],
    [{ technique: 'engraving' }, false],
    [{ technique: 'engraving', direction: 'x' }, false],
    [{ technique: 'engraving', direction: 'acrossForm' }, true],
    [{ technique: 'engraving', direction: 'auto' }, 'auto'],
    [{ preset: 'banknote' }, true],
    [{ preset: 'engraving' }, 'auto'],
    [{ preset: 'pen' }, 'auto'],
    [{ preset: 'pencil', direction: 'light' }, false],
    [{ preset: 'pencil', direction: 'form' }, true],
    [{ direction: 'acrossForm', technique: 'dryMedia' }, true],
    [{ direction: 'form', technique: 'woodcut' }, true],
    // Dots have no direction.
    [{ direction: 'form', technique: 'stipple' }, false],
    // A choice of lines alone counts as the default of strokes.
    [{ technique: 'hatching', direction: 'auto' }, false],
    // A property of other techniques.
    [{ technique: 'adjacency', direction: 'form' }, false],
  ] as const)('%j asks of geometries for the form: %s', (look, form) => {
    expect([formOf(look), followsForm(look)]).toEqual([form, form !== false]);
    const material = new HatchingMaterial();
    material.setValues(look);
    expect(formOf(material)).toBe(form);
  });

  test.each([
    ['strokeAngle', {}, true],
    ['strokeAngle', { direction: 'form' }, false],
    ['strokeAngle', { direction: 'sheet' }, true],
    // Of lines 'sheet' is not known, and counts as 'light'.
    ['strokeAngle', { direction: 'sheet', technique: 'engraving' }, true],
    ['strokeAngle', { direction: 'x', technique: 'engraving' }, false],
    ['strokeAngle', { direction: 'x', technique: 'triangle' }, true],
    ['direction', { technique: 'dryMedia' }, true],
    ['direction', { technique: 'stipple' }, false],
    ['paperGrain', { technique: 'dryMedia' }, true],
    ['paperGrain', { technique: 'hatching' }, false],
    ['paperGrain', { technique: 'engraving' }, false],
    ['strokeLength', { technique: 'engraving' }, false],
    ['strokeLength', { technique: 'pen' }, true],
    ['edgePixels', { technique: 'hatching' }, true],
    ['edgePixels', { technique: 'dryMedia' }, false],
    ['edgePixels', { technique: 'adjacency' }, false],
    ['edgePixels', { technique: 'adjacency', perTriangle: { sharpInk: true } }, true],
    ['crossFrom', { technique: 'hatching' }, true],
    ['crossFrom', { technique: 'hatching', strokeLayers: 'single' }, false],
    ['crossFrom', { technique: 'adjacency' }, false],
    ['crossFrom', { technique: 'hatching', strokeLayers: 'tone' }, true],
    // Engraved lines cross whatever the layers of strokes.
    ['crossFrom', { technique: 'engraving' }, true],
    ['toneSteps', { toneModel: 'toon' }, true],
    ['toneSteps', {}, false],
    ['shininess', { toneModel: 'phong' }, true],
    ['ink', {}, true],
    ['lineSpacing', { technique: 'engraving' }, true],
    ['lineSpacing', {}, false],
    // Greys whose level follows from derivatives have the width that the map draws.
    ['strokeWidth', { technique: 'adjacency' }, false],
    ['strokeWidth', { technique: 'adjacency', perTriangle: { levelRule: 'depth' } }, true],
    ['strokeWidth', { technique: 'adjacency', perTriangle: { sharpInk: true } }, true],
    ['strokeWidth', { technique: 'hatching' }, true],
    ['strokeWidth', { technique: 'engraving', perTriangle: { levelRule: 'depth' } }, false],
    ['latticeSpacing', { technique: 'stipple' }, false],
    ['strokeAngle', { technique: 'stipple' }, false],
    ['strokeAngle', { technique: 'engraving' }, true],
    ['strokeAngle', { technique: 'woodcut' }, true],
    ['latticeSpacing', { technique: 'hatching' }, true],
    ['tilesPerObjectUnit', { technique: 'hatching', screenSpaceShare: 0.9 }, true],
    ['tilesPerObjectUnit', { technique: 'hatching', screenSpaceShare: 1 }, false],
    // Strokes of `triangle` are always sized on the object.
    ['tilesPerObjectUnit', { technique: 'triangle', screenSpaceShare: 1 }, true],
    ['bumpScale', {}, false],
    ['bumpScale', { bumpMap: {}, toneNormal: 'smooth' }, true],
    ['bumpScale', { bumpMap: {} }, true],
    ['bumpScale', { technique: 'adjacency', bumpMap: {} }, false],
    ['bumpMap', { bumpMap: {}, normalMap: {}, toneNormal: 'smooth' }, false],
    ['normalMap', { technique: 'hatching', toneNormal: 'auto' }, true],
    ['normalMap', { technique: 'hatching', toneNormal: 'face' }, false],
    ['highlightSoftness', { highlightThreshold: 0 }, false],
    ['highlightSoftness', { highlightThreshold: 0.2 }, true],
    ['exposureCompensation', {}, false],
    ['exposureCompensation', { composition: { exposure: 2 } }, false],
    ['exposureCompensation', { composition: { exposure: 'auto' } }, true],
    ['exposureCompensation', { composition: { exposure: 'fit' } }, true],
    ['exposureCompensation', { preset: 'pen' }, true],
    ['depthFadeEnd', { composition: { depthFade: 'auto' } }, true],
    ['strokeWidth', { technique: 'pen' }, false],
    ['strokeWidth', { technique: 'pen', hand: {} }, true],
    ['lineSpacing', { technique: 'pen' }, true],
    ['lineSpacing', { technique: 'pen', hand: {} }, false],
    ['lineSpacing', { technique: 'engraving', hand: {} }, true],
  ] as const)('%s under %j counts: %s', (name, look, expected) => {
    expect(counts(look, name)).toBe(expected);
  });

  test('conditions name existing properties and values', () => {
    const rows: Record<string, PropertyRow> = PROPERTIES;
    for (const [name, { when = {} }] of Object.entries(rows)) {
      for (const condition of [when].flat()) {
        for (const [other, values] of Object.entries(condition)) {
          const row = rows[other];
          const named = 'not' in values ? [values.not] : values;
          if (row.kind === 'choice') expect(Object.keys(row.choices), name).toEqual(expect.arrayContaining([...named]));
          else
            expect(named, name).toEqual(
              row.kind === 'number' && row.words
                ? row.words
                : [
                    row.kind === 'switch'
                      ? true
                      : row.kind === 'texture' || row.kind === 'point' || row.kind === 'hand'
                        ? null
                        : expect.any(Number),
                  ],
            );
        }
      }
    }
  });
});

test.each([
  ['strokeWidth', {}, 'pixels'],
  ['edgePixels', {}, 'gridPixels'],
  ['irregularity', {}, 'share'],
  ['lineSpacing', {}, 'pixels'],
  ['lineSpacing', { screenSpaceShare: 0 }, 'tileParts'],
  ['lineSpacing', { screenSpaceShare: 1 }, 'pixels'],
  // A mean of the two.
  ['lineSpacing', { screenSpaceShare: 0.5 }, undefined],
  ['ink', {}, undefined],
] as const)('%s of %j measures %s', (name, look, expected) => {
  expect(measureOf(look, name)).toBe(expected);
});

describe('sizes for a picture of more pixels', () => {
  test.each([
    ['strokeWidth', {}, 1],
    ['paperGrainSize', { screenSpaceShare: 0 }, 1],
    ['lineSpacing', {}, 1],
    ['lineSpacing', { screenSpaceShare: 0 }, 0],
    ['lineSpacing', { screenSpaceShare: 0.25 }, 0.25],
    ['lineSpacing', { screenSpaceShare: 1 }, 1],
    ['edgePixels', {}, 0],
    ['tilesPerObjectUnit', {}, 0],
    ['ink', {}, 0],
  ] as const)('%s of %j goes with the power %d', (name, look, power) => {
    expect(pixelPower(look, name)).toBe(power);
  });

  test('are those given in the look and measured in pixels', () => {
    const look = {
      screenSpaceShare: 0,
      strokeWidth: 2,
      tilesPerObjectUnit: 3,
      edgePixels: 1,
      latticeSpacing: 0.4,
      ink: 'navy',
      lineSpacing: 4,
    };
    expect(scaledSizes(look, 4)).toEqual({ strokeWidth: 8 });
    expect(scaledSizes({ ...look, screenSpaceShare: 1 }, 4)).toEqual({ strokeWidth: 8, lineSpacing: 16 });
    expect(scaledSizes({ ...look, screenSpaceShare: 0.5 }, 4)).toEqual({ strokeWidth: 8, lineSpacing: 8 });
    expect(scaledSizes({ strokeWidth: null, paperGrainSize: 2 }, 0.5)).toEqual({ paperGrainSize: 1 });
    // Never below its range: lines of less than two pixels cannot be told apart.
    expect(scaledSizes({ minLineSpacing: 3 }, 0.5)).toEqual({ minLineSpacing: 2 });
  });

  test('include those of the preset, unless the look has its own', () => {
    expect(scaledSizes({ preset: 'pen' }, 2)).toMatchObject({ strokeLength: 144 });
    expect(scaledSizes({ preset: 'pen', strokeLength: 50 }, 2)).toMatchObject({ strokeLength: 100 });
    expect(scaledSizes({ preset: 'engraving' }, 2)).toMatchObject({ lineSpacing: 9 });
  });

  test('of a material include every one, whatever its technique', () => {
    const sizes: HatchingPropertyName[] = ['lineSpacing', 'strokeLength', 'minLineSpacing', 'paperGrainSize'];
    for (const technique of Object.keys(TECHNIQUES) as (keyof typeof TECHNIQUES)[]) {
      const look: HatchingLook = new HatchingMaterial({
        technique,
        screenSpaceShare: drawsLines(technique as HatchingTechnique) ? 1 : 0,
      });
      const expected = drawsLines(technique as HatchingTechnique) ? sizes : sizes.slice(2);
      if (['hatching', 'dryMedia', 'stipple'].includes(technique)) expected.push('strokeWidth');
      expect(Object.keys(scaledSizes(look, 2)).sort()).toEqual([...expected].sort());
    }
  });
});
