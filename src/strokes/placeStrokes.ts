import { drawStroke, type LevelDrawing, nominalArea, startLevel } from './LevelDrawing.js';
import { paperGrain } from './paperGrain.js';
import { type Random, random } from './random.js';
import type { Stroke } from './Stroke.js';
import { MERGING_WIDTHS } from './StrokeDensityField.js';
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

/** The weight of another stroke's end at the same place, relative to the mean density along the stroke. */
const END_WEIGHT = 0.2;

/** The weight of the level that the stroke is chosen for, relative to each finer level, which shows it too. */
const OWN_LEVEL_WEIGHT = 3;

/**
 * Returns the best of `style.proposals` random proposals: the one with the lowest density of other strokes around it. All have the same
 * length, since short strokes would have an advantage.
 *
 * @param levels all levels as drawn so far, the finest first
 * @param pairs whether the copy of the stroke after a half turn (`halfTurn`) is drawn too
 * @param beside the previous stroke of a bundle, beside which it is placed; otherwise its place is free
 */
function proposeStroke(
  style: StrokeStyle,
  levels: readonly LevelDrawing[],
  { tone, level, length, layer, profile }: Pick<Stroke, 'tone' | 'level' | 'length' | 'layer' | 'profile'>,
  pairs: boolean,
  next: Random,
  beside?: Stroke,
): Stroke {
  const signed = (): number => 2 * next() - 1;
  const width = style.width * (1 + style.widthSpread * signed());
  const { across, slope } = style.layers[layer];
  const [least, most] = style.grain?.pressure ?? [1, 1];
  const pressure = least < most ? least + (most - least) * next() : most;
  let best: Stroke | undefined;
  let lowestCost = Number.POSITIVE_INFINITY;
  const stroke: Stroke = {
    u: 0,
    v: 0,
    layer,
    across,
    length,
    slope: 0,
    bow: 0,
    wave: 0,
    profile,
    width,
    taper: style.taper,
    pressure,
    tone,
    level,
  };
  // Freely placed arcs would nest in columns; a random place along the arc prevents that.
  const place = style.hand?.isCurved ? next() : undefined;
  const bundleTiles = (style.hand?.bundleSpacing ?? 0) / levels[level].size;
  for (let i = 0; i < style.proposals; i++) {
    stroke.u = next();
    stroke.v = next();
    if (place !== undefined) {
      if (across) stroke.v = nearPlace(place, length, stroke.v);
      else stroke.u = nearPlace(place, length, stroke.u);
    }
    if (beside) moveBeside(stroke, beside, bundleTiles);
    stroke.slope = style.hand ? tilted(slope, style.hand.angleSpread, signed) : slope + style.slope * signed();
    stroke.bow = style.bow * signed();
    stroke.wave = style.wave * signed();
    let cost = pairs ? pairCost(stroke, slope, levels) : 0;
    for (let finer = level; finer >= 0; finer--) {
      const { densities, ends } = levels[finer];
      const weight = finer === level ? OWN_LEVEL_WEIGHT : 1;
      cost += weight * densities[layer].meanAlong(stroke);
      if (ends.length > 0) cost += weight * END_WEIGHT * ends[layer].atEnds(stroke);
    }
    if (cost < lowestCost) {
      lowestCost = cost;
      best = { ...stroke };
    }
  }
  return best!;
}

/** The stroke after a half turn about the origin. The result is exact, because the generator's numbers are multiples of 2⁻³². */
export const halfTurn = (stroke: Stroke): Stroke => ({
  ...stroke,
  u: 1 - stroke.u,
  v: 1 - stroke.v,
  bow: -stroke.bow,
  profile: stroke.profile?.turned,
});

/** The relative unevenness of the distances in a bundle. */
const BUNDLE_SPREAD = 0.2;

/** Moves a stroke of a bundle beside the previous one; its random position decides where and on which side. */
function moveBeside(stroke: Stroke, beside: Stroke, spacing: number): void {
  const [along, across] = stroke.across ? [stroke.v, stroke.u] : [stroke.u, stroke.v];
  const [sideChance, distanceChance] = [Math.floor(2 * across), (2 * across) % 1];
  const distance = spacing * (1 + BUNDLE_SPREAD * (2 * distanceChance - 1));
  // Neighbours lie across the layer; this is the distance of their middles along the other axis.
  const sideways = distance * Math.sqrt(1 + beside.slope * beside.slope) * (2 * sideChance - 1);
  const newAlong = nearPlace(stroke.across ? beside.v : beside.u, stroke.length, along);
  const moved = newAlong - (stroke.across ? beside.v : beside.u);
  const forward = moved - Math.round(moved);
  const newAcross = (stroke.across ? beside.u : beside.v) + sideways + forward * beside.slope;
  const wrapped = toGrid(newAcross);
  stroke.u = stroke.across ? wrapped : newAlong;
  stroke.v = stroke.across ? newAlong : wrapped;
}

/** Largest move of a curved stroke along itself, as a share of its length. */
const NEAR = 0.15;

/** A place a little before or behind another, both 0 to 1. `chance` is from 0 to 1. */
function nearPlace(place: number, length: number, chance: number): number {
  return toGrid(place + NEAR * length * (2 * chance - 1));
}

/** A place on the torus, as a multiple of 2⁻³², which the generator's numbers are: it is exact after a half turn. */
const toGrid = (place: number): number => Math.round((place - Math.floor(place)) * 2 ** 32) / 2 ** 32;

/**
 * The slope of a stroke of a hand: that of its layer, turned by an angle of this standard deviation. Three random numbers from −1 to 1
 * have a sum whose variance is 1.
 */
function tilted(slope: number, angleSpread: number, signed: () => number): number {
  const angle = angleSpread * (signed() + signed() + signed());
  const tangent = angle * (1 + (angle * angle) / 3);
  return (slope + tangent) / (1 - slope * tangent);
}

/**
 * The density that a stroke and its copy after a half turn, which is parallel to it, add to each other on all levels that show
 * them. Each term is that of `StrokeDensityField`. All levels have the same weight here, since otherwise the middle of the tile
 * would stay empty.
 */
function pairCost(stroke: Stroke, slope: number, levels: readonly LevelDrawing[]): number {
  const apart = (place: number): number => 2 * place - Math.round(2 * place);
  const forward = apart(stroke.across ? stroke.v : stroke.u);
  const sideways = (apart(stroke.across ? stroke.u : stroke.v) - slope * forward) / Math.sqrt(1 + slope * slope);
  const overlap = stroke.length > 0 ? Math.max(0, 1 - Math.abs(forward) / stroke.length) : 1;
  const beyond = stroke.length > 0 ? 0 : forward;
  let cost = 0;
  for (let level = stroke.level; level >= 0; level--) {
    const widths = levels[level].size / stroke.width;
    const distance2 = (sideways * sideways + beyond * beyond) * widths * widths;
    const merging = Math.max(0, 1 - distance2 / (MERGING_WIDTHS * MERGING_WIDTHS));
    const spreading = Math.sqrt(1 + distance2);
    cost += 1 / (spreading * Math.sqrt(spreading)) + merging * merging;
  }
  return overlap * cost;
}
