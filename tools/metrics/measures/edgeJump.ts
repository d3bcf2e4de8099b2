import type { SurfaceImage } from './SurfaceImage.js';

export interface EdgeJump {
  /** Mean and 95th percentile of the difference in luminance, over all pixels that lie on edges. */
  mean: number;
  p95: number;
  samples: number;
}

/**
 * M2: how much the shading jumps where two triangles meet. `own` and `twin` show the same edges as lines, shaded as part of one
 * triangle and of the other. Where shading is continuous, the two are equal.
 */
export function edgeJump(own: SurfaceImage, twin: SurfaceImage): EdgeJump {
  const jumps: number[] = [];
  for (let i = 0; i < own.luminance.length; i++) {
    if (own.surface[i] !== 0 && twin.surface[i] !== 0) jumps.push(Math.abs(own.luminance[i] - twin.luminance[i]));
  }
  if (jumps.length === 0) return { mean: Number.NaN, p95: Number.NaN, samples: 0 };
  jumps.sort((a, b) => a - b);
  const mean = jumps.reduce((sum, jump) => sum + jump, 0) / jumps.length;
  return { mean, p95: jumps[Math.floor(0.95 * (jumps.length - 1))], samples: jumps.length };
}
