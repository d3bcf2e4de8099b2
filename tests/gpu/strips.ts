import { type BufferGeometry, PlaneGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

/** Leaves side by side from −0.9 to 0.6, so many that their outlines crowd, and one alone at 0.9. */
export function strips(count: number): BufferGeometry {
  const width = 0.75 / count;
  const leaf = (x: number): BufferGeometry => new PlaneGeometry(width, 1.8).translate(x, 0, 0);
  const crowd = Array.from({ length: count }, (_, k) => leaf(-0.9 + 2 * (k + 0.5) * width));
  return mergeGeometries([...crowd, leaf(0.9)]);
}

/** The leaf that stands alone. */
export const loneStrip = (count: number): BufferGeometry => new PlaneGeometry(0.75 / count, 1.8).translate(0.9, 0, 0);
