/** The field of ruled lines behind a subject, as in shaders/background/background.frag. On the sheet, from its lower left corner, y up. */
import { BACKGROUND_CONSTANTS, HASH_FACTORS } from '../../look/constants/patternConstants.js';
import { smoothstep } from '../../look/vectors.js';

const { RAGGED, THINNING, RIM } = BACKGROUND_CONSTANTS;
const { GOLDEN_RATIO, SECOND_FACTOR } = HASH_FACTORS;

type Pair = readonly [number, number];

/** The field. Lengths in pixels. */
export interface BackgroundField {
  /** The share of the paper that lines cover in the middle, and the strength of the light's effect on it. */
  tone: number;
  contrast: number;
  spacing: number;
  /** The cosine and sine of the angle of the lines. */
  direction: Pair;
  /** Reach of the field, in halves of the subject's size. */
  extent: number;
  /** Width and height of the sheet. */
  sheet: Pair;
  /** Centre of the subject on the sheet, and half of its size. */
  centre: Pair;
  half: Pair;
  /** Towards the light on the sheet; of length 1 if it comes from the side. */
  lit: Pair;
}

/** A hash in [0, 1) of one end of a line. */
function hash01(line: number, end: number): number {
  let spread = Math.imul(2 * line + end, GOLDEN_RATIO);
  spread ^= spread >>> 15;
  return (Math.imul(spread, SECOND_FACTOR) >>> 8) / 16777216;
}

/** The number of the line that is nearest to a place on the sheet. */
export function lineAt({ centre, direction, spacing }: BackgroundField, [x, y]: Pair): number {
  const [dx, dy] = [x - centre[0], y - centre[1]];
  return Math.floor((dy * direction[0] - dx * direction[1]) / spacing);
}

/** The place on a line at a distance along it, from the centre of the subject. */
export function placeOnLine({ centre, direction, spacing }: BackgroundField, line: number, along: number): Pair {
  const across = (line + 0.5) * spacing;
  return [
    centre[0] + along * direction[0] - across * direction[1],
    centre[1] + along * direction[1] + across * direction[0],
  ];
}

/** The width of a line at a place of the sheet; 0 where it has ended. */
export function lineWidth(field: BackgroundField, line: number, [x, y]: Pair): number {
  const { tone, contrast, spacing, direction, extent, sheet, centre, half, lit } = field;
  const [dx, dy] = [x - centre[0], y - centre[1]];
  const along = dx * direction[0] + dy * direction[1];
  const bySize: Pair = [dx / half[0], dy / half[1]];
  const rim = Math.max(Math.abs((2 * x) / sheet[0] - 1), Math.abs((2 * y) / sheet[1] - 1)) / RIM;
  const way = Math.max(Math.hypot(...bySize) / extent, rim);
  // The two ends of a line have unrelated hashes, so near its middle they have no effect.
  const ragged = RAGGED * Math.min((2 * Math.abs(along)) / (extent * Math.max(...half)), 1);
  const end = ragged * (hash01(line, along >= 0 ? 1 : 0) - 0.5);
  const left = 1 - smoothstep(1 - THINNING, 1, way + end);
  const side = Math.min(Math.max(lit[0] * bySize[0] + lit[1] * bySize[1], -1), 1);
  return spacing * left * Math.min(tone * (1 + contrast * side), 1);
}
