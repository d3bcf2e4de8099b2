import { RepulsionField } from './RepulsionField.js';
import { type Random, random } from './random.js';
import { rasterizeStroke } from './rasterizeStroke.js';
import type { Stroke } from './Stroke.js';
import type { StrokeStyle } from './strokeStyles.js';

/** What to draw. */
export interface PlacementRequest {
  style: StrokeStyle;
  seed: number;
  /** Texels per side of the finest level. */
  size: number;
  tones: number;
  levels: number;
}

/** Cells read or written between two reports of progress: about a millisecond's work. */
const WORK_PER_SLICE = 100_000;

/** One level while it is being drawn. */
interface Sheet {
  size: number;
  image: Uint8Array;
  /** 255·ink, summed over the image. */
  darkness: number;
  /** Crowding for strokes along u and, for cross-hatching, along v. */
  fields: RepulsionField[];
  /** Ink drawn so far in each direction, overlaps counted again: what keeps the two layers in step. */
  drawn: number[];
  /** What the last stroke added to `darkness`. */
  lastGain: number;
}

/**
 * Chooses the strokes of a tonal art map, greedily after Praun et al. 2001: tones from light to dark, within a tone
 * levels from coarse to fine, each stroke the best of many random proposals, until the level has its mean ink. A
 * stroke chosen for a level is drawn on every finer one, and stays in every darker tone: that is the nesting property.
 *
 * Only arithmetic that IEEE 754 rounds exactly is used, so the same request gives the same strokes on every machine.
 *
 * @returns the strokes in order of drawing; yields progress in [0, 1]
 */
export function* placeStrokes(request: PlacementRequest): Generator<number, Stroke[], void> {
  const { style, size, tones, levels } = request;
  const next = random(request.seed);
  const sheets = Array.from({ length: levels }, (_, level) => createSheet(size >> level, style));
  const strokes: Stroke[] = [];
  let work = 0;
  for (let tone = 1; tone < tones; tone++) {
    const target = (style.maxInk * tone) / (tones - 1);
    for (let level = levels - 1; level >= 0; level--) {
      const sheet = sheets[level];
      const goal = 255 * sheet.size * sheet.size * target;
      const start = sheet.darkness;
      while (goal - sheet.darkness > 0.5 * sheet.lastGain) {
        const stroke = proposeBest(request, sheets, tone, level, target, next);
        strokes.push(stroke);
        work += style.proposals * 16 * (level + 1);
        for (let finer = level; finer >= 0; finer--) work += draw(sheets[finer], stroke);
        if (work >= WORK_PER_SLICE) {
          work = 0;
          // Finer levels take four times the work of the next coarser one.
          const share = 4 ** -level;
          const level1 = 4 ** -(level + 1);
          const within = Math.min(1, (sheet.darkness - start) / Math.max(1, goal - start));
          yield (tone - 1 + level1 + (share - level1) * within) / (tones - 1);
        }
      }
    }
  }
  return strokes;
}

function createSheet(size: number, style: StrokeStyle): Sheet {
  const dots = style.length[1] === 0;
  const directions = style.crossFrom === undefined ? 1 : 2;
  const nominal = dots ? style.width * style.width * 0.8 : style.width * style.length[0] * size;
  return {
    size,
    image: new Uint8Array(size * size).fill(255),
    darkness: 0,
    fields: Array.from({ length: directions }, () => new RepulsionField(size, dots)),
    drawn: new Array(directions).fill(0),
    lastGain: 255 * nominal,
  };
}

/** The least crowded of the style's number of proposals, all of one length so that short ones have no advantage. */
function proposeBest(
  { style }: PlacementRequest,
  sheets: Sheet[],
  tone: number,
  level: number,
  target: number,
  next: Random,
): Stroke {
  const sheet = sheets[level];
  const signed = (): number => 2 * next() - 1;
  const length = style.length[0] + (style.length[1] - style.length[0]) * next();
  const width = style.width * (1 + style.widthSpread * signed());
  const across = style.crossFrom !== undefined && target > style.crossFrom && sheet.drawn[1] < sheet.drawn[0];
  let best: Stroke | undefined;
  let bestCrowding = Number.POSITIVE_INFINITY;
  const stroke: Stroke = {
    u: 0,
    v: 0,
    across,
    length,
    slope: 0,
    bow: 0,
    wave: 0,
    width,
    taper: style.taper,
    tone,
    level,
  };
  for (let i = 0; i < style.proposals; i++) {
    stroke.u = next();
    stroke.v = next();
    stroke.slope = style.slope * signed();
    stroke.bow = style.bow * signed();
    stroke.wave = style.wave * signed();
    let crowding = 0;
    for (let finer = level; finer >= 0; finer--) crowding += sheets[finer].fields[across ? 1 : 0].along(stroke);
    if (crowding < bestCrowding) {
      bestCrowding = crowding;
      best = { ...stroke };
    }
  }
  return best!;
}

/** Draws a stroke on one level. Returns the work it took. */
function draw(sheet: Sheet, stroke: Stroke): number {
  const direction = stroke.across ? 1 : 0;
  const area = sheet.size * sheet.size;
  const gain = rasterizeStroke(sheet.image, sheet.size, stroke);
  sheet.darkness += gain;
  sheet.lastGain = gain;
  const own = stroke.width * Math.max(stroke.width, stroke.length * sheet.size);
  sheet.drawn[direction] += own;
  // A few times the mean distance of strokes at this density; the first ones repel across the whole tile.
  const density = sheet.drawn[direction] / area;
  const distance = stroke.length > 0 ? stroke.width / density : stroke.width / Math.sqrt(density);
  return sheet.fields[direction].add(stroke, Math.min(0.5 * sheet.size, 6 * distance)) + own;
}
