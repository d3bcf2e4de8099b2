/** Distance below which points are at one place, as a share of the size of all. */
const TOLERANCE = 1e-6;
/** Points per step. */
const CHUNK = 8192;
const FREE = -1;

/**
 * For each point the first one at the same place within rounding, since surfaces continue across seams of uvs and normals. Yields its
 * progress.
 *
 * @param coordinate of a point along an axis, from 0 to 2
 */
export function* weldPoints(
  count: number,
  coordinate: (point: number, axis: number) => number,
): Generator<number, Uint32Array, void> {
  let size = 0;
  for (let p = 0; p < count; p++) {
    if (p % CHUNK === 0) yield (0.2 * p) / count;
    for (let axis = 0; axis < 3; axis++) size = Math.max(size, Math.abs(coordinate(p, axis)));
  }
  const cell = size * TOLERANCE || 1;
  const cells = new Int32Array(3 * count);
  // A hash table of points by their cells, with at least one free entry for each.
  const table = new Int32Array(2 ** Math.ceil(Math.log2(2 * count + 2))).fill(FREE);
  const places = new Uint32Array(count);
  for (let p = 0; p < count; p++) {
    if (p % CHUNK === 0) yield 0.2 + (0.8 * p) / count;
    const o = 3 * p;
    for (let axis = 0; axis < 3; axis++) cells[o + axis] = Math.round(coordinate(p, axis) / cell);
    const [x, y, z] = [cells[o], cells[o + 1], cells[o + 2]];
    let entry = hashOf(x, y, z) & (table.length - 1);
    for (;;) {
      const other = table[entry];
      if (other === FREE) table[entry] = places[p] = p;
      else if (cells[3 * other] === x && cells[3 * other + 1] === y && cells[3 * other + 2] === z) places[p] = other;
      else {
        entry = (entry + 1) & (table.length - 1);
        continue;
      }
      break;
    }
  }
  return places;
}

function hashOf(x: number, y: number, z: number): number {
  const mixed = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
  return (mixed ^ (mixed >>> 15)) >>> 0;
}

/** For each point the first one at the same place in both of two lists. */
export function weldBoth(one: Uint32Array, other: Uint32Array): Uint32Array {
  const known = new Map<number, number>();
  return one.map((place, point) => {
    const key = place * 2 ** 26 + other[point];
    const first = known.get(key) ?? point;
    if (first === point) known.set(key, point);
    return first;
  });
}
