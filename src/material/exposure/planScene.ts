import { behind, DARKEST, darknessOf, planValues, SPOT, STEP, type WeightedColors } from './planValues.js';
import type { SeenSurface, SeenSurfaces } from './SeenSurfaces.js';
import { SurfaceTones } from './SurfaceTones.js';
import type { ValueCurve, ValuePlan } from './ToneFit.js';
import { type TonedSurface, tellApart } from './tellApart.js';

/** The standard deviation of a surface's luminance up to which it is of one colour. */
const PLAIN = 0.02;
/** The share of what is seen from which on a surface that is nearly paper makes the lights of the picture, and the darkness up to which it is. */
const LIGHTS = { share: 0.25, darkness: 0.05 };

/**
 * Plans the values of a scene: the curve from its colours to darkness, and tones of their own for surfaces that it would not tell from
 * what lies beside them.
 *
 * @param reach the distance up to which surfaces lie side by side
 */
export function planScene(colors: WeightedColors, surfaces: SeenSurfaces, reach: number): ValuePlan {
  const curve = planValues(colors.means);
  const all = surfaces.all.reduce((sum, { weight }) => sum + weight, 0);
  const masses = surfaces.all
    .map((surface, i) => ({ surface, i }))
    .filter(({ surface }) => surface.weight >= SPOT * all);
  if (masses.length < 2) return { ...curve, tones: null };
  const neighbours = surfaces.neighbours(reach);
  const places = new Map(masses.map(({ i }, place) => [i, place]));
  const toned = masses.map(({ surface, i }) => {
    const beside = [...neighbours[i]].flatMap((j) => places.get(j) ?? []);
    return tonedSurface(surface, curve, new Set(beside), all);
  });
  const planned = toned.map(({ darkness }) => darkness);
  tellApart(toned, { step: STEP, darkest: DARKEST });
  const tones = new Map<string, number>();
  for (const [place, { darkness }] of toned.entries())
    if (darkness !== planned[place]) tones.set(masses[place].surface.key, darkness);
  return { ...curve, tones: tones.size > 0 ? new SurfaceTones(tones) : null };
}

function tonedSurface(
  { r, g, b, weight, squares }: SeenSurface,
  curve: ValueCurve,
  neighbours: ReadonlySet<number>,
  all: number,
): TonedSurface {
  const color = { r: r / weight, g: g / weight, b: b / weight, weight: weight / all };
  const luminance = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
  const isOfManyColors = squares / weight - luminance ** 2 > PLAIN ** 2;
  const lightness = behind(curve.filter, color);
  const darkness = darknessOf(curve, lightness);
  const makesLights = darkness <= LIGHTS.darkness && color.weight >= LIGHTS.share;
  return { color, lightness, neighbours, isFixed: isOfManyColors || makesLights, darkness };
}
