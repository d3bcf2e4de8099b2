/** Whether the total area of triangles is below a limit. Stops early for most meshes. */
export function isAreaLess(positions: ArrayLike<number>, indices: ArrayLike<number> | null, least: number): boolean {
  let sum = 0;
  const count = indices?.length ?? positions.length / 3;
  for (let corner = 0; corner + 2 < count && sum < least; corner += 3) {
    const [a, b, c] = [corner, corner + 1, corner + 2].map((at) => 3 * (indices ? indices[at] : at));
    sum += areaOf(positions, a, b, c);
  }
  return sum < least;
}

/** The area of a triangle. @param a offset of the first corner's coordinates, likewise `b` and `c` */
export function areaOf(positions: ArrayLike<number>, a: number, b: number, c: number): number {
  const ux = positions[b] - positions[a];
  const uy = positions[b + 1] - positions[a + 1];
  const uz = positions[b + 2] - positions[a + 2];
  const vx = positions[c] - positions[a];
  const vy = positions[c + 1] - positions[a + 1];
  const vz = positions[c + 2] - positions[a + 2];
  const x = uy * vz - uz * vy;
  const y = uz * vx - ux * vz;
  const z = ux * vy - uy * vx;
  // Math.hypot takes several times as long.
  return Math.sqrt(x * x + y * y + z * z) / 2;
}

/** A model of radius 1 with less surface area than this is thinner than a pixel everywhere. */
const LEAST_AREA = 0.002;

/**
 * A note for a model of radius 1 whose triangles are slivers or dust that strokes cannot show.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param share of all triangles that these are
 */
export function thinNote(positions: ArrayLike<number>, indices: ArrayLike<number> | null, share = 1): string[] {
  return isAreaLess(positions, indices, LEAST_AREA * share) ? ['its triangles are too thin to be hatched'] : [];
}
