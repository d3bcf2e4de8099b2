import {
  BORDER,
  CONTRARY,
  CREASE,
  IS_EDGE,
  LOW_FLAGS,
  MATERIAL_BORDER,
  POINT_BITS,
  POINT_MASK,
  PRIMITIVE_WORDS,
  SEARCHED_IN_WORKER,
  unpackPoints,
} from '../../mesh/bake/outlineLayout.js';
import { paddedWords } from '../../mesh/bake/pullLayout.js';
import { nextCorner, triangleOf } from '../../mesh/corners.js';
import type { OutlineData } from '../geometry/OutlineData.js';

/** The corner of an edge side that has no triangle. */
const NO_CORNER = -1;

/** Finds the edges of triangles by their start and end points. */
class EdgeTable {
  /** A corner + 1 in each slot; 0 if it is empty. */
  private readonly table: Uint32Array;

  /** @param points the point of each corner of the triangles */
  constructor(private readonly points: Uint32Array) {
    let size = 16;
    while (size < 2 * points.length) size *= 2;
    this.table = new Uint32Array(size);
    for (let corner = 0; corner < points.length; corner++) {
      const slot = this.slotOf(points[corner], points[nextCorner(corner)]);
      if (this.table[slot] === 0) this.table[slot] = corner + 1;
    }
  }

  /** The corner at which an edge between two points starts; the first, if there are several. */
  find(from: number, to: number): number {
    return this.table[this.slotOf(from, to)] - 1;
  }

  /** The slot of an edge, or the empty slot where it would go. */
  private slotOf(from: number, to: number): number {
    const { points, table } = this;
    const mask = table.length - 1;
    const mixed = Math.imul(from, 0x9e3779b1) ^ Math.imul(to, 0x85ebca6b);
    for (let slot = (mixed ^ (mixed >>> 15)) & mask; ; slot = (slot + 1) & mask) {
      const corner = table[slot] - 1;
      if (corner < 0 || (points[corner] === from && points[nextCorner(corner)] === to)) return slot;
    }
  }
}

/** The part of a triangle that is not drawn. */
export const NO_PART = -1;

/** The flags that an edge keeps if only one of its sides is drawn: it becomes a border with the same corners. */
const KEPT_BY_BORDER = ~(CREASE | MATERIAL_BORDER | CONTRARY);

/** Distributes the triangles and edges of outlines to parts of the mesh that are drawn separately, or not at all. */
export class PrimitiveSplitter {
  private readonly positions: Float32Array<ArrayBuffer>;
  private readonly normals: Float32Array<ArrayBuffer>;
  /** The points of the corners of all triangles. */
  private readonly points: Uint32Array;
  /** For each edge, the corners at which its two sides start. */
  private readonly sides: Int32Array;
  /** For each corner, the triangle across its edge on a continuous surface; `NO_CORNER` for edges that are listed. */
  private readonly across: Int32Array;

  constructor(private readonly data: OutlineData) {
    const { triangleCount, edgeCount } = data;
    const { positions, normals } = unpackPoints(data.points.image.data as Uint32Array<ArrayBuffer>, data.pointCount);
    this.positions = positions;
    this.normals = normals;
    this.points = new Uint32Array(3 * triangleCount);
    for (let t = 0; t < triangleCount; t++)
      for (let k = 0; k < 3; k++) this.points[3 * t + k] = this.words[PRIMITIVE_WORDS * t + k] & POINT_MASK;
    const table = new EdgeTable(this.points);
    this.sides = new Int32Array(2 * edgeCount);
    for (let edge = 0; edge < edgeCount; edge++) this.findSides(edge, table);
    this.across = new Int32Array(3 * triangleCount);
    for (let corner = 0; corner < this.across.length; corner++) {
      // Both sides of an edge that is not listed have the same points.
      const twin = table.find(this.points[nextCorner(corner)], this.points[corner]);
      this.across[corner] = twin === NO_CORNER ? NO_CORNER : triangleOf(twin);
    }
    for (const corner of this.sides) if (corner !== NO_CORNER) this.across[corner] = NO_CORNER;
  }

  /**
   * The outlines of each part. An edge between two parts belongs to the first. Where a drawn part ends at one that is not drawn, it has
   * a border.
   *
   * @param partOf the part of each triangle, or `NO_PART`
   */
  split(partOf: Int32Array, partCount: number): OutlineData[] {
    const triangles = Array.from({ length: partCount }, (): number[] => []);
    const edges = Array.from({ length: partCount }, (): number[] => []);
    const { across, data, sides } = this;
    for (let t = 0; t < data.triangleCount; t++) {
      const part = partOf[t];
      if (part === NO_PART) continue;
      triangles[part].push(t);
      for (let corner = 3 * t; corner < 3 * t + 3; corner++) {
        const other = across[corner];
        if (other !== NO_CORNER && partOf[other] === NO_PART) this.pushBorder(corner, edges[part]);
      }
    }
    for (let edge = 0; edge < data.edgeCount; edge++) {
      const [left, right] = [sides[2 * edge], sides[2 * edge + 1]];
      const ofLeft = left === NO_CORNER ? NO_PART : partOf[triangleOf(left)];
      const ofRight = right === NO_CORNER ? NO_PART : partOf[triangleOf(right)];
      if (ofLeft === NO_PART && ofRight === NO_PART) continue;
      const part = Math.min(ofLeft, ofRight) === NO_PART ? Math.max(ofLeft, ofRight) : Math.min(ofLeft, ofRight);
      this.pushEdge(edge, ofLeft !== NO_PART, ofRight !== NO_PART, edges[part]);
    }
    return triangles.map((ofPart, part) => this.outlinesOf(ofPart, edges[part]));
  }

  private get words(): Uint32Array<ArrayBuffer> {
    return this.data.primitives.image.data as Uint32Array<ArrayBuffer>;
  }

  private findSides(edge: number, edges: EdgeTable): void {
    const { data, sides, words } = this;
    const o = PRIMITIVE_WORDS * (data.triangleCount + edge);
    const flags = flagsAt(words, o);
    const left = edges.find(words[o] & POINT_MASK, words[o + 1] & POINT_MASK);
    const [rightStart, rightEnd] = [words[o + 2] & POINT_MASK, words[o + 3] & POINT_MASK];
    const isContrary = (flags & CONTRARY) !== 0;
    const across = isContrary ? edges.find(rightStart, rightEnd) : edges.find(rightEnd, rightStart);
    const right = (flags & BORDER) !== 0 ? NO_CORNER : across;
    sides[2 * edge] = left;
    sides[2 * edge + 1] = right;
  }

  private pushEdge(edge: number, hasLeft: boolean, hasRight: boolean, into: number[]): void {
    const { data, words } = this;
    const o = PRIMITIVE_WORDS * (data.triangleCount + edge);
    const flags = flagsAt(words, o);
    if ((hasLeft && hasRight) || (flags & BORDER) !== 0) {
      into.push(...words.subarray(o, o + PRIMITIVE_WORDS));
      return;
    }
    const side = hasLeft ? o : o + 2;
    pushEnds(words[side] & POINT_MASK, words[side + 1] & POINT_MASK, (flags & KEPT_BY_BORDER) | BORDER, into);
  }

  private pushBorder(corner: number, into: number[]): void {
    pushEnds(this.points[corner], this.points[nextCorner(corner)], BORDER | IS_EDGE, into);
  }

  private outlinesOf(triangles: readonly number[], edges: readonly number[]): OutlineData {
    const { data, words } = this;
    const triangleCount = triangles.length;
    const edgeCount = edges.length / PRIMITIVE_WORDS;
    const primitives = new Uint32Array(paddedWords(Math.max(1, triangleCount + edgeCount), PRIMITIVE_WORDS));
    for (let i = 0; i < triangleCount; i++) {
      const o = PRIMITIVE_WORDS * triangles[i];
      for (let k = 0; k < PRIMITIVE_WORDS; k++) primitives[PRIMITIVE_WORDS * i + k] = words[o + k];
    }
    primitives.set(edges, PRIMITIVE_WORDS * triangleCount);
    // A search in the worker transfers its arrays there.
    const isTransferred = triangleCount >= SEARCHED_IN_WORKER;
    const own = <Values extends { slice(): Values }>(values: Values): Values =>
      isTransferred ? values.slice() : values;
    return data.withPrimitives({
      primitives,
      searched: isTransferred ? primitives.slice() : null,
      triangleCount,
      edgeCount,
      positions: own(this.positions),
      normals: own(this.normals),
    });
  }
}

const splitters = new WeakMap<OutlineData, PrimitiveSplitter>();

/** The splitter of outline data, made on first use. */
export function splitterOf(data: OutlineData): PrimitiveSplitter {
  let splitter = splitters.get(data);
  if (!splitter) {
    splitter = new PrimitiveSplitter(data);
    splitters.set(data, splitter);
  }
  return splitter;
}

const flagsAt = (words: Uint32Array, o: number): number =>
  (words[o] >>> POINT_BITS) | ((words[o + 1] >>> POINT_BITS) << 4);

/** Adds an edge with the same points on both sides, as borders have. */
function pushEnds(start: number, end: number, flags: number, into: number[]): void {
  into.push(
    (start | ((flags & LOW_FLAGS) << POINT_BITS)) >>> 0,
    (end | ((flags >> 4) << POINT_BITS)) >>> 0,
    start,
    end,
  );
}
