import { nextCorner } from '../mesh/corners.js';
import { hashWords } from '../mesh/hashWords.js';
import { weldPositions } from '../mesh/weldPositions.js';

/** Stands for the corner of an edge that no triangle has. */
export const NO_CORNER = -1;

/** Finds the edges of triangles by where they begin and end. */
export class EdgeTable {
  /** Of each point the first one at its position. */
  private readonly places: Uint32Array;
  /** A corner + 1 in each slot; 0 in an empty one. */
  private readonly table: Uint32Array;

  /** @param points of the corners of triangles */
  constructor(
    positions: Float32Array<ArrayBuffer>,
    private readonly points: Uint32Array,
  ) {
    const welding = weldPositions(positions);
    let step = welding.next();
    while (!step.done) step = welding.next();
    this.places = step.value.canonical;
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
    const { places, points, table } = this;
    const start = places[from];
    const end = places[to];
    const mask = table.length - 1;
    let slot = hashWords(start, end, 0) & mask;
    for (;;) {
      const corner = table[slot] - 1;
      if (corner < 0) return slot;
      if (places[points[corner]] === start && places[points[nextCorner(corner)]] === end) return slot;
      slot = (slot + 1) & mask;
    }
  }
}
