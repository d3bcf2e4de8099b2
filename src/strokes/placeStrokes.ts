import { type PaperGrain, paperGrain } from './paperGrain.js';
import { type Random, random } from './random.js';
import { rasterizeStroke } from './rasterizeStroke.js';
import type { Stroke } from './Stroke.js';
import { MERGING_WIDTHS, StrokeDensityField } from './StrokeDensityField.js';
import { StrokeEndField } from './StrokeEndField.js';
import type { StrokeStyle } from './strokeStyles.js';

/** What to draw. */
export interface PlacementRequest {
  style: StrokeStyle;
  seed: number;
  /** Texels per side of the finest level. */
  size: number;
  tones: number;
  levels: number;
  /**
   * Whether every stroke comes with its mirror image in the middle of the tile (a half turn), right after it; the map is
   * then the same upside down.
   */
  pairs?: boolean | undefined;
}

/** Cells read or written between two reports of progress: about a millisecond's work. */
const WORK_PER_SLICE = 100_000;

/** What one other end at the place of a stroke's end counts, beside the mean crowding along the stroke. */
const END_WEIGHT = 0.2;

/** How much more the level for which a stroke is chosen counts than each finer one, on which it will also be seen. */
const OWN_LEVEL_WEIGHT = 3;

/** Strokes act on each other across so many times their mean distance: lines, their ends, and dots. */
const LINE_REACH = 6;
const END_REACH = 4;
const DOT_REACH = 3;

/** Strokes shorter than this, in tiles, are no lines: where they end does not matter. */
const SHORT = 0.15;

/** Cells that a proposal reads in one level, about. */
const CELLS_PER_PROPOSAL = 16;

/** One level while it is being drawn. */
interface Sheet {
  size: number;
  image: Uint8Array;
  /** 255·ink, summed over the image. */
  darkness: number;
  /** What its strokes are drawn on, where that has grain. */
  grain: PaperGrain | undefined;
  /** For each layer of the style. */
  crowding: StrokeDensityField[];
  /** Nearness of stroke ends, likewise; empty for short strokes. */
  ends: StrokeEndField[];
  /** Ink drawn so far in each layer, overlaps counted again: what keeps the layers in step. */
  drawn: number[];
  /** Part of the last stroke that fell on paper: what remained of it after overlaps. */
  gain: number;
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
  const { style, size, tones, levels, pairs = false } = request;
  const copies = pairs ? 2 : 1;
  const next = random(request.seed);
  const sheets = Array.from({ length: levels }, (_, level) =>
    createSheet(size >> level, style, paperGrain(request, level)),
  );
  const strokes: Stroke[] = [];
  let work = 0;
  for (let tone = 1; tone < tones; tone++) {
    const target = (style.maxInk * tone) / (tones - 1);
    for (let level = levels - 1; level >= 0; level--) {
      const sheet = sheets[level];
      const goal = 255 * sheet.size * sheet.size * target;
      const start = sheet.darkness;
      const least = copies * nominalArea(style.width, style.length[0], sheet.size);
      while (goal - sheet.darkness > 0.5 * 255 * sheet.gain * least) {
        const length = chooseLength(style, sheet, (goal - sheet.darkness) / copies, next);
        const layer = chooseLayer(style, sheet, target);
        const stroke = proposeBest(style, sheets, { tone, level, length, layer }, pairs, next);
        const drawn = pairs ? [stroke, halfTurn(stroke)] : [stroke];
        strokes.push(...drawn);
        work += style.proposals * (level + 1) * CELLS_PER_PROPOSAL;
        for (let finer = level; finer >= 0; finer--) {
          for (const one of drawn) work += draw(sheets[finer], one);
        }
        if (work >= WORK_PER_SLICE) {
          work = 0;
          yield (tone - 1 + levelProgress(level, (sheet.darkness - start) / (goal - start))) / (tones - 1);
        }
      }
    }
  }
  return strokes;
}

/** Progress within a tone when `part` of a level is done: each level takes four times the work of the next coarser one. */
function levelProgress(level: number, part: number): number {
  const before = 1 / 4 ** (level + 1);
  return before + (4 * before - before) * Math.min(1, part);
}

function createSheet(size: number, style: StrokeStyle, grain: PaperGrain | undefined): Sheet {
  const { layers } = style;
  const short = style.length[1] < SHORT;
  return {
    size,
    image: new Uint8Array(size * size).fill(255),
    darkness: 0,
    grain,
    crowding: layers.map(({ slope }) => new StrokeDensityField(size, short, slope)),
    ends: short ? [] : layers.map(() => new StrokeEndField(size)),
    drawn: layers.map(() => 0),
    gain: 1,
  };
}

/** Texels that a stroke inks on clean paper, nearly. */
const nominalArea = (width: number, length: number, size: number): number => width * Math.max(width, length * size);

/** A length at random, but no longer than it takes to reach the level's mean: the last stroke ends on target. */
function chooseLength(style: StrokeStyle, sheet: Sheet, missing: number, next: Random): number {
  const [shortest, longest] = style.length;
  const length = shortest + (longest - shortest) * next();
  const needed = missing / (255 * sheet.gain * style.width * sheet.size);
  return Math.max(shortest, Math.min(length, needed));
}

/** Of the layers that this ink has, the one with the least ink so far. */
function chooseLayer({ layers }: StrokeStyle, { drawn }: Sheet, target: number): number {
  let chosen = 0;
  for (let i = 1; i < layers.length; i++) if (target > layers[i].from && drawn[i] < drawn[chosen]) chosen = i;
  return chosen;
}

/** The least crowded of the style's number of proposals, all of one length so that short ones have no advantage. */
function proposeBest(
  style: StrokeStyle,
  sheets: Sheet[],
  { tone, level, length, layer }: Pick<Stroke, 'tone' | 'level' | 'length' | 'layer'>,
  pairs: boolean,
  next: Random,
): Stroke {
  const signed = (): number => 2 * next() - 1;
  const width = style.width * (1 + style.widthSpread * signed());
  const { across, slope } = style.layers[layer];
  const [least, most] = style.grain?.pressure ?? [1, 1];
  const pressure = least < most ? least + (most - least) * next() : most;
  let best: Stroke | undefined;
  let bestCrowding = Number.POSITIVE_INFINITY;
  const stroke: Stroke = {
    u: 0,
    v: 0,
    layer,
    across,
    length,
    slope: 0,
    bow: 0,
    wave: 0,
    width,
    taper: style.taper,
    pressure,
    tone,
    level,
  };
  for (let i = 0; i < style.proposals; i++) {
    stroke.u = next();
    stroke.v = next();
    stroke.slope = slope + style.slope * signed();
    stroke.bow = style.bow * signed();
    stroke.wave = style.wave * signed();
    let crowding = pairs ? mutualCrowding(stroke, slope, sheets) : 0;
    for (let finer = level; finer >= 0; finer--) {
      const { crowding: field, ends } = sheets[finer];
      const weight = finer === level ? OWN_LEVEL_WEIGHT : 1;
      crowding += weight * field[layer].along(stroke);
      if (ends.length > 0) crowding += weight * END_WEIGHT * ends[layer].atEnds(stroke);
    }
    if (crowding < bestCrowding) {
      bestCrowding = crowding;
      best = { ...stroke };
    }
  }
  return best!;
}

/** The stroke after a half turn about the origin. Exact: the generator's numbers are multiples of 2⁻³². */
const halfTurn = (stroke: Stroke): Stroke => ({ ...stroke, u: 1 - stroke.u, v: 1 - stroke.v, bow: -stroke.bow });

/**
 * How much a stroke and its own half turn, which is parallel to it, crowd each other on all the levels that show them:
 * each term is that of `StrokeDensityField`. The own level counts no more than others, or the middle of the tile stays empty.
 */
function mutualCrowding(stroke: Stroke, slope: number, sheets: readonly Sheet[]): number {
  const apart = (place: number): number => 2 * place - Math.round(2 * place);
  const forward = apart(stroke.across ? stroke.v : stroke.u);
  const sideways = (apart(stroke.across ? stroke.u : stroke.v) - slope * forward) / Math.sqrt(1 + slope * slope);
  const overlap = stroke.length > 0 ? Math.max(0, 1 - Math.abs(forward) / stroke.length) : 1;
  const beyond = stroke.length > 0 ? 0 : forward;
  let crowding = 0;
  for (let level = stroke.level; level >= 0; level--) {
    const widths = sheets[level].size / stroke.width;
    const distance2 = (sideways * sideways + beyond * beyond) * widths * widths;
    const merging = Math.max(0, 1 - distance2 / (MERGING_WIDTHS * MERGING_WIDTHS));
    const spreading = Math.sqrt(1 + distance2);
    crowding += 1 / (spreading * Math.sqrt(spreading)) + merging * merging;
  }
  return overlap * crowding;
}

/** Draws a stroke on one level. Returns the work it took. */
function draw(sheet: Sheet, stroke: Stroke): number {
  const { layer } = stroke;
  const area = sheet.size * sheet.size;
  const gain = rasterizeStroke(sheet.image, sheet.size, stroke, sheet.grain);
  sheet.darkness += gain;
  const own = nominalArea(stroke.width, stroke.length, sheet.size);
  sheet.gain = Math.min(1, gain / (255 * own));
  sheet.drawn[layer] += own;
  // A few times the mean distance of strokes at this density; the first ones repel across the whole tile.
  const density = sheet.drawn[layer] / area;
  const distance = stroke.length > 0 ? stroke.width / density : stroke.width / Math.sqrt(density);
  const reach = (times: number): number => Math.min(0.5 * sheet.size, times * distance);
  let work = own + sheet.crowding[layer].add(stroke, reach(stroke.length > 0 ? LINE_REACH : DOT_REACH));
  if (sheet.ends.length > 0) work += sheet.ends[layer].add(stroke, reach(END_REACH));
  return work;
}
