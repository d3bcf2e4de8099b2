import { blurToroidal } from './blurToroidal.js';
import { random } from './random.js';
import { sortedIndices } from './ranking.js';
import type { StrokeStyle } from './StrokeStyle.js';

/** The grain of the paper under one level. Pencil and charcoal mark its peaks first. */
export interface PaperGrain {
  /**
   * size² bytes in rows of growing v, evenly distributed: from 0, a peak that every stroke marks, to 255, a valley that only
   * the strongest pressure reaches. Unchanged by a half turn.
   */
  depths: Uint8Array;
  /** Texels over which a stroke fades at its edge. */
  edge: number;
  /** How sharply depth separates ink from paper. See `Grain`. */
  contrast: number;
}

interface GrainRequest {
  style: StrokeStyle;
  seed: number;
  /** Texels per side of the finest level. */
  size: number;
}

/**
 * The paper grain of a level; undefined for a style without grain. Grains are equally wide in texels on every level.
 *
 * @param alongRows the radius of the blur along rows; by default that of the style
 */
export function paperGrain(
  { style, seed, size: finest }: GrainRequest,
  level: number,
  alongRows = style.grain?.radius,
): PaperGrain | undefined {
  if (!style.grain) return undefined;
  const { edge, contrast, radius } = style.grain;
  const size = finest >> level;
  const next = random(seed ^ (0x5bd1e995 * (level + 1)));
  const noise = new Float32Array(size * size);
  const last = noise.length - 1;
  for (let i = 0; i < noise.length / 2; i++) noise[i] = noise[last - i] = next();
  const order = sortedIndices(blurToroidal(noise, size, radius, alongRows).subarray(0, noise.length / 2));
  const depths = new Uint8Array(noise.length);
  for (let rank = 0; rank < order.length; rank++) {
    const depth = Math.floor((256 * rank) / order.length);
    depths[order[rank]] = depths[last - order[rank]] = depth;
  }
  return { depths, edge, contrast };
}
