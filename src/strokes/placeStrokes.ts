import { drawStroke, type LevelDrawing, nominalArea, startLevel } from './LevelDrawing.js';
import { paperGrain } from './paperGrain.js';
import { halfTurn, proposeStroke } from './proposeStroke.js';
import { type Random, random } from './random.js';
import type { Stroke } from './Stroke.js';
import type { HandShapes, StrokeStyle } from './StrokeStyle.js';

/** The input of `placeStrokes`. */
export interface PlacementRequest {
  style: StrokeStyle;
  seed: number;
  /** Texels per side of the finest level. */
  size: number;
  tones: number;
  levels: number;
  /**
   * Whether every stroke is followed by its copy after a half turn about the middle of the tile, so that the map looks the same upside
   * down.
   */
  pairs?: boolean | undefined;
}

/** Cells read or written between two yields, in about a millisecond. */
const WORK_PER_SLICE = 100_000;

/** Largest ink of the last stroke of a hand, as a share of the ink of the level; at most half of it is missing. */
const INK_OF_LAST = 0.015;

/** The approximate number of cells that a proposal reads in one level. */
const CELLS_PER_PROPOSAL = 16;

/**
 * Chooses the strokes of a tonal art map greedily, as Praun et al. 2001 do: tones from light to dark, within a tone levels from
 * coarse to fine, and each stroke as the best of many random proposals, until the level has its mean ink. A stroke that is chosen
 * for a level is drawn on every finer level too, and stays in every darker tone: that is the nesting property.
 *
 * It uses only arithmetic that IEEE 754 rounds exactly, so the same request gives the same strokes on every machine.
 *
 * @returns the strokes in order of drawing; yields progress in [0, 1]
 */
export function* placeStrokes(request: PlacementRequest): Generator<number, Stroke[], void> {
  const { style, size, tones, levels, pairs = false } = request;
  const copies = pairs ? 2 : 1;
  const next = random(request.seed);
  const drawings = Array.from({ length: levels }, (_, level) =>
    startLevel(size >> level, style, paperGrain(request, level)),
  );
  const strokes: Stroke[] = [];
  let work = 0;
  for (let tone = 1; tone < tones; tone++) {
    const target = (style.maxInk * tone) / (tones - 1);
    for (let level = levels - 1; level >= 0; level--) {
      const drawing = drawings[level];
      const goal = 255 * drawing.size * drawing.size * target;
      const start = drawing.darkness;
      const shortest = shortestOf(style, drawing.size);
      const least = copies * nominalArea(style.width, shortest, drawing.size);
      while (goal - drawing.darkness > 0.5 * 255 * drawing.gain * least) {
        const layer = chooseLayer(style, drawing, target);
        const missing = (goal - drawing.darkness) / copies;
        const chosen = style.hand
          ? chooseShape(style.hand, style, layer, drawing, shortest, missing, next)
          : { length: chooseLength(style, drawing, missing, next), profile: undefined };
        const isBundled = style.hand !== undefined && style.hand.bundled > 0 && next() < style.hand.bundled;
        const beside = isBundled ? drawing.last[layer] : undefined;
        const stroke = proposeStroke(style, drawings, { tone, level, layer, ...chosen }, pairs, next, beside);
        drawing.last[layer] = stroke;
        const added = pairs ? [stroke, halfTurn(stroke)] : [stroke];
        strokes.push(...added);
        work += style.proposals * (level + 1) * CELLS_PER_PROPOSAL;
        for (let finer = level; finer >= 0; finer--) {
          for (const addedStroke of added) work += drawStroke(drawings[finer], addedStroke);
        }
        if (work >= WORK_PER_SLICE) {
          work = 0;
          yield (tone - 1 + levelProgress(level, (drawing.darkness - start) / (goal - start))) / (tones - 1);
        }
      }
    }
  }
  return strokes;
}

/** The progress within a tone when `part` of a level is done. Each level takes four times the work of the next coarser level. */
function levelProgress(level: number, part: number): number {
  const before = 1 / 4 ** (level + 1);
  return before + (4 * before - before) * Math.min(1, part);
}

/** The shortest stroke of a level, in tiles. A stroke of a hand is shortened only where half of it would show in the mean of the tone. */
const shortestOf = ({ hand, length, width }: StrokeStyle, size: number): number =>
  hand ? Math.min(length[0], (INK_OF_LAST * size) / width) : length[0];

/** A random length, limited by the ink that the level still needs, so that the last stroke hits the target. */
function chooseLength(style: StrokeStyle, drawing: LevelDrawing, missing: number, next: Random): number {
  const [shortest, longest] = style.length;
  const length = shortest + (longest - shortest) * next();
  const needed = missing / (255 * drawing.gain * style.width * drawing.size);
  return Math.max(shortest, Math.min(length, needed));
}

/** Chooses a stroke of a hand, and its length. */
function chooseShape(
  { shapes, scaleSpread, mirror }: HandShapes,
  style: StrokeStyle,
  layer: number,
  drawing: LevelDrawing,
  shortest: number,
  missing: number,
  next: Random,
): Pick<Stroke, 'length' | 'profile'> {
  const { length, profile } = shapes[Math.floor(shapes.length * next())];
  const { across, slope } = style.layers[layer];
  const scaled = length * (1 + scaleSpread * (2 * next() - 1));
  const needed = missing / (255 * drawing.gain * style.width * drawing.size);
  // Along v, the sideways axis points to the right.
  const isMirrored = across !== (mirror && next() < 0.5);
  return {
    // The length of a stroke is measured along its axis.
    length: Math.max(Math.min(shortest, scaled), Math.min(scaled, needed)) / Math.sqrt(1 + slope * slope),
    profile: isMirrored ? profile.mirrored : profile,
  };
}

/** Chooses the layer with the least ink among those that have begun at this mean ink. */
function chooseLayer({ layers }: StrokeStyle, { drawn }: LevelDrawing, target: number): number {
  let chosen = 0;
  for (let i = 1; i < layers.length; i++) if (target > layers[i].from && drawn[i] < drawn[chosen]) chosen = i;
  return chosen;
}
