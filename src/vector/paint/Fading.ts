import { combined, type Vec3 } from '../../look/vectors.js';
import type { Bvh } from '../Bvh.js';
import type { Projection } from '../Projection.js';
import type { VeilTone } from './VeilTone.js';

/** Triangles of the scene that belong to a see-through surface. */
export interface Veil {
  /** The first of them, and the first after them. */
  first: number;
  end: number;
  /** The share that is left of what lies behind one of them. */
  left: number;
}

/** Two places on a way are one if they lie no further apart than this share of it: edges belong to two triangles. */
const SAME = 1e-9;
/** Shares that differ by less are one. */
const STEPS = 1000;
/** So little is nothing. */
const LEAST = 0.02;

/** What is met of a veil, and where. */
interface MetVeil {
  veil: Veil;
  triangle: number;
  place: number;
}

/** Knows what see-through surfaces leave of what lies behind them. */
export class Fading {
  /**
   * @param above how far above surfaces rays begin, world units
   * @param tones what veils print themselves, of those that print anything
   */
  constructor(
    private readonly bvh: Bvh,
    private readonly projection: Projection,
    private readonly veils: readonly Veil[],
    private readonly above: number,
    private readonly tones: readonly VeilTone[],
  ) {}

  /** Whether there is any such surface. */
  get isThere(): boolean {
    return this.veils.length > 0;
  }

  /** The share that is left of a place, from 0 to 1. triangle: the one that it lies on; −1 for none. */
  leftOf(world: Vec3, triangle: number): number {
    if (!this.isThere) return 1;
    const left = this.meet(world, triangle).reduce((share, { veil }) => share * veil.left, 1);
    return left < LEAST ? 0 : Math.round(STEPS * left) / STEPS;
  }

  /**
   * How many times as wide lines behind veils are drawn: what veils print covers some of them, where the canvas adds the inks. With a share
   * `t` printed over it, what is left of the ink is drawn over 1 − t times.
   */
  deepening(world: Vec3, triangle: number): number {
    if (this.tones.length === 0) return 1;
    const { way } = this.projection.wayToEye(...world);
    let factor = 1;
    for (const { veil, triangle: other, place } of this.meet(world, triangle)) {
      const printed =
        this.tones.find(({ first }) => first === veil.first)?.at(other, combined(1, world, place, way)) ?? 0;
      factor /= Math.max(1 - printed, veil.left);
    }
    return factor;
  }

  private meet(world: Vec3, triangle: number): MetVeil[] {
    const { way, end } = this.projection.wayToEye(...world);
    const met: MetVeil[] = [];
    this.bvh.eachFading(world, way, this.above / Math.hypot(...way), end, triangle, (other, place) => {
      const veil = this.veils.find(({ first, end: last }) => other >= first && other < last);
      if (veil && !met.some((one) => one.veil === veil && Math.abs(one.place - place) < SAME))
        met.push({ veil, triangle: other, place });
    });
    return met;
  }
}
