import { expect, test } from 'vitest';
import { type Pen, penFor, strokeAt } from '../../../../src/vector/shading/penStrokes.js';

const SAMPLES = 200;
const LINES = 200;

/** A pen on plain parallel lines, with strokes of length 1 along the second axis. */
const penAt = (place: number, tone: number): Pen =>
  penFor(tone, { places: [0, place], share: 0, period: 1, longer: 0 }, 0, Infinity, 0);

const widthAt = (place: number, tone: number, line: number): number => strokeAt(penAt(place, tone), 1, line).width;

/** The position where a stroke of the line ends and the next begins, in lengths of strokes. */
function endOn(line: number): number {
  const widths = Array.from({ length: 2 * SAMPLES }, (_, i) => widthAt(i / SAMPLES, 0.7, line));
  return widths.indexOf(Math.min(...widths)) / SAMPLES;
}

test.each([1, 0.5, 0.25, 0.125])('ends of strokes form no rows across lines that are %d apart', (distance) => {
  const ends = Array.from({ length: LINES }, (_, i) => endOn((i + 300) * distance));
  for (const lag of [1, 2, 3, 4]) {
    const shifts = ends.slice(lag).map((end, i) => (end - ends[i] + 2) % 1);
    for (let shift = 0; shift < 1; shift += 0.05) {
      const alike = shifts.filter((other) => Math.abs(((other - shift + 1.5) % 1) - 0.5) < 0.05).length;
      expect(alike / shifts.length, `${lag} lines on, ${shift.toFixed(2)} of a stroke`).toBeLessThan(0.4);
    }
  }
});

test('strokes of a dark tone follow each other without gaps', () => {
  for (let line = 300; line < 310; line++) {
    for (let i = 0; i < 4 * SAMPLES; i++) expect(widthAt(i / SAMPLES, 0.85, line)).toBeCloseTo(0.85, 6);
  }
});

test('strokes of one line differ in length, and are of the asked length in the mean', () => {
  const dips: number[] = [];
  for (let i = 1; i < 40 * SAMPLES; i++) {
    const [before, here, after] = [i - 1, i, i + 1].map((at) => widthAt(at / SAMPLES, 0.6, 300));
    if (here < before && here <= after) dips.push(i / SAMPLES);
  }
  const lengths = dips.slice(1).map((end, i) => end - dips[i]);
  expect(lengths.length).toBeGreaterThan(35);
  expect(lengths.reduce((sum, length) => sum + length) / lengths.length).toBeCloseTo(1, 1);
  expect(Math.min(...lengths)).toBeGreaterThan(0.6);
  expect(Math.max(...lengths) - Math.min(...lengths)).toBeGreaterThan(0.2);
});

test('the first strokes of a light tone lie on every third line, wherever they are looked for', () => {
  for (let i = 0; i < 12; i++) {
    const drawn = Array.from({ length: 30 }, (_, line) => widthAt(i + 0.5, 0.045, 300 + line) > 0);
    for (let line = 0; line + 6 <= drawn.length; line++) {
      const neighbours = drawn.slice(line, line + 6).filter(Boolean).length;
      expect(neighbours, `strokes of six lines from ${line} on`).toBeLessThanOrEqual(2);
    }
  }
});

test('lines that repeat after a few have all their strokes in a light tone, as thin as that takes', () => {
  const along = { places: [0, 0], share: 0, period: 1, longer: 0 } as const;
  for (const [octave, least] of [
    [2, 1],
    [-8, 0],
  ]) {
    const widths = Array.from({ length: 9 }, (_, i) => {
      const pen = penFor(0.06, { ...along, places: [0, 0.3 + i] }, 0, 4, octave);
      return strokeAt(pen, 1, 1).presence;
    });
    expect(Math.min(...widths) >= 0.5).toBe(least === 1);
  }
});
