import type { TriangleMesh } from '../../../src/mesh/TriangleMesh.js';
import { meshOf } from './meshes.js';

type Vector = readonly [x: number, y: number, z: number];

/** Numbers in [−1, 1), always the same ones (constants of Numerical Recipes). */
export function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
}

/** A patch of `rows` × `columns` squares, each cut along one of its diagonals by chance, over (u, v) ∈ [0, 1]². */
export function patch(
  columns: number,
  rows: number,
  place: (u: number, v: number) => Vector,
  random: () => number = noise(1),
): TriangleMesh {
  const vertices: Vector[] = [];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) vertices.push(place(column / columns, row / rows));
  }
  const triangles: number[][] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column;
      const [b, c, d] = [a + 1, a + columns + 1, a + columns + 2];
      triangles.push(
        ...(random() < 0
          ? [
              [a, b, d],
              [a, d, c],
            ]
          : [
              [a, b, c],
              [b, d, c],
            ]),
      );
    }
  }
  return meshOf(vertices, triangles);
}

/** Several meshes as one; nothing is joined but what lies at one position. */
export function together(...meshes: TriangleMesh[]): TriangleMesh {
  const positions: number[] = [];
  const indices: number[] = [];
  for (const mesh of meshes) {
    const offset = positions.length / 3;
    for (const value of mesh.positions) positions.push(value);
    for (const index of mesh.indices) indices.push(offset + index);
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** A cube from −1 to 1, every side a patch of `size`² squares with its own vertices. */
export function cube(size: number, seed = 1): TriangleMesh {
  const random = noise(seed);
  const sides: ((s: number, t: number) => Vector)[] = [
    (s, t) => [1, s, t],
    (s, t) => [-1, t, s],
    (s, t) => [t, 1, s],
    (s, t) => [s, -1, t],
    (s, t) => [s, t, 1],
    (s, t) => [t, s, -1],
  ];
  return together(...sides.map((side) => patch(size, size, (u, v) => side(2 * u - 1, 2 * v - 1), random)));
}

/** A unit sphere: a cube blown up. */
export function sphere(size: number): TriangleMesh {
  const mesh = cube(size);
  for (let i = 0; i < mesh.positions.length; i += 3) {
    // Sorted, so that vertices of two sides at one position stay there.
    const length = Math.hypot(
      ...mesh.positions
        .slice(i, i + 3)
        .map(Math.abs)
        .sort(),
    );
    for (let axis = 0; axis < 3; axis++) mesh.positions[i + axis] /= length;
  }
  return mesh;
}

/** A torus about the z axis with radii 1 and 0.4, joined at its seams by position. */
export function torus(around: number, across: number): TriangleMesh {
  return patch(around, across, (u, v) => {
    const [a, b] = [2 * Math.PI * (u % 1), 2 * Math.PI * (v % 1)];
    const radius = 1 + 0.4 * Math.cos(b);
    return [radius * Math.cos(a), radius * Math.sin(a), 0.4 * Math.sin(b)];
  });
}

/** A prism about the z axis with `sides` rectangular sides and two end faces, without shared vertices. */
export function prism(sides: number): TriangleMesh {
  const corner = (i: number, z: number): Vector => {
    const angle = (2 * Math.PI * (i % sides)) / sides;
    return [Math.cos(angle), Math.sin(angle), z];
  };
  const walls = Array.from({ length: sides }, (_, i) =>
    meshOf(
      [corner(i, -1), corner(i + 1, -1), corner(i + 1, 1), corner(i, 1)],
      [
        [0, 1, 2],
        [0, 2, 3],
      ],
    ),
  );
  const ring = Array.from({ length: sides }, (_, i) => i);
  const end = (z: number) =>
    meshOf(
      ring.map((i) => corner(i, z)),
      ring.slice(2).map((i) => (z > 0 ? [0, i - 1, i] : [0, i, i - 1])),
    );
  return together(...walls, end(1), end(-1));
}
