/** Maps of what is seen from afar along a direction: their axes, and the projection to their pixels. */

/** The axes of a depth map: unit vectors, orthogonal. `right` and `up` span the map, `towards` points at the first sky. */
export interface MapAxes {
  right: Vector;
  up: Vector;
  towards: Vector;
}

type Vector = [x: number, y: number, z: number];

// The generalised golden ratio in three dimensions (Martin Roberts, "The unreasonable effectiveness of quasirandom sequences",
// 2018). Any beginning of the sequence is evenly distributed, so a bake may stop or continue after any number of directions.
const RATIO = 1.2207440846057596;

/**
 * The axes for direction number `index` in an even distribution over the upper half of the sphere. Each map is rotated about its
 * direction by a different angle, so that the pixel grids of no two maps coincide.
 */
export function mapAxes(index: number): MapAxes {
  const height = fraction(0.5 + (index + 1) / RATIO);
  const longitude = 2 * Math.PI * fraction(0.5 + (index + 1) / RATIO ** 2);
  const roll = 2 * Math.PI * fraction(0.5 + (index + 1) / RATIO ** 3);
  const radius = Math.sqrt(1 - height * height);
  const towards: Vector = [radius * Math.cos(longitude), height, radius * Math.sin(longitude)];
  const level: Vector = [-Math.sin(longitude), 0, Math.cos(longitude)];
  const steep = cross(towards, level);
  const cosine = Math.cos(roll);
  const sine = Math.sin(roll);
  const right = level.map((value, i) => cosine * value + sine * steep[i]) as Vector;
  return { right, up: cross(towards, right), towards };
}

const fraction = (x: number): number => x - Math.floor(x);

const cross = ([a, b, c]: Vector, [x, y, z]: Vector): Vector => [b * z - c * y, c * x - a * z, a * y - b * x];

/** A matrix with three rows of four, which maps points to pixels and depth. */
export type Projection = Float64Array;

/** The projection of a view along an axis to a map of so many pixels a side, with x, y in pixels and depth in world units. */
export function projectionOf(
  { right, up, towards }: MapAxes,
  { center, radius }: { center: Vector; radius: number },
  size: number,
): Projection {
  const pixels = size / (2 * radius);
  const rows = [right.map((x) => pixels * x), up.map((x) => pixels * x), towards];
  return Float64Array.from(
    rows.flatMap((row, i) => {
      const atCenter = row[0] * center[0] + row[1] * center[1] + row[2] * center[2];
      return [...row, (i < 2 ? size / 2 : 0) - atCenter];
    }),
  );
}

/** Projects a range of points. */
export function project(
  points: Float32Array,
  projected: Float32Array,
  p: Projection,
  start: number,
  end: number,
): void {
  for (let i = 3 * start; i < 3 * end; i += 3) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    projected[i] = p[0] * x + p[1] * y + p[2] * z + p[3];
    projected[i + 1] = p[4] * x + p[5] * y + p[6] * z + p[7];
    projected[i + 2] = p[8] * x + p[9] * y + p[10] * z + p[11];
  }
}

/** Pixels on an edge belong to both triangles, so that rounding leaves no gap. */
export const EDGE = -1e-5;
