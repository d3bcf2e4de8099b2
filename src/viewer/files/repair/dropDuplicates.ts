import { type PictureRange, type PlainMesh, triangleCount } from '../mesh/PlainMesh.js';

/**
 * If duplicates are less than this share of the triangles, they stay: they cost little, and scans have some beside triangles of the
 * opposite winding, where the majority decides which side is outside.
 */
const HARMLESS_SHARE = 0.1;
/** Of a large mesh, one triangle in so many is tested first. */
const SAMPLE = 16;
const FEW = 100_000;

/**
 * Leaves out triangles that equal an earlier one: the same corners in the same winding, with the same colours and pictures.
 * Thousands of them in one place would keep a graphics card busy for a minute, and nobody could see it.
 *
 * @returns the mesh, with the first of each, and how many were left out
 */
export function dropDuplicates(mesh: PlainMesh): { mesh: PlainMesh; duplicates: number } {
  const total = triangleCount(mesh);
  const corners = new Corners(mesh);
  if (total > FEW) {
    const { looked, kept } = distinct(mesh, corners, SAMPLE);
    // If fewer were tested than expected, many copies of one triangle may have been passed over together.
    const isEven = looked > (1 - HARMLESS_SHARE / 2) * (total / SAMPLE);
    if (isEven && looked - kept.length / 3 < (HARMLESS_SHARE / 2) * looked) return { mesh, duplicates: 0 };
  }
  const { kept, ranges } = distinct(mesh, corners, 1);
  const duplicates = total - kept.length / 3;
  if (duplicates <= HARMLESS_SHARE * total) return { mesh, duplicates: 0 };
  return { mesh: { ...mesh, indices: kept.slice(), ...(mesh.ranges && { ranges }) }, duplicates };
}

/**
 * The first of each triangle, turned so that equal ones begin with the same corner.
 *
 * @param sample looks at those alone whose mix of corners it divides: at one in so many, duplicates together. A power of two
 * @returns how many were looked at, and the vertices and ranges of those that are kept
 */
function distinct(
  mesh: PlainMesh,
  corners: Corners,
  sample: number,
): { looked: number; kept: Uint32Array; ranges: PictureRange[] } {
  const total = triangleCount(mesh);
  // The factor is for hashes that are not spread quite evenly.
  const room = sample === 1 ? total : Math.ceil((2 * total) / sample);
  const table = new Int32Array(2 ** Math.ceil(Math.log2(2 * room + 2))).fill(-1);
  const mask = table.length - 1;
  const kept = new Uint32Array(3 * room);
  /** Of the kept triangles: most that meet in a slot of the table differ in it. */
  const hashes = new Int32Array(room);
  const ranges: PictureRange[] = [];
  let looked = 0;
  let length = 0;
  for (const range of mesh.ranges ?? [{ start: 0, count: 3 * total, picture: -1 }]) {
    const { start, count, picture } = range;
    const first = length;
    for (let corner = start; corner < start + count && length < kept.length; corner += 3) {
      if (sample > 1 && (corners.mixOf(corner) & (sample - 1)) !== 0) continue;
      const turn = corners.firstOf(corner);
      const hash = corners.hashOf(corner, turn) ^ picture;
      looked++;
      let slot = hash & mask;
      for (let at = table[slot]; at !== -1; at = table[slot]) {
        if (hashes[at / 3] === hash && at >= first && corners.areEqual(kept, at, corner, turn)) break;
        slot = (slot + 1) & mask;
      }
      if (table[slot] !== -1) continue;
      table[slot] = length;
      hashes[length / 3] = hash;
      for (let k = 0; k < 3; k++) kept[length++] = corners.vertexAt(corner + ((turn + k) % 3));
    }
    if (length > first) ranges.push({ ...range, start: first, count: length - first });
  }
  return { looked, kept: kept.subarray(0, length), ranges };
}

/** The corners of a mesh, by all that is drawn of them. */
class Corners {
  private readonly indices: Uint32Array | null;
  /** By vertex. */
  private readonly hashes: Uint32Array;
  /** The bits of each attribute, and its numbers per vertex. */
  private readonly values: readonly { bits: Uint32Array; size: number }[];

  constructor({ positions, colors, uvs, indices }: PlainMesh) {
    this.indices = indices;
    const bits = (values: Float32Array): Uint32Array =>
      new Uint32Array(values.buffer, values.byteOffset, values.length);
    this.values = [
      { bits: bits(positions), size: 3 },
      ...(colors ? [{ bits: bits(colors), size: 3 }] : []),
      ...(uvs ? [{ bits: bits(uvs), size: 2 }] : []),
    ];
    this.hashes = new Uint32Array(positions.length / 3);
    for (let vertex = 0; vertex < this.hashes.length; vertex++) {
      let hash = 0x811c9dc5;
      for (const { bits, size } of this.values) {
        for (let i = size * vertex; i < size * (vertex + 1); i++)
          hash = Math.imul(hash ^ bits[i], 0x01000193) ^ (hash >>> 15);
      }
      this.hashes[vertex] = hash;
    }
  }

  vertexAt(corner: number): number {
    return this.indices ? this.indices[corner] : corner;
  }

  /** Which corner of a triangle begins it: the same for the same triangle, whichever comes first in the file. */
  firstOf(corner: number): number {
    const a = this.hashes[this.vertexAt(corner)];
    const b = this.hashes[this.vertexAt(corner + 1)];
    const c = this.hashes[this.vertexAt(corner + 2)];
    // If two are equal and smallest, it is the one that the other follows.
    if (a <= b && a < c) return 0;
    if (b <= c && b < a) return 1;
    return c <= a && c < b ? 2 : 0;
  }

  /** A number that is the same for triangles of the same corners, in any order. It takes a fraction of the time of a hash. */
  mixOf(corner: number): number {
    const { indices, hashes } = this;
    const sum = indices
      ? hashes[indices[corner]] + hashes[indices[corner + 1]] + hashes[indices[corner + 2]]
      : hashes[corner] + hashes[corner + 1] + hashes[corner + 2];
    const mixed = Math.imul(sum | 0, 0x85ebca6b);
    return mixed ^ (mixed >>> 16);
  }

  hashOf(corner: number, turn: number): number {
    let hash = 0;
    for (let k = 0; k < 3; k++)
      hash = Math.imul(hash ^ this.hashes[this.vertexAt(corner + ((turn + k) % 3))], 0x85ebca6b) ^ (hash >>> 13);
    return hash ^ (hash >>> 16);
  }

  /** Whether a kept triangle equals the one that begins at a corner. */
  areEqual(kept: Uint32Array, at: number, corner: number, turn: number): boolean {
    for (let k = 0; k < 3; k++) if (!this.areSame(kept[at + k], this.vertexAt(corner + ((turn + k) % 3)))) return false;
    return true;
  }

  private areSame(a: number, b: number): boolean {
    if (a === b) return true;
    if (a >= this.hashes.length || b >= this.hashes.length) return false;
    return this.values.every(({ bits, size }) => {
      for (let i = 0; i < size; i++) if (bits[size * a + i] !== bits[size * b + i]) return false;
      return true;
    });
  }
}
