/**
 * A closed surface as a scanner gives it: a torus with folds, pores and noise, none of which is flat anywhere. It has twice `side` ×
 * `side` triangles, and a radius of about 1.
 *
 * @param {number} side
 * @returns {{ positions: Float32Array<ArrayBuffer>, indices: Uint32Array<ArrayBuffer> }}
 */
export function scannedTorus(side) {
  const positions = new Float32Array(3 * side * side);
  const indices = new Uint32Array(6 * side * side);
  let noise = 1;
  for (let j = 0; j < side; j++) {
    const v = (2 * Math.PI * j) / side;
    for (let i = 0; i < side; i++) {
      const u = (2 * Math.PI * i) / side;
      noise = (Math.imul(noise, 1664525) + 1013904223) >>> 0;
      const folds = 0.02 * Math.sin(9 * u + 2 * Math.sin(5 * v));
      const pores = 0.002 * Math.sin(90 * u) * Math.sin(60 * v);
      const tube = 0.28 + folds + pores + 2e-5 * (noise / 2 ** 31 - 1);
      const vertex = j * side + i;
      positions[3 * vertex] = (0.68 + tube * Math.cos(v)) * Math.cos(u);
      positions[3 * vertex + 1] = (0.68 + tube * Math.cos(v)) * Math.sin(u);
      positions[3 * vertex + 2] = tube * Math.sin(v);
      const right = j * side + ((i + 1) % side);
      const up = ((j + 1) % side) * side + i;
      const across = ((j + 1) % side) * side + ((i + 1) % side);
      indices.set([vertex, right, across, vertex, across, up], 6 * vertex);
    }
  }
  return { positions, indices };
}
