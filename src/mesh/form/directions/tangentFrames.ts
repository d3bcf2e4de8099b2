import { forEachChunk } from '../../phases.js';

/** Floats per fan: two unit tangents e₁ and e₂, with e₁ × e₂ the normal. */
export const FRAME_FLOATS = 6;

/** An axis that leans at least this much away from a normal gives a good tangent. */
const LARGEST_COSINE = 0.6;

/** Gives each unit normal (three floats) a deterministic frame of its tangent plane. */
export function* tangentFrames(normals: Float32Array): Generator<number, Float32Array<ArrayBuffer>, void> {
  const frames = new Float32Array(2 * normals.length);
  yield* forEachChunk(normals.length / 3, (start, end) => frameRange(normals, frames, start, end));
  return frames;
}

/** e₁ is the product of the first axis that leans away from the normal and the normal. */
function frameRange(normals: Float32Array, frames: Float32Array, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    const x = normals[3 * fan];
    const y = normals[3 * fan + 1];
    const z = normals[3 * fan + 2];
    let ux = 0;
    let uy = 0;
    let uz = 0;
    if (Math.abs(x) < LARGEST_COSINE) {
      uy = -z;
      uz = y;
    } else if (Math.abs(y) < LARGEST_COSINE) {
      ux = z;
      uz = -x;
    } else {
      ux = -y;
      uy = x;
    }
    const scale = 1 / Math.sqrt(ux * ux + uy * uy + uz * uz);
    ux *= scale;
    uy *= scale;
    uz *= scale;
    const i = FRAME_FLOATS * fan;
    frames[i] = ux;
    frames[i + 1] = uy;
    frames[i + 2] = uz;
    frames[i + 3] = y * uz - z * uy;
    frames[i + 4] = z * ux - x * uz;
    frames[i + 5] = x * uy - y * ux;
  }
}
