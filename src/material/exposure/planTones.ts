import { Box3 } from 'three';
import { SMALL_PARTS, smallAmong } from '../../mesh/smallParts.js';
import type { Samples } from './ExposureFit.js';
import { behind, DARKEST, darknessOf, SPOT, STEP } from './planValues.js';
import { type SeenSurface, SeenSurfaces } from './SeenSurfaces.js';
import { SurfaceTones, surfaceKey } from './SurfaceTones.js';
import type { ValueCurve } from './ToneFit.js';
import { type TonedSurface, tellApart } from './tellApart.js';

/** The standard deviation of a surface's luminance up to which it is of one colour. */
const PLAIN = 0.02;
/** The share of what is seen from which on a surface that is nearly paper makes the lights of the picture, and the darkness up to which it is. */
const LIGHTS = { share: 0.15, darkness: 0.1 };

/** The distance up to which surfaces lie side by side, as a multiple of that between samples. */
const REACH = 2;

/**
 * Plans tones of their own for the surfaces that the curve of a plan would not tell from what lies beside them; null if there are none.
 * Many small parts side by side have the mean tone of all of them: strokes cannot show them one by one.
 *
 * @param samples those of the scene
 */
export function planTones(curve: ValueCurve, samples: Samples): SurfaceTones | null {
  const surfaces = seenAt(samples);
  if (surfaces.all.length < 2) return null;
  const all = surfaces.all.reduce((sum, { weight }) => sum + weight, 0);
  const neighbours = surfaces.neighbours(REACH * samples.spacing);
  const masses = massesOf(surfaces.all, neighbours).filter(
    (members) => members.reduce((sum, i) => sum + surfaces.all[i].weight, 0) >= SPOT * all,
  );
  const massOf = new Map(masses.flatMap((members, mass) => members.map((i) => [i, mass] as const)));
  const toned = masses.map((members, mass) => {
    const beside = members.flatMap((i) => [...neighbours[i]].flatMap((j) => massOf.get(j) ?? []));
    const others = new Set(beside.filter((other) => other !== mass));
    return tonedSurface(
      members.map((i) => surfaces.all[i]),
      curve,
      others,
      all,
    );
  });
  const planned = toned.map(({ darkness }) => darkness);
  tellApart(toned, { step: STEP, darkest: DARKEST });
  const tones = new Map<string, number>();
  for (const [mass, { darkness }] of toned.entries())
    if (darkness !== planned[mass] || masses[mass].length > 1)
      for (const i of masses[mass]) tones.set(surfaces.all[i].key, darkness);
  return tones.size > 0 ? new SurfaceTones(tones) : null;
}

/** The surfaces whose colours make tones, where they are seen. */
function seenAt(samples: Samples): SeenSurfaces {
  const surfaces = new SeenSurfaces();
  const isSmall = smallPlaces(samples);
  samples.visit(({ material, position, color }, seen, place) => {
    if (!(material.colorHatching > 0)) return;
    const isOfSmallParts = isSmall[place] || material.userData[SMALL_PARTS] === true;
    surfaces.add(surfaces.indexOf(surfaceKey(material), isOfSmallParts), position, color, seen);
  });
  return surfaces;
}

/** Which places are those of many small parts. */
function smallPlaces({ counts, visit }: Samples): boolean[] {
  const boxes = counts.map(() => new Box3());
  visit(({ position }, _seen, place) => {
    boxes[place].expandByPoint(position);
  });
  const whole = boxes.reduce((all, box) => all.union(box), new Box3());
  const sizes = boxes.map(({ min, max }) => min.distanceTo(max));
  return smallAmong(sizes, whole.min.distanceTo(whole.max), counts);
}

/** The surfaces that have one tone: each by itself, and those of small parts that lie side by side together. */
function massesOf(surfaces: readonly SeenSurface[], neighbours: readonly ReadonlySet<number>[]): number[][] {
  const isTaken = new Uint8Array(surfaces.length);
  return surfaces.flatMap((surface, first) => {
    if (isTaken[first] === 1) return [];
    isTaken[first] = 1;
    const mass = [first];
    // What is found on the way is looked at in its turn.
    if (surface.isSmall)
      for (const i of mass)
        for (const j of neighbours[i]) {
          if (isTaken[j] === 1 || !surfaces[j].isSmall) continue;
          isTaken[j] = 1;
          mass.push(j);
        }
    return [mass];
  });
}

/** A mass with the mean tone of its surfaces. */
function tonedSurface(
  members: readonly SeenSurface[],
  curve: ValueCurve,
  neighbours: ReadonlySet<number>,
  all: number,
): TonedSurface {
  const sum = (of: (one: SeenSurface) => number): number => members.reduce((total, one) => total + of(one), 0);
  const weight = sum((one) => one.weight);
  const color = { r: sum(({ r }) => r) / weight, g: sum(({ g }) => g) / weight, b: sum(({ b }) => b) / weight };
  const darkness = sum((one) => one.weight * darknessOf(curve, behind(curve.filter, meanColor(one)))) / weight;
  const isOfManyColors = members.length === 1 && variance(members[0]) > PLAIN ** 2;
  const makesLights = darkness <= LIGHTS.darkness && weight >= LIGHTS.share * all;
  const lightness = behind(curve.filter, color);
  return {
    ...{ color: { ...color, weight: weight / all }, lightness, neighbours, darkness },
    isFixed: isOfManyColors || makesLights,
  };
}

const meanColor = ({ r, g, b, weight }: SeenSurface) => ({ r: r / weight, g: g / weight, b: b / weight });

/** The variance of the luminance of a surface. */
function variance(surface: SeenSurface): number {
  const { r, g, b } = meanColor(surface);
  return surface.squares / surface.weight - (0.2126 * r + 0.7152 * g + 0.0722 * b) ** 2;
}
