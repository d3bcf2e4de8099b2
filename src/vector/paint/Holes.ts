import type { Vec3 } from '../../look/vectors.js';
import { ColourReader } from './ColourReader.js';
import { interpolated } from './DetailReader.js';
import { type Cutout, isClipped } from './PaintLook.js';

/** Tests for holes in triangles of a scene, by alpha or clipping planes. */
export class Holes {
  /** The readers of cutouts with holes by alpha; null for others. */
  private readonly painters: (ColourReader | null)[];

  constructor(private readonly cutouts: readonly Cutout[]) {
    this.painters = cutouts.map(({ painted }) => painted && new ColourReader(painted.paint, painted.details));
  }

  /**
   * Whether there is a hole at a place of a triangle.
   *
   * @param u and `v`: weights of its second and third corner
   * @param isForLight whether the ray is one of light, not of sight
   */
  isOpen(triangle: number, u: number, v: number, place: Vec3, isForLight: boolean): boolean {
    const i = this.indexOf(triangle);
    if (i < 0) return false;
    const { clip, shadowClip, painted } = this.cutouts[i];
    const clips = isForLight ? shadowClip : clip;
    if (clips && isClipped(clips, place)) return true;
    if (!painted) return false;
    const { corners, firstTriangle, stride, numbers } = painted.details;
    const c = 3 * (triangle - firstTriangle);
    const at = interpolated(numbers, stride, [corners[c], corners[c + 1], corners[c + 2]], [1 - u - v, u, v]);
    return this.painters[i]!.alphaMarginAt(at) < 0;
  }

  /** The index of a cutout by bisection: cutouts are sorted by their triangles. */
  private indexOf(triangle: number): number {
    let [low, high] = [0, this.cutouts.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (triangle < this.cutouts[middle].end) high = middle;
      else low = middle + 1;
    }
    return low < this.cutouts.length && triangle >= this.cutouts[low].first ? low : -1;
  }
}
