import type { TriangleMesh } from './internals.js';

/** A torus of about `triangles` triangles without normals, in typed arrays: three's own would first be a list of numbers. */
export function torusMesh(triangles: number): TriangleMesh {
  const side = Math.round(Math.sqrt(triangles / 2));
  const positions = new Float32Array(3 * side * side);
  const indices = new Uint32Array(6 * side * side);
  for (let j = 0; j < side; j++) {
    const v = (2 * Math.PI * j) / side;
    for (let i = 0; i < side; i++) {
      const u = (2 * Math.PI * i) / side;
      const vertex = j * side + i;
      positions[3 * vertex] = (0.7 + 0.3 * Math.cos(v)) * Math.cos(u);
      positions[3 * vertex + 1] = (0.7 + 0.3 * Math.cos(v)) * Math.sin(u);
      positions[3 * vertex + 2] = 0.3 * Math.sin(v);
      const right = j * side + ((i + 1) % side);
      const up = ((j + 1) % side) * side + i;
      const across = ((j + 1) % side) * side + ((i + 1) % side);
      indices.set([vertex, right, across, vertex, across, up], 6 * vertex);
    }
  }
  return { positions, indices };
}
