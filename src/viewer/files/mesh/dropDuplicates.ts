import { type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';

/**
 * Below this share of the triangles, duplicates stay: in scans some lie next to triangles of opposite winding, where the majority decides which
 * side is outside. More of them look like edges at which surfaces end, and have outlines.
 */
const HARMLESS_SHARE = 0.02;
/** Backs of sheets lie side by side: at least so many of their edges per triangle are shared. Flaps of scans share a tenth of that. */
const SHEET = 0.3;
/** Large meshes are tested by one triangle in this many first. */
const SAMPLE = 16;
const FEW = 100_000;

/**
 * Leaves out duplicate triangles: same corners, winding, colours and pictures. Thousands of them in one place would occupy a graphics card
 * for a minute without any visible effect.
 *
 * @param isSided whether triangles of opposite winding differ; false where surfaces are drawn from both sides, so that a sheet with a copy
 * for its back is drawn once. Flaps of a scan, whose two triangles close it, stay
 * @returns the mesh, with the first of each, and the number left out
 */
export function dropDuplicates(mesh: PlainMesh, isSided = true): { mesh: PlainMesh; duplicates: number } {
  const corners = new Corners(mesh);
  let found = withoutDuplicates(mesh, corners, isSided);
  if (found && !isSided && !areSheets(corners, found.dropped)) found = withoutDuplicates(mesh, corners, true);
  if (!found) return { mesh, duplicates: 0 };
  const { kept, ranges, dropped } = found;
  return { mesh: { ...mesh, indices: kept.slice(), ...(mesh.ranges && { ranges }) }, duplicates: dropped.length };
}

/** What is left without duplicates; null where there are few. */
function withoutDuplicates(mesh: PlainMesh, corners: Corners, isSided: boolean): Distinct | null {
  const total = triangleCount(mesh);
  if (total > FEW) {
    const { looked, dropped } = distinct(mesh, corners, isSided, SAMPLE);
    // If far fewer were tested than expected, the sample may have missed many copies of one triangle.
    const isEven = looked > (1 - HARMLESS_SHARE / 2) * (total / SAMPLE);
    if (isEven && dropped.length < (HARMLESS_SHARE / 2) * looked) return null;
  }
  const found = distinct(mesh, corners, isSided, 1);
  return found.dropped.length <= HARMLESS_SHARE * total ? null : found;
}

/** Whether triangles, given by their first corners, lie side by side. Several in one place count once. */
function areSheets(corners: Corners, triangles: readonly number[]): boolean {
  const places = new Set<number>();
  const edges = new Set<number>();
  let shared = 0;
  for (const corner of triangles) {
    const place = corners.hashOf(corner, corners.firstOf(corner), false);
    if (places.has(place)) continue;
    places.add(place);
    for (let k = 0; k < 3; k++) {
      const edge = corners.edgeAt(corner, k);
      if (edges.has(edge)) shared++;
      else edges.add(edge);
    }
  }
  return shared >= SHEET * places.size;
}

/** The result of a search for equal triangles. */
interface Distinct {
  /** The number tested. */
  looked: number;
  /** The vertices and ranges of those kept. */
  kept: Uint32Array;
  ranges: PictureRange[];
  /** The first corners of the others. */
  dropped: number[];
}

/**
 * The first of each set of equal triangles, rotated so that equal ones begin with the same corner.
 *
 * @param sample tests only triangles whose corner mix is divisible by it, which keeps duplicates together. A power of two
 */
function distinct(mesh: PlainMesh, corners: Corners, isSided: boolean, sample: number): Distinct {
  const total = triangleCount(mesh);
  // The factor allows for uneven hashes.
  const room = sample === 1 ? total : Math.ceil((2 * total) / sample);
  const table = new Int32Array(2 ** Math.ceil(Math.log2(2 * room + 2))).fill(-1);
  const mask = table.length - 1;
  const kept = new Uint32Array(3 * room);
  /** Hashes of the kept triangles, which tell most triangles apart that share a table slot. */
  const hashes = new Int32Array(room);
  const ranges: PictureRange[] = [];
  const dropped: number[] = [];
  let looked = 0;
  let length = 0;
  for (const range of mesh.ranges ?? [{ start: 0, count: 3 * total, picture: -1 }]) {
    const { start, count, picture } = range;
    const first = length;
    for (let corner = start; corner < start + count && length < kept.length; corner += 3) {
      if (sample > 1 && (corners.mixOf(corner) & (sample - 1)) !== 0) continue;
      const turn = corners.firstOf(corner);
      const hash = corners.hashOf(corner, turn, isSided) ^ picture;
      looked++;
      let slot = hash & mask;
      for (let at = table[slot]; at !== -1; at = table[slot]) {
        if (hashes[at / 3] === hash && at >= first && corners.areEqual(kept, at, corner, turn, isSided)) break;
        slot = (slot + 1) & mask;
      }
      if (table[slot] !== -1) {
        dropped.push(corner);
        continue;
      }
      table[slot] = length;
      hashes[length / 3] = hash;
      for (let k = 0; k < 3; k++) kept[length++] = corners.vertexAt(corner + ((turn + k) % 3));
    }
    if (length > first) ranges.push({ ...range, start: first, count: length - first });
  }
  return { looked, kept: kept.subarray(0, length), ranges, dropped };
}

/** A hash with another number mixed into it. */
const mixed = (hash: number, next: number): number => Math.imul(hash ^ next, 0x85ebca6b) ^ (hash >>> 13);

/** The corners of a mesh, compared by everything that is drawn of them. */
class Corners {
  private readonly indices: Uint32Array | null;
  /** Hash per vertex. */
  private readonly hashes: Uint32Array;
  /** The bits of each attribute, and its components per vertex. */
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

  /** A hash of the edge from a corner of a triangle to the next, in either direction. */
  edgeAt(corner: number, k: number): number {
    const a = this.hashes[this.vertexAt(corner + k)];
    const b = this.hashes[this.vertexAt(corner + ((k + 1) % 3))];
    return mixed((a + b) | 0, a ^ b);
  }

  /** The corner with which a triangle begins: the same for equal triangles, whatever their order in the file. */
  firstOf(corner: number): number {
    const a = this.hashes[this.vertexAt(corner)];
    const b = this.hashes[this.vertexAt(corner + 1)];
    const c = this.hashes[this.vertexAt(corner + 2)];
    // If two are equal and lowest, the triangle begins with the one that comes before the other.
    if (a <= b && a < c) return 0;
    if (b <= c && b < a) return 1;
    return c <= a && c < b ? 2 : 0;
  }

  /** A checksum of a triangle's corners that does not depend on their order. Takes a fraction of the time of a hash. */
  mixOf(corner: number): number {
    const { indices, hashes } = this;
    const sum = indices
      ? hashes[indices[corner]] + hashes[indices[corner + 1]] + hashes[indices[corner + 2]]
      : hashes[corner] + hashes[corner + 1] + hashes[corner + 2];
    const mixed = Math.imul(sum | 0, 0x85ebca6b);
    return mixed ^ (mixed >>> 16);
  }

  /** A hash of a triangle, the same for both windings if these do not count. */
  hashOf(corner: number, turn: number, isSided: boolean): number {
    const first = this.hashes[this.vertexAt(corner + turn)];
    const second = this.hashes[this.vertexAt(corner + ((turn + 1) % 3))];
    const third = this.hashes[this.vertexAt(corner + ((turn + 2) % 3))];
    const isReversed = !isSided && third < second;
    const hash = mixed(mixed(mixed(0, first), isReversed ? third : second), isReversed ? second : third);
    return hash ^ (hash >>> 16);
  }

  /** Whether a kept triangle equals the one that begins at a corner. */
  areEqual(kept: Uint32Array, at: number, corner: number, turn: number, isSided: boolean): boolean {
    const second = this.vertexAt(corner + ((turn + 1) % 3));
    const third = this.vertexAt(corner + ((turn + 2) % 3));
    if (!this.areSame(kept[at], this.vertexAt(corner + turn))) return false;
    if (this.areSame(kept[at + 1], second) && this.areSame(kept[at + 2], third)) return true;
    return !isSided && this.areSame(kept[at + 1], third) && this.areSame(kept[at + 2], second);
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
