import { describe, expect, it } from 'vitest';
import { describeLines, missedLines, withLines } from '../../../../tools/metrics/lines.mjs';

const KEPT = { mean: 0.004, p99: 0.03, ink: 0.995, worst: 'light from the left', leftOut: [] };
const linesWith = (change: object) => ({
  sphere: { engraving: KEPT, pen: KEPT },
  bunny: { engraving: { ...KEPT, ...change }, pen: KEPT },
});

describe('drawings as lines beside the canvas', () => {
  it('keep to what is required', () => {
    expect(missedLines(linesWith({}))).toEqual([]);
  });

  it.each([{ mean: 0.0121 }, { p99: 0.046 }, { ink: 0.984 }, { ink: 1.016 }])('miss what is required: %o', (change) => {
    const missed = missedLines(linesWith(change));
    expect(missed.length).toBe(1);
    expect(missed[0]).toMatch(new RegExp(`^engraving of bunny: ${Object.keys(change)[0]} `));
  });

  it('are described in a table of models and presets, where what is missed is bold', () => {
    const text = describeLines(linesWith({ p99: 0.06 }));
    expect(text).toContain('|  | engraving | pen |');
    expect(text).toContain('| sphere | 0.004, 0.030, 0.995 | 0.004, 0.030, 0.995 |');
    expect(text).toContain('| bunny | 0.004, **0.060**, 0.995 |');
    expect(text).not.toContain('not measured');
    expect(describeLines({ sphere: { engraving: KEPT }, bunny: { pen: KEPT } })).toContain('not measured');
  });

  it('are the last part of the page, and are written anew without the others', () => {
    const once = withLines('# Measured strokes\n\nOthers.\n', linesWith({}));
    const twice = withLines(once, linesWith({ mean: 0.02 }));
    expect(once.startsWith('# Measured strokes\n\nOthers.\n\n## Drawings as lines\n')).toBe(true);
    expect(twice).toContain('**0.020**');
    expect(twice.split('## Drawings as lines').length).toBe(2);
    expect(twice.startsWith('# Measured strokes\n\nOthers.\n')).toBe(true);
  });
});
