import { lightness } from '../../look/vectors.js';
import type { Color } from './WeightedColors.js';

/** A surface with the darkness that its colours have, which may be set to another. */
export interface TonedSurface {
  /** Its mean colour, in linear light, and its share of what is seen. */
  readonly color: Color;
  /** The lightness of its colour behind the filter of the plan. */
  readonly lightness: number;
  /** The surfaces that lie beside it. */
  readonly neighbours: ReadonlySet<number>;
  /** Whether it keeps its darkness, as one of many colours does, or one that makes the lights of the picture. */
  readonly isFixed: boolean;
  darkness: number;
}

/** The least difference of darkness between neighbours, and the greatest darkness. */
interface Limits {
  readonly step: number;
  readonly darkest: number;
}

/** The difference of lightness from which on what is lighter is drawn lighter, where the two lie side by side. */
const CLEARLY_LIGHTER = 0.2;
/** The difference of lightness below which two surfaces look alike. */
const ALIKE = 0.02;
/** What two numbers may differ by and be one. */
const ROUNDING = 1e-9;

/**
 * Gives surfaces that lie side by side tones that differ by a step, in the order from light to dark: each keeps the darkness of its
 * colours where that tells it from its neighbours, or else has the nearest that does. What is clearly lighter than its neighbour stays
 * lighter. One that no darkness would tell apart keeps its own; outlines bound it.
 */
export function tellApart(surfaces: readonly TonedSurface[], { step, darkest }: Limits): void {
  const order = surfaces
    .map((_, i) => i)
    .filter((i) => !surfaces[i].isFixed)
    .sort((a, b) => surfaces[b].lightness - surfaces[a].lightness || a - b);
  const isSet = Uint8Array.from(surfaces, ({ isFixed }) => Number(isFixed));
  for (const i of order) {
    const surface = surfaces[i];
    const beside = [...surface.neighbours]
      .filter((j) => isSet[j] === 1)
      .map((j) => surfaces[j])
      .filter((other) => looksOther(surface, other));
    const isApart = (darkness: number): boolean =>
      beside.every((other) =>
        Math.abs(other.lightness - surface.lightness) >= CLEARLY_LIGHTER
          ? Math.sign(other.lightness - surface.lightness) * (darkness - other.darkness) >= step - ROUNDING
          : Math.abs(darkness - other.darkness) >= step - ROUNDING,
      );
    const own = surface.darkness;
    const found = [own, ...beside.flatMap(({ darkness }) => [darkness + step, darkness - step])]
      .filter((darkness) => darkness >= -ROUNDING && darkness <= darkest + ROUNDING && isApart(darkness))
      .sort((a, b) => Math.abs(a - own) - Math.abs(b - own) || b - a);
    if (found.length > 0) surface.darkness = Math.max(0, found[0]);
    isSet[i] = 1;
  }
}

/** Whether two surfaces differ to the eye: of those in one colour outlines alone tell which is which. */
const looksOther = (a: TonedSurface, b: TonedSurface): boolean =>
  (['r', 'g', 'b'] as const).some((one) => Math.abs(lightness(a.color[one]) - lightness(b.color[one])) > ALIKE);
