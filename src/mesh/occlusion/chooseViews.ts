import type { OcclusionView } from './OcclusionScene.js';

/** The share of the samples that count as the bulk of the scene. */
const BULK = 0.98;
/** Samples that lie this many times farther out than the bulk get depth maps of their own. */
const FARTHER = 1.5;
/** The radius of a view is this many times the distance of its farthest sample, which leaves a margin in the map. */
const MARGIN = 1.02;

/**
 * Chooses one view around all samples, or two: if a few samples lie far out, such as the corners of a wide ground, they get a
 * view of their own, so that the bulk of the scene is measured at a finer resolution.
 *
 * @param positions x, y, z of each sample
 */
export function chooseViews(positions: Float32Array): OcclusionView[] {
  const count = positions.length / 3;
  const center = [0, 1, 2].map((axis) => {
    const along = new Float32Array(count);
    for (let i = 0; i < count; i++) along[i] = positions[3 * i + axis];
    along.sort();
    const end = count - 1;
    // The middle of the bulk, regardless of a few samples far out.
    return (along[Math.round((1 - BULK) * end)] + along[Math.round(BULK * end)]) / 2;
  }) as OcclusionView['center'];
  const distances = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    distances[i] = Math.hypot(
      positions[3 * i] - center[0],
      positions[3 * i + 1] - center[1],
      positions[3 * i + 2] - center[2],
    );
  }
  const sorted = distances.slice().sort();
  const limit = FARTHER * sorted[Math.round(BULK * (count - 1))];
  const near = sorted.findLast((distance) => distance <= limit) ?? 0;
  const view = (reach: number, isIn: (distance: number) => boolean): OcclusionView => ({
    center,
    radius: MARGIN * reach || 1,
    samples: Uint32Array.from(distances.keys()).filter((i) => isIn(distances[i])),
  });
  const far = sorted[count - 1];
  if (far === near) return [view(far, () => true)];
  return [view(near, (distance) => distance <= near), view(far, (distance) => distance > near)];
}
