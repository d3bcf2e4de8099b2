import { isInk, type SurfaceImage } from './SurfaceImage.js';

/**
 * M5: the share of surface pixels that turn from ink to paper or back between two pictures of the same view, divided by what
 * it would be for two pictures that have nothing to do with each other, 2p(1 − p) at a share p of ink. 0 is frozen, 1 is noise.
 */
export function normalisedFlips(before: SurfaceImage, after: SurfaceImage): number {
  const count = new FlipCount();
  for (let i = 0; i < before.luminance.length; i++) {
    if (before.surface[i] !== 0 && after.surface[i] !== 0) {
      count.add(isInk(before.luminance[i]), isInk(after.luminance[i]));
    }
  }
  return count.normalised();
}

/** Counts pairs of ink bits. */
export class FlipCount {
  #all = 0;
  #ink = 0;
  #flips = 0;

  add(before: boolean, after: boolean): void {
    this.#all++;
    this.#ink += (before ? 0.5 : 0) + (after ? 0.5 : 0);
    if (before !== after) this.#flips++;
  }

  /** NaN where nothing was counted or nothing is drawn. */
  normalised(): number {
    const p = this.#ink / this.#all;
    return this.#flips / this.#all / (2 * p * (1 - p));
  }
}
