/** The field of lines behind a subject at one place, in double precision, by its documentation. Shares no code with the shader. */
import { clamp01, smoothly } from './vectors.js';

type Pair = readonly [number, number];

/** Lengths in pixels, from the lower left corner of the sheet. */
export interface ReferenceBackground {
  tone: number;
  contrast: number;
  spacing: number;
  /** Angle of the lines, radians. */
  angle: number;
  /** Reach of the field, in halves of the subject's size. */
  extent: number;
  sheet: Pair;
  centre: Pair;
  half: Pair;
  /** Towards the light on the sheet, of length up to 1. */
  lit: Pair;
}

/** A hash in [0, 1) of one end of a line. */
function hash01(line: number, end: 0 | 1): number {
  const first = BigInt.asUintN(32, BigInt(2 * line + end) * 0x9e3779b9n);
  const second = BigInt.asUintN(32, (first ^ (first >> 15n)) * 0x85ebca6bn);
  return Number(second >> 8n) / 2 ** 24;
}

/** The number of the line at a place, and its width there. */
export function ruledAt(field: ReferenceBackground, place: Pair): { line: number; width: number } {
  const { tone, contrast, spacing, angle, extent, sheet, centre, half, lit } = field;
  const [dx, dy] = [place[0] - centre[0], place[1] - centre[1]];
  const along = dx * Math.cos(angle) + dy * Math.sin(angle);
  const line = Math.floor((dy * Math.cos(angle) - dx * Math.sin(angle)) / spacing);
  const [x, y] = [dx / half[0], dy / half[1]];
  // The field ends at its extent, or at 0.95 of the way to the rim of the sheet.
  const toRim = Math.max(...place.map((p, i) => Math.abs(p - sheet[i] / 2) / (sheet[i] / 2)));
  const way = Math.max(Math.hypot(x, y) / extent, toRim / 0.95);
  // Ends vary by 0.2 of the way, less near the middle; lines thin out over the last half of it.
  const inMiddle = clamp01(Math.abs(along) / ((extent * Math.max(...half)) / 2));
  const end = 1 - 0.4 * inMiddle * (hash01(line, along < 0 ? 0 : 1) - 0.5);
  const left = 1 - smoothly(end - 0.5, end, way);
  const side = Math.max(-1, Math.min(1, lit[0] * x + lit[1] * y));
  return { line, width: spacing * left * Math.min(1, tone + tone * contrast * side) };
}
