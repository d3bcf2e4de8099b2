import type { LevelDrawing } from './LevelDrawing.js';
import type { Random } from './random.js';
import type { Stroke } from './Stroke.js';
import { MERGING_WIDTHS } from './StrokeDensityField.js';
import type { StrokeStyle } from './StrokeStyle.js';

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
export function proposeStroke(
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
