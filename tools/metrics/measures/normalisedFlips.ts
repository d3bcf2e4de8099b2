import { isInk, type SurfaceImage } from './SurfaceImage.js';

/**
 * M5: the share of surface pixels that change from ink to paper or back between two pictures of the same view, divided by the
 * share for two unrelated pictures, 2p(1 − p) where p is the share of ink. 0: nothing changes. 1: noise.
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

/** Compares pixels of two pictures, given as ink or not ink. */
export class FlipCount {
  private all = 0;
  private ink = 0;
  private flips = 0;

  add(before: boolean, after: boolean): void {
    this.all++;
    this.ink += (before ? 0.5 : 0) + (after ? 0.5 : 0);
    if (before !== after) this.flips++;
  }

  /** NaN where nothing was counted or nothing is drawn. */
  normalised(): number {
    const p = this.ink / this.all;
    return this.flips / this.all / (2 * p * (1 - p));
  }
}
