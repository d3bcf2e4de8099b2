import type { FanSurface } from '../normals/assembleHeatEquation.js';
import { smoothFanNormals } from '../normals/smoothFanNormals.js';
import { asPhase, forEachChunk } from '../phases.js';

/**
 * A part is thinner than the larger radius if its normals, smoothed over twice the radius, are shorter than this share of the others: more
 * of them cancel than relief explains. From the second share on, it is not thin.
 */
const THIN = 0.3;
const THICK = 0.6;

/**
 * Smooths normals at the scale of a stroke. On thinner parts, such as claws and ears, normals from all around would cancel and be drowned
 * by those of the body; such parts take half the radius, or a quarter.
 *
 * @param shares see `smoothFanNormals`
 * @returns a vector per fan, not of unit length
 */
export function* strokeNormals(
  surface: FanSurface,
  radius: number,
  shares: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const radii = [radius, radius / 2, radius / 4];
  const [whole, half, quarter] = yield* asPhase(smoothFanNormals(surface, radii, shares), 0, 0.95);
  yield* asPhase(
    forEachChunk(shares.length, (start, end) => {
      chooseRange(half, quarter, start, end);
      chooseRange(whole, half, start, end);
    }),
    0.95,
    1,
  );
  return whole;
}

/** Replaces vectors of a range of fans, in place, by those of the smaller radius where the part is thin. */
function chooseRange(vectors: Float32Array, finer: Float32Array, start: number, end: number): void {
  for (let i = 3 * start; i < 3 * end; i += 3) {
    const length = Math.sqrt(vectors[i] ** 2 + vectors[i + 1] ** 2 + vectors[i + 2] ** 2);
    const finerLength = Math.sqrt(finer[i] ** 2 + finer[i + 1] ** 2 + finer[i + 2] ** 2);
    if (length >= THICK * finerLength) continue;
    const t = Math.max(0, (length / finerLength - THIN) / (THICK - THIN));
    const share = t * t * (3 - 2 * t);
    const own = share / (length || 1);
    const other = (1 - share) / finerLength;
    for (let k = i; k < i + 3; k++) vectors[k] = finerLength * (own * vectors[k] + other * finer[k]);
  }
}
