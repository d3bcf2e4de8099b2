import { expect, test } from 'vitest';
import type { HandNumbers } from '../../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { HAND_TEXTURE } from '../../../../src/strokes/handConstants.js';
import { type StrokeProfiles, strokeProfiles } from '../../../../src/strokes/strokeProfiles.js';
import { type Cells, type RowStroke, rowsFor, strokesOnRow } from '../../../../src/vector/shading/handStrokes.js';

const { PLACES, TONE_ROWS } = HAND_TEXTURE;

/** A hand of one straight stroke beside its row, whose share grows with the tone. */
const profiles: StrokeProfiles = {
  count: 1,
  strokes: Float32Array.from({ length: 2 * PLACES }, (_, i) => (i % 2 === 0 ? 0.25 : 0.125)),
  tones: Array.from({ length: TONE_ROWS }, () =>
    Array.from({ length: PLACES }, (_, i) => ({ share: i / (PLACES - 1), widening: 0 })),
  ),
  ...{
    offset: 0.25,
    halfWidth: 0.125,
    bundled: 0,
    laneOffset: 0,
    laneShift: 0,
    spacing: 1,
    cell: 1,
    filled: 0.75,
    shorter: 0,
  },
};

/** Cells of length 2, of one stroke each. */
const cellsAt = (place: number, hasSeams = false): Cells => ({
  coordinates: [{ id: 0, place, share: 1, perPixel: 0.01, askew: 0, step: [1, 0, 0] }],
  stepAcross: [0, 1, 0],
  ...{ repeat: hasSeams ? 16 : 64, hasSeams, period: 2, paired: 0, longest: 1 },
});

/** The stroke on a row, at the place along it. Rows are 1 apart, and 40 pixels. */
function strokeAt(line: number, place: number, tone = 1, hasSeams = false): RowStroke | undefined {
  const hand = { profiles, cells: cellsAt(place, hasSeams), value: line, isDark: 0 as const };
  const rows = rowsFor({ ...hand, repeat: hasSeams ? 16 : Infinity }, tone, 0, 1 / 40);
  return strokesOnRow(rows, line)[0];
}

const places = Array.from({ length: 4000 }, (_, i) => 0.01 * i);

test('a row in full tone is one whole stroke of the hand after the other, as far apart as cells', () => {
  const strokes = places.map((place) => strokeAt(5, place));
  const starts = places.filter((_, i) => i > 0 && strokes[i] && strokes[i]?.cell !== strokes[i - 1]?.cell);
  expect(starts.length).toBeGreaterThan(17);
  for (const [i, start] of starts.slice(1).entries()) expect(start - starts[i]).toBeLessThan(2 + 2 * 0.25);
  const inside = strokes.filter((stroke) => stroke !== undefined);
  expect(inside.length / places.length).toBeCloseTo(0.75, 1);
  for (const { shift } of inside) expect(shift).toBeCloseTo(0.25 * 40, 6);
  // Blunt ends are round.
  expect(Math.max(...inside.map(({ half }) => half))).toBeCloseTo(0.125 * 40, 6);
  expect(Math.min(...inside.map(({ half }) => half))).toBeLessThan(2.5);
  for (const [i, stroke] of strokes.slice(1).entries())
    if (stroke && stroke.cell === strokes[i]?.cell) expect(stroke.t).toBeGreaterThan(strokes[i]!.t);
});

test('in lighter tones as many strokes are there as the hand says', () => {
  for (const tone of [0.1, 0.3, 0.6]) {
    // A tone is that of strokes that fill their cells.
    const share = 1 - (1 - tone) ** (1 / (1 - 0.03));
    const there = Array.from({ length: 4000 }, (_, i) => strokeAt(i % 63, 2 * Math.floor(i / 63) + 1, tone));
    const all = Array.from({ length: 4000 }, (_, i) => strokeAt(i % 63, 2 * Math.floor(i / 63) + 1, 1));
    const found = there.filter(Boolean).length / all.filter(Boolean).length;
    expect(Math.abs(found - share), `${tone}: ${found}, not ${share}`).toBeLessThan(0.12 * share + 0.01);
  }
});

/** Straight strokes of 10 mm, and the strokes of their rows in full tone, as spans of places along a row, in the order of their starts. */
function spansOf(numbers: Partial<HandNumbers>, wanted: number): { from: number; to: number; lane: number }[] {
  const strokes = Array.from({ length: 9 }, (_, i) => ({ points: [0, 2 * i, 10, 2 * i], widths: [0.4, 0.4] }));
  const hand = learnHand(strokes);
  const ruled = { ...hand.numbers, angleSpread: 0, lengthSpread: 0, ...numbers };
  const drawn = strokeProfiles({ ...hand, numbers: ruled });
  const [paired, longest] = [(2 * (wanted - 1)) / wanted, 1];
  const open = new Map<string, { from: number; to: number; lane: number }>();
  for (let line = 0; line < 6; line++)
    for (const place of places) {
      const cells = { ...cellsAt(place), paired, longest };
      const rows = rowsFor({ profiles: drawn, cells, value: line, isDark: 0, repeat: Infinity }, 1, 0, 1 / 40);
      for (const { lane, cell, length } of strokesOnRow(rows, line)) {
        const at = 1000 * line + place;
        const span = open.get(`${line} ${lane} ${cell} ${length}`);
        if (span) span.to = at;
        else open.set(`${line} ${lane} ${cell} ${length}`, { from: at, to: at, lane });
      }
    }
  // Without those that the ends of the places cut.
  const whole = [...open.values()].filter(({ from, to }) => from % 1000 > 0.02 && to % 1000 < 39.97);
  return whole.sort((a, b) => a.from - b.from);
}

/** How much of the mean length of strokes lies beside the next one of their row, as a share. */
function overlapOf(spans: readonly { from: number; to: number }[], isCounted: (i: number) => boolean): number {
  const length = spans.reduce((sum, { from, to }) => sum + to - from, 0) / spans.length;
  const counted = spans.flatMap(({ to }, i) => {
    const gap = i + 1 < spans.length ? spans[i + 1].from - to : Infinity;
    return isCounted(i) && Math.abs(gap) < 2 * length ? [-gap] : [];
  });
  expect(counted.length).toBeGreaterThan(20);
  return counted.reduce((sum, one) => sum + one, 0) / counted.length / length;
}

test.each([0.1, 0.25, 0.45])(
  'strokes run beside the next one of their row over a share of their length: %d',
  (overlap) => {
    for (const wanted of [1, 1.3, 1.7]) {
      const found = overlapOf(spansOf({ overlap }, wanted), () => true);
      expect(Math.abs(found - overlap), `${found} of cells of ${wanted}`).toBeLessThan(Math.max(0.15 * overlap, 0.04));
    }
  },
);

test.each([0.75, 1])('strokes that overlap by more than a half lie in pairs: %d', (overlap) => {
  for (const wanted of [1, 1.3, 1.7]) {
    const spans = spansOf({ overlap }, wanted);
    const found = overlapOf(spans, (i) => spans[i].lane === 0 && spans[i + 1]?.lane === 1);
    expect(Math.abs(found - overlap), `${found} of cells of ${wanted}`).toBeLessThan(0.15 * overlap);
  }
});

test('strokes end to end have one lane', () => {
  const spans = spansOf({ overlap: 0 }, 1);
  expect(new Set(spans.map(({ lane }) => lane))).toEqual(new Set([0]));
});

test('where strokes of two cells fill less of them, rows are as dark as they shall be', () => {
  const strokes = Array.from({ length: 9 }, (_, i) => ({ points: [0, 2 * i, 10, 2 * i], widths: [0.9, 0.9] }));
  const { numbers, ...hand } = learnHand(strokes);
  const drawn = strokeProfiles({ ...hand, numbers: { ...numbers, angleSpread: 0, spacing: 2, overlap: 0 } });
  // As many cells of both sizes as strokes 1.2 times as long as a cell have.
  const [paired, longest] = [0.4 / 0.7, 0.75];
  for (const tone of [0.5, 0.65, 0.8]) {
    const [across, along] = [24, 160];
    let covered = 0;
    for (let i = 0; i < across * along; i++) {
      const place = 40 * ((i * 0.618034) % 1);
      const value = 1 + 40 * ((i + 0.5) / (across * along));
      const rows = rowsFor(
        { profiles: drawn, cells: { ...cellsAt(place), paired, longest }, value, isDark: 0, repeat: Infinity },
        tone,
        0,
        1 / 40,
      );
      const isInk = Array.from({ length: 17 }, (_, k) => Math.round(value) + 0.5 * (k - 8)).some((line) =>
        strokesOnRow(rows, line).some(({ shift, half }) => Math.abs((value - line) * 40 - shift) < half),
      );
      if (isInk) covered++;
    }
    const found = covered / (across * along);
    expect(Math.abs(found - tone), `${found} in place of ${tone}`).toBeLessThan(0.05);
  }
});

/** The lengths of strokes that stand in a shadow which begins at a place along the rows, and end or begin there; the lit tone is 0. */
function lengthsAtEdge(edge: number): number[] {
  return Array.from({ length: 12 }, (_, line) => {
    const there = places.filter((place) => {
      const hand = { profiles, cells: cellsAt(place), value: line, isDark: 0 as const, repeat: Infinity };
      const takenAt = ([x]: readonly number[]): number => (place + x > edge ? 1 : 0);
      return strokesOnRow(rowsFor(hand, 0, 0, 1 / 40, { tone: 1, takenAt }), line).length > 0;
    });
    const first = there[0];
    const end = there.find((place, i) => i > 0 && place - there[i - 1] > 0.015 && place > edge) ?? Infinity;
    return there.filter((place) => place >= first && place < end).length * 0.01;
  });
}

test('strokes at the hard edge of a shadow are whole or lose a sixth at the edge, and no strokes are in the light', () => {
  const lengths = lengthsAtEdge(20);
  const full = 0.75 * 2;
  for (const length of lengths) {
    expect(length).toBeGreaterThan(0.81 * full);
    expect(length).toBeLessThan(1.03 * full);
  }
  expect(lengths.filter((length) => length < 0.86 * full).length).toBeGreaterThan(2);
  expect(lengths.filter((length) => length > 0.97 * full).length).toBeGreaterThan(2);
});

test('on the other side of a seam, where rows are numbered the other way, the strokes are the same', () => {
  for (const place of places.slice(0, 800)) {
    const [here, there] = [strokeAt(3, place, 0.8, true), strokeAt(-3, -place, 0.8, true)];
    const farther = strokeAt(3 + 16, place + 32, 0.8, true);
    expect(there?.t).toEqual(here?.t);
    if (here) expect(there?.shift).toBe(-here.shift);
    if (here) expect(farther?.t).toBeCloseTo(here.t, 9);
    expect(farther?.cell).toBe(here?.cell);
  }
});

test('rows between old ones and their middles are blank', () => {
  expect(places.every((place) => strokeAt(0.25, place) === undefined)).toBe(true);
});
