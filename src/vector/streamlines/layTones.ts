import { smoothstep, type Vec3 } from '../../look/vectors.js';
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

/** The distance of lines that fill the black of a woodcut, in widths of the pen: they overlap, so that no slits are left. */
const FILL_PITCH = 0.85;
/** Tones above this one are drawn as this one: the lines of a pen get no closer. */
const MOST = 0.95;
/** Tones between which sets give way to one, so that a solid dark is drawn once; and tones up to which a shadow falls on light. */
const SOLID = [0.87, 0.95] as const;
const LIGHT = [0.05, 0.3] as const;
/** Shares of the paper that three sets cover, between which one gives way. */
const THREEFOLD = [0.01, 0.05] as const;
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

/**
 * The tones of sets with at most two of them over one another: where a third one would cross both, a set gives way, and the first takes its tone.
 * Those of shadows stay, since they tell them apart. A solid dark is drawn by one set: the first, or that of shadows where they fall on light.
 */
function onDryPaper({ first, cross, third, shadow }: Record<LayName, number>): Record<LayName, number> {
  const all = over(over(first, cross), over(third, shadow));
  const solid = smoothstep(...SOLID, all);
  const byFirst = solid * smoothstep(...LIGHT, first + 1 - shadow);
  const leftFor = (tone: number, others: number): number =>
    (1 - solid) * (1 - smoothstep(...THREEFOLD, tone * others * first)) * tone;
  const thirdLeft = leftFor(third, Math.max(cross, shadow));
  const crossLeft = leftFor(cross, over(thirdLeft, shadow));
  const shadowLeft = (1 - byFirst) * shadow;
  const others = over(over(thirdLeft, crossLeft), shadowLeft);
  const firstLeft = (1 - (solid - byFirst)) * Math.max(leftOf(all, others), first);
  return { first: firstLeft, cross: crossLeft, third: thirdLeft, shadow: shadowLeft };
}

/** The lines of every set at a place; null for sets that the surface does not have. */
export function layTones(engraver: Engraver, at: EngravedPlace, tones: Tones): (LaidTone | null)[] {
  const { families } = engraver;
  const toneOf = (family: FamilyName): number => (families.includes(family) ? engraver.toneAt(family, at, tones) : 0);
  const bothOf = (lay: 'cross' | 'third' | 'shadow'): number => over(toneOf(`${lay}B`), toneOf(`${lay}C`));
  const [first, cross] = [toneOf('first'), bothOf('cross')];
  // Where the first family runs along the surface, one set of lines has all of its tone.
  const alone = first + (1 - (at.cut?.firstShare ?? 1)) * (over(first, cross) - first);
  const of = onDryPaper({
    first: alone,
    cross: leftOf(over(first, cross), alone),
    third: bothOf('third'),
    shadow: bothOf('shadow'),
  });
  return LAYS.map(({ name }): LaidTone | null => {
    const family = familyOf(name, at.cut);
    if (!hasLay(engraver, name)) return null;
    const tone = of[name];
    if (engraver.technique === 'woodcut')
      return { tone, density: tone > 0 ? 1 / FILL_PITCH : 0, gradient: engraver.gradientAt(family, at) };
    const isWhole = tone === 0 || engraver.technique === 'engraving';
    const density = isWhole ? tone : tone / drawnShareOf({ ...engraver.measure(family, at, tones), tone });
    return { tone, density: Math.min(density, MOST), gradient: engraver.gradientAt(family, at) };
  });
}
