import { Triangle, Vector3 } from 'three';

/** The side of the cells in which triangles are looked for. */
const CELL = 0.02;

const cellOf = (x: number, y: number, z: number): number => ((x + 512) * 1024 + y + 512) * 1024 + z + 512;

/**
 * How far points lie from the nearest triangle of an indexed mesh, which must be nearer than 0.02.
 *
 * @returns a function of xyz
 */
export function distanceFrom(positions: Float32Array, indices: Uint32Array): (point: ArrayLike<number>) => number {
  const cells = new Map<number, number[]>();
  for (let t = 0; t < indices.length; t += 3) {
    const [low, high] = [Math.min, Math.max].map((outermost) =>
      [0, 1, 2].map((axis) =>
        Math.floor(outermost(...[0, 1, 2].map((k) => positions[3 * indices[t + k] + axis])) / CELL),
      ),
    );
    for (let x = low[0]; x <= high[0]; x++) {
      for (let y = low[1]; y <= high[1]; y++) {
        for (let z = low[2]; z <= high[2]; z++) {
          const cell = cellOf(x, y, z);
          const inCell = cells.get(cell);
          if (inCell) inCell.push(t);
          else cells.set(cell, [t]);
        }
      }
    }
  }
  const triangle = new Triangle();
  const [place, nearest] = [new Vector3(), new Vector3()];
  return (point) => {
    place.fromArray(point as number[]);
    const [x, y, z] = place.toArray().map((value) => Math.floor(value / CELL));
    let least = Infinity;
    for (let i = 0; i < 27; i++) {
      const cell = cellOf(x + (i % 3) - 1, y + (Math.floor(i / 3) % 3) - 1, z + Math.floor(i / 9) - 1);
      for (const t of cells.get(cell) ?? []) {
        triangle.a.fromArray(positions, 3 * indices[t]);
        triangle.b.fromArray(positions, 3 * indices[t + 1]);
        triangle.c.fromArray(positions, 3 * indices[t + 2]);
        least = Math.min(least, triangle.closestPointToPoint(place, nearest).distanceTo(place));
      }
    }
    return least;
  };
}
