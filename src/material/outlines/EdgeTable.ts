import { nextCorner } from '../../mesh/corners.js';

/** Stands for the corner of an edge that no triangle has. */
export const NO_CORNER = -1;

/** Finds the edges of triangles by the points that they begin and end at. */
export class EdgeTable {
  /** A corner + 1 in each slot; 0 in an empty one. */
  private readonly table: Uint32Array;

  /** @param points of the corners of triangles */
  constructor(private readonly points: Uint32Array) {
    let size = 16;
    while (size < 2 * points.length) size *= 2;
    this.table = new Uint32Array(size);
    for (let corner = 0; corner < points.length; corner++) {
      const slot = this.slotOf(points[corner], points[nextCorner(corner)]);
      if (this.table[slot] === 0) this.table[slot] = corner + 1;
    }
  }

  /** The corner that an edge starts at which runs from one point to another; the first, where several do. */
  find(from: number, to: number): number {
    return this.table[this.slotOf(from, to)] - 1;
  }

  /** The slot of an edge, or the empty one that it would have. */
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
