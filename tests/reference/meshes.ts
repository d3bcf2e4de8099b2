import type { Triangle, Vec3 } from './referenceAdjacency.js';

/** A mesh as plain arrays; normals, if given, are per vertex and in object space. */
export interface PlainMesh {
  positions: number[];
  normals?: number[];
  indices: number[];
}

/** Single precision, as the card gets it. */
export const toFloat = (values: number[]) => [...new Float32Array(values)];

export function trianglesOf({ positions, indices }: PlainMesh): Triangle[] {
  const vertex = (i: number) => positions.slice(3 * i, 3 * i + 3) as Vec3;
  return Array.from({ length: indices.length / 3 }, (_, t) => [
    vertex(indices[3 * t]),
    vertex(indices[3 * t + 1]),
    vertex(indices[3 * t + 2]),
  ]);
}

/** A grid of quads over [0, 1]², mapped to space by `surface`. */
function grid(columns: number, rows: number, surface: (u: number, v: number) => Vec3): PlainMesh {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++) positions.push(...surface(i / columns, j / rows));
  }
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const a = j * (columns + 1) + i;
      const b = a + columns + 1;
      indices.push(a, a + 1, b + 1, a, b + 1, b);
    }
  }
  return { positions: toFloat(positions), indices };
}

/** Eight shared vertices, twelve triangles, faces outward. */
export const cube: PlainMesh = {
  positions: [-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1].map((x) => x * 0.6),
  indices: [4, 5, 6, 4, 6, 7, 1, 0, 3, 1, 3, 2, 5, 1, 2, 5, 2, 6, 0, 4, 7, 0, 7, 3, 7, 6, 2, 7, 2, 3, 0, 1, 5, 0, 5, 4],
};

/** Closed over both seams; the last row and column repeat the first exactly, so that they weld. */
export const torus: PlainMesh = {
  ...grid(28, 18, (u, v) => torusPoint(u, v, 0.7)),
  normals: grid(28, 18, (u, v) => torusPoint(u, v, 0).map((x) => x / 0.3) as Vec3).positions,
};

/** With a ring radius of 0, the vector from the ring to the surface. */
function torusPoint(u: number, v: number, ringRadius: number): Vec3 {
  const a = 2 * Math.PI * (u === 1 ? 0 : u);
  const b = 2 * Math.PI * (v === 1 ? 0 : v);
  const r = ringRadius + 0.3 * Math.cos(b);
  return [r * Math.cos(a), r * Math.sin(a), 0.3 * Math.sin(b)];
}

/** A wavy sheet with a border all round. */
export const sheet: PlainMesh = grid(14, 14, (u, v) => [
  2 * u - 1,
  2 * v - 1,
  0.25 * Math.sin(5 * u) * Math.cos(4 * v),
]);
