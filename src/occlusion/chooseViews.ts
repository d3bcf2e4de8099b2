import type { OcclusionView } from './OcclusionScene.js';

/** Share of the samples that are the many. */
const MOST = 0.98;
/** What lies this much farther out than they gets maps of its own. */
const FARTHER = 1.5;
/** Pixels on the border of a map stay free. */
const MARGIN = 1.02;

/**
 * One view around all samples. Where a few of them lie far out, as the corners of a wide ground, they get a view of
 * their own, and the many are seen from near by.
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
    // The middle of the many, whatever the few do.
    return (along[Math.round((1 - MOST) * end)] + along[Math.round(MOST * end)]) / 2;
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
  const limit = FARTHER * sorted[Math.round(MOST * (count - 1))];
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
