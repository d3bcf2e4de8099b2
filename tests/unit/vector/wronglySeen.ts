import type { Camera, Scene } from 'three';
import { Bvh } from '../../../src/vector/Bvh.js';
import { LineDrawer } from '../../../src/vector/LineDrawer.js';
import { Projection } from '../../../src/vector/Projection.js';
import { readScene } from '../../../src/vector/svg/readScene.js';
import { placeOn, visibleRuns } from '../../../src/vector/visibleRuns.js';
import { finished } from './finished.js';
import { randomNumbers } from './randomNumbers.js';

/** Whether a triangle that faces the eye lies between the eye and a point: by signed volumes, one triangle after the other. */
function isHiddenBy(corners: Float64Array, place: readonly number[], way: readonly number[], except: number): boolean {
  const size = Math.hypot(...way);
  /** The corners of a triangle, relative to the point. */
  const p = new Float64Array(9);
  for (let t = 0; 9 * t < corners.length; t++) {
    if (t === except) continue;
    for (let i = 0; i < 9; i++) p[i] = corners[9 * t + i] - place[i % 3];
    const volume = (a: number, b: number) =>
      way[0] * (p[b + 1] * p[a + 2] - p[b + 2] * p[a + 1]) +
      way[1] * (p[b + 2] * p[a] - p[b] * p[a + 2]) +
      way[2] * (p[b] * p[a + 1] - p[b + 1] * p[a]);
    const [u, v, w] = [volume(3, 6), volume(6, 0), volume(0, 3)];
    // Its front faces the far end of the ray.
    if (!(u <= 0 && v <= 0 && w <= 0) || u + v + w === 0) continue;
    const along = (k: number) => (p[k] * way[0] + p[k + 1] * way[1] + p[k + 2] * way[2]) / size;
    const distance = (u * along(0) + v * along(3) + w * along(6)) / (u + v + w);
    if (distance > 1e-5 && distance < size) return true;
  }
  return false;
}

/** The finding at a point. */
type Look = 'right' | 'visible' | 'hidden' | 'beyond';

/** Shares of points on engraved lines. */
export interface WronglySeen {
  /** Shares drawn though hidden, hidden though visible, and both together. */
  visible: number;
  hidden: number;
  share: number;
  /** Number of pieces. */
  pieces: number;
}

/** The shares of points on engraved lines, within the picture, that are wrongly drawn or hidden. */
export function wronglySeen(scene: Scene, camera: Camera, samples: number): WronglySeen {
  const { drawn } = finished(readScene(scene, camera, false));
  const projection = new Projection(drawn.camera, 400, 400);
  const bvh = finished(Bvh.build(drawn.corners, drawn.sides, drawn.cutouts));
  const drawer = new LineDrawer(drawn, null, projection, bvh);
  const random = randomNumbers(1);
  const pieces: { length: number; look(share: number): Look }[] = [];
  for (const surface of drawn.surfaces) {
    for (const { chain } of finished(drawer.tracedChains(surface))) {
      const runs = finished(visibleRuns(chain, projection, drawer.surfaceTest(chain)));
      for (let piece = 0; piece + 1 < chain.count; piece++) {
        if (!(chain.margins[piece] > 0 && chain.margins[piece + 1] > 0)) continue;
        const [i, j] = [2 * piece, 2 * piece + 2];
        const length = Math.hypot(chain.screen[j] - chain.screen[i], chain.screen[j + 1] - chain.screen[i + 1]);
        const look = (share: number): Look => {
          const place = piece + share;
          const { world, x, y } = placeOn(chain, piece, share, projection);
          // Nothing is drawn beyond the picture.
          if (!projection.contains(x, y)) return 'beyond';
          const isDrawn = runs.some(([from, to]) => {
            const again = place + chain.count - 1;
            return (place >= from && place <= to) || (again >= from && again <= to);
          });
          const { way } = projection.wayToEye(...world);
          const isHidden = isHiddenBy(drawn.corners, world, way, chain.triangles[piece]);
          if (isDrawn === !isHidden) return 'right';
          return isDrawn ? 'visible' : 'hidden';
        };
        if (length > 0) pieces.push({ length, look });
      }
    }
  }
  // By length, so that points are spread evenly over all lines.
  const total = pieces.reduce((sum, { length }) => sum + length, 0);
  const counts = { right: 0, visible: 0, hidden: 0, beyond: 0 };
  let [at, k] = [0, 0];
  for (let sample = 0; sample < samples; sample++) {
    const target = ((sample + random()) / samples) * total;
    while (at + pieces[k].length < target) at += pieces[k++].length;
    counts[pieces[k].look((target - at) / pieces[k].length)]++;
  }
  const [visible, hidden] = [counts.visible, counts.hidden].map((count) => count / (samples - counts.beyond));
  return { visible, hidden, share: visible + hidden, pieces: pieces.length };
}
