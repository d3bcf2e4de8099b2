import { describe, expect, test } from 'vitest';
import { drawnValue, type HatchingLook, type ResolvedLook, resolveLook } from '../../../src/look/queries.js';

/** What is drawn of a look on meshes that were prepared with their form, and on others. */
type Row = readonly [what: string, look: HatchingLook, withForm: Partial<ResolvedLook>, without: Partial<ResolvedLook>];

const AUTO = { technique: 'engraving', direction: 'auto' } as const;

describe('a look is resolved', () => {
  test.each<Row>([
    ['lines across the light', { technique: 'engraving' }, { direction: 'light' }, { direction: 'light' }],
    ['lines along an axis', { technique: 'engraving', direction: 'x' }, { direction: 'x' }, { direction: 'x' }],
    ['lines that choose', AUTO, { direction: 'form' }, { direction: 'light' }],
    ['lines of a pen', { ...AUTO, technique: 'pen' }, { direction: 'form', technique: 'pen' }, { direction: 'slant' }],
    ['cuts of a woodcut', { ...AUTO, technique: 'woodcut' }, { direction: 'form' }, { direction: 'towardsLight' }],
    [
      'lines across the form',
      { technique: 'pen', direction: 'acrossForm' },
      { direction: 'acrossForm' },
      { direction: 'light' },
    ],
    [
      'strokes along the form',
      { technique: 'hatching', direction: 'form' },
      { direction: 'form' },
      { direction: 'light' },
    ],
    ['strokes on a sheet', { technique: 'hatching', direction: 'sheet' }, { direction: 'sheet' }, {}],
    // Dots have no direction.
    ['dots', { technique: 'stipple', direction: 'form' }, { technique: 'stipple' }, {}],
    ['a direction that strokes do not know', { direction: 'auto' }, { direction: 'light' }, { direction: 'light' }],
    ['a direction that lines do not know', { technique: 'pen', direction: 'sheet' }, { direction: 'light' }, {}],
    ['a choice of another technique', { technique: 'triangle', direction: 'x' }, { direction: 'light' }, {}],
    [
      'shadows that run away from the light',
      { ...AUTO, isHatchingShadowMaterial: true, shadowStrokes: 'cross', strokeLayers: 'tone' },
      { direction: 'light', shadowStrokes: 'tone', strokeLayers: 'single', runsAway: true },
      { direction: 'light', shadowStrokes: 'tone', runsAway: true },
    ],
    [
      'shadows in the strokes of the look',
      { ...AUTO, isHatchingShadowMaterial: true, shadowDirection: 'strokes', shadowStrokes: 'cross' },
      { direction: 'form', shadowStrokes: 'cross', runsAway: false },
      { direction: 'light' },
    ],
  ])('%s', (_, look, withForm, without) => {
    expect(resolveLook(look, true)).toMatchObject(withForm);
    expect(resolveLook(look, false)).toMatchObject(without);
  });

  test('a value that does not count for the technique is at its default', () => {
    expect(drawnValue({ technique: 'triangle', perTriangle: { sharpInk: true } }, 'sharpInk', false)).toBe(true);
    expect(drawnValue({ technique: 'hatching', perTriangle: { sharpInk: true } }, 'sharpInk', false)).toBe(false);
  });
});
