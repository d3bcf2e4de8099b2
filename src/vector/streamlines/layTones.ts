import { mix, smoothstep, type Vec3 } from '../../look/vectors.js';
import type { EngravedPlace, Engraver, FamilyName } from '../Engraver.js';
import { drawnShareOf } from '../lineMarks.js';
import { leftOf, otherShare } from '../shading/crossedTones.js';
import type { CutReading } from '../shading/lineFunctions.js';
import type { Tones } from '../ToneReader.js';

/** Sets of lines that are laid over one another, in order, with the layers that they belong to. Families that take turns over a surface are one set. */
export const LAYS = [
  { name: 'first', layer: 'lines' },
  { name: 'cross', layer: 'crossing' },
  { name: 'third', layer: 'crossing' },
  { name: 'shadow', layer: 'shadows' },
] as const;
export type Lay = (typeof LAYS)[number];
export type LayName = Lay['name'];

/** The lines of one set at a place. */
export interface LaidTone {
  /** The tone that they print. */
  tone: number;
  /** The tone of their whole length, with the gaps between strokes. */
  density: number;
  /** The gradient of the function whose level lines they run along. */
  gradient: Vec3;
}

/** Tones above this one are drawn as this one: the lines of a pen get no closer. */
const MOST = 0.95;
/** Tones between which lines that cross give way, so that a solid dark is drawn once. */
const SOLID = [0.87, 0.95] as const;
/** The share of the first family below which those that cross it take its place, and that of side B. */
const HALF = 0.5;

/** The tone of two sets that are printed over one another. */
const over = (a: number, b: number): number => 1 - (1 - a) * (1 - b);

/** The family of a set whose turn it is at a place. cut: null for lines that follow the form. */
export function familyOf(lay: LayName, cut: CutReading | null): FamilyName {
  const { firstShare, shareB } = cut ?? { firstShare: 1, shareB: 1 };
  if (lay === 'first' && firstShare >= HALF) return 'first';
  if (lay === 'first' || lay === 'cross') return shareB < HALF ? 'crossC' : 'crossB';
  return otherShare(shareB, firstShare) < HALF ? `${lay}C` : `${lay}B`;
}

/** The layer of the lines of a set at a place: where others take the place of the first family, theirs. */
export function layerOf({ name, layer }: Lay, cut: CutReading | null): Lay['layer'] {
  return name === 'first' && familyOf(name, cut) !== 'first' ? 'crossing' : layer;
}

/** Whether lines of a set may be drawn. */
export const hasLay = ({ families }: Engraver, name: LayName): boolean =>
  name === 'first' || families.includes(`${name}B`);

/** The lines of every set at a place; null for sets that the surface does not have. */
export function layTones(engraver: Engraver, at: EngravedPlace, tones: Tones): (LaidTone | null)[] {
  const { families } = engraver;
  const toneOf = (family: FamilyName): number =>
    families.includes(family) ? engraver.measure(family, at, tones).tone : 0;
  const bothOf = (lay: 'cross' | 'third' | 'shadow'): number => over(toneOf(`${lay}B`), toneOf(`${lay}C`));
  const [first, cross] = [toneOf('first'), bothOf('cross')];
  // Where the first family runs along the surface, one set of lines has all of its tone.
  const alone = first + (1 - (at.cut?.firstShare ?? 1)) * (over(first, cross) - first);
  const [third, shadow] = [bothOf('third'), bothOf('shadow')];
  const all = over(over(first, cross), over(third, shadow));
  const solid = smoothstep(...SOLID, all);
  const of: Record<LayName, number> = {
    first: mix(alone, all, solid),
    cross: (1 - solid) * leftOf(over(first, cross), alone),
    third: (1 - solid) * third,
    shadow: (1 - solid) * shadow,
  };
  return LAYS.map(({ name }): LaidTone | null => {
    const family = familyOf(name, at.cut);
    if (!hasLay(engraver, name)) return null;
    const tone = of[name];
    const density = tone / drawnShareOf({ ...engraver.measure(family, at, tones), tone });
    return { tone, density: Math.min(density, MOST), gradient: engraver.gradientAt(family, at) };
  });
}
