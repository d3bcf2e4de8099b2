import { describe, expect, test } from 'vitest';
import { drawnValue, type HatchingLook, type ResolvedLook, resolveLook } from '../../../src/look/queries.js';

/** What is drawn of a look on meshes that were prepared with their form, and on others. */
type Row = readonly [what: string, look: HatchingLook, withForm: Partial<ResolvedLook>, without: Partial<ResolvedLook>];

const AUTO = { technique: 'engraved', lineField: 'auto' } as const;

describe('a look is resolved', () => {
  test.each<Row>([
    ['lines across the light', { technique: 'engraved' }, { lineField: 'light' }, { lineField: 'light' }],
    ['lines along an axis', { technique: 'engraved', lineField: 'x' }, { lineField: 'x' }, { lineField: 'x' }],
    ['lines that choose', AUTO, { lineField: 'form' }, { lineField: 'light' }],
    ['lines of a pen', { ...AUTO, medium: 'pen' }, { lineField: 'form', medium: 'pen' }, { lineField: 'slant' }],
    ['cuts of a woodcut', { ...AUTO, medium: 'woodcut' }, { lineField: 'form' }, { lineField: 'towards' }],
    [
      'lines across the form',
      { technique: 'engraved', lineField: 'acrossForm', medium: 'pen' },
      { lineField: 'acrossForm' },
      { lineField: 'light' },
    ],
    [
      'strokes along the form',
      { technique: 'anchored', strokeField: 'form' },
      { strokeField: 'form' },
      { strokeField: 'light' },
    ],
    ['strokes on a sheet', { technique: 'anchored', strokeField: 'sheet' }, { strokeField: 'sheet' }, {}],
    // Dots have no direction.
    ['dots', { technique: 'anchored', medium: 'stipple', strokeField: 'form' }, { medium: 'stipple' }, {}],
    [
      'a medium that the technique does not know',
      { technique: 'anchored', medium: 'pen' },
      { medium: 'ink' },
      { medium: 'ink' },
    ],
    ['a choice of another technique', { technique: 'triangle', lineField: 'x' }, { lineField: 'light' }, {}],
    [
      'shadows that run away from the light',
      { ...AUTO, toneModel: 'shadow', shadowStrokes: 'cross', strokeLayers: 'tone' },
      { lineField: 'light', shadowStrokes: 'tone', strokeLayers: 'single', runsAway: true },
      { lineField: 'light', shadowStrokes: 'tone', runsAway: true },
    ],
    [
      'shadows in the strokes of the look',
      { ...AUTO, toneModel: 'shadow', shadowDirection: 'strokes', shadowStrokes: 'cross' },
      { lineField: 'form', shadowStrokes: 'cross', runsAway: false },
      { lineField: 'light' },
    ],
  ])('%s', (_, look, withForm, without) => {
    expect(resolveLook(look, true)).toMatchObject(withForm);
    expect(resolveLook(look, false)).toMatchObject(without);
  });

  test('a value that does not count for the technique is at its default', () => {
    expect(drawnValue({ technique: 'triangle', crisp: true }, 'crisp', false)).toBe(true);
    expect(drawnValue({ technique: 'anchored', crisp: true }, 'crisp', false)).toBe(false);
  });
});
