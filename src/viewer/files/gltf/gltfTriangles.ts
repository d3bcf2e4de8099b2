const TRIANGLES = 4;
const STRIP = 5;
const FAN = 6;

/** Whether a primitive mode draws triangles. */
export const drawsTriangles = (mode: number): boolean => mode === TRIANGLES || mode === STRIP || mode === FAN;

/**
 * Converts a triangle list, strip or fan to a list.
 *
 * @param indices of the file, or undefined for vertices in order
 * @param isUsable whether a vertex may be used; undefined if all may
 * @returns the indices, or undefined if every three vertices in order make a triangle; and the number of triangles left out because a
 *   vertex is missing or unusable
 */
export function toTriangles(
  mode: number,
  indices: Uint32Array | undefined,
  vertexCount: number,
  isUsable: Uint8Array | undefined,
): { indices: Uint32Array | undefined; broken: number } {
  if (mode === TRIANGLES && !indices && !isUsable && vertexCount % 3 === 0) return { indices: undefined, broken: 0 };
  const corners = indices?.length ?? vertexCount;
  const triangles = Math.max(0, mode === TRIANGLES ? Math.floor(corners / 3) : corners - 2);
  const list = new Uint32Array(3 * triangles);
  const vertexAt = (corner: number): number => (indices ? indices[corner] : corner);
  const isGood = (vertex: number): boolean => vertex < vertexCount && (!isUsable || isUsable[vertex] === 1);
  let length = 0;
  let broken = 0;
  for (let t = 0; t < triangles; t++) {
    const [i, j, k] = cornersOf(mode, t);
    const a = vertexAt(i);
    const b = vertexAt(j);
    const c = vertexAt(k);
    // Strips are joined by degenerate triangles.
    if (mode !== TRIANGLES && (a === b || b === c || c === a)) continue;
    if (!(isGood(a) && isGood(b) && isGood(c))) {
      broken++;
      continue;
    }
    list[length++] = a;
    list[length++] = b;
    list[length++] = c;
  }
  return { indices: length === list.length ? list : list.slice(0, length), broken };
}

function cornersOf(mode: number, t: number): [number, number, number] {
  if (mode === TRIANGLES) return [3 * t, 3 * t + 1, 3 * t + 2];
  if (mode === FAN) return [t + 1, t + 2, 0];
  return [t, t + 1 + (t % 2), t + 2 - (t % 2)];
}
