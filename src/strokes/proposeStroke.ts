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
 * Returns the best of `style.proposals` random proposals: the one with the lowest density of other strokes around it. All have the
 * same length, because short strokes would have an advantage.
 *
 * @param levels all levels as drawn so far, the finest first
 * @param pairs whether the copy of the stroke after a half turn (`halfTurn`) will be drawn too
 */
export function proposeStroke(
  style: StrokeStyle,
  levels: readonly LevelDrawing[],
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
});

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
