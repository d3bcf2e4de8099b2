import { add, cross, dot, faceNormal, subtract, unit, type Vector, vectorAt } from './vector.js';

export interface StrokeKink {
  /** Degrees, in [0, 90]. */
  median: number;
  p95: number;
}

/**
 * M3: the angle by which strokes turn where they cross from one triangle into the next, with both unfolded into a plane. It
 * follows from the frames alone: a stroke lies where a plane perpendicular to B cuts the triangle.
 *
 * @param positions - xyz of the corners of a triangle soup.
 * @param edges - as `pairedEdges` returns them.
 * @param toLight - direction to a distant light.
 * @param normals - per corner, the normals from which frames are interpolated. Without them every triangle has its own frame, as
 *   in Suarez et al., whose blend then shows both.
 */
export function strokeKink(
  positions: ArrayLike<number>,
  edges: Uint32Array,
  toLight: Vector,
  normals?: ArrayLike<number>,
): StrokeKink {
  const kinks: number[] = [];
  for (let i = 0; i < edges.length; i += 4) {
    const [start, end, twinStart, twinEnd] = [...edges.subarray(i, i + 4)] as [number, number, number, number];
    const along = unit(subtract(vectorAt(positions, end), vectorAt(positions, start)));
    const angle = (a: number, b: number) => {
      const face = faceNormal(positions, a);
      const n = normals ? unit(add(vectorAt(normals, a), vectorAt(normals, b))) : face;
      const bitangent = subtract(toLight, scaled(n, dot(toLight, n)));
      // Facing the light, strokes have no direction.
      if (Math.hypot(...bitangent) < 1e-4 * Math.hypot(...toLight)) return Number.NaN;
      const stroke = cross(face, bitangent);
      return Math.atan2(dot(stroke, cross(face, along)), dot(stroke, along));
    };
    const turn = Math.abs(angle(start, end) - angle(twinStart, twinEnd)) % Math.PI;
    // Strokes have no orientation: a turn by more than 90° equals one by less.
    const kink = Math.min(turn, Math.PI - turn);
    if (Number.isFinite(kink)) kinks.push((kink * 180) / Math.PI);
  }
  kinks.sort((a, b) => a - b);
  const at = (share: number) => kinks[Math.floor(share * (kinks.length - 1))] ?? Number.NaN;
  return { median: at(0.5), p95: at(0.95) };
}

const scaled = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
