import { Box3 } from 'three';
import { SMALL_PARTS, smallAmong } from '../../mesh/smallParts.js';
import type { Samples } from './ExposureFit.js';
import { behind, darknessOf, SPOT } from './planValues.js';
import { type SeenSurface, SeenSurfaces } from './SeenSurfaces.js';
import { SurfaceTones, surfaceKey } from './SurfaceTones.js';
import type { ValueCurve } from './ToneFit.js';

/** The distance up to which surfaces lie side by side, as a multiple of that between samples. */
const REACH = 2;

/**
 * Plans tones for many small parts: those that lie side by side have the mean tone of all of them, since strokes cannot show them one by one. Null
 * if there are none.
 *
 * @param samples those of the scene
 */
export function planTones(curve: ValueCurve, samples: Samples): SurfaceTones | null {
  const surfaces = seenAt(samples);
  const { all } = surfaces;
  if (all.length < 2) return null;
  const weight = all.reduce((sum, one) => sum + one.weight, 0);
  const tones = new Map<string, number>();
  for (const members of massesOf(all, surfaces.neighbours(REACH * samples.spacing))) {
    const mass = members.map((i) => all[i]);
    if (mass.length === 1 || weightOf(mass) < SPOT * weight) continue;
    for (const { key } of mass) tones.set(key, meanDarkness(mass, curve));
  }
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

const weightOf = (mass: readonly SeenSurface[]): number => mass.reduce((sum, { weight }) => sum + weight, 0);

const meanDarkness = (mass: readonly SeenSurface[], curve: ValueCurve): number =>
  mass.reduce((sum, { r, g, b, weight }) => {
    const color = { r: r / weight, g: g / weight, b: b / weight };
    return sum + weight * darknessOf(curve, behind(curve.filter, color));
  }, 0) / weightOf(mass);
