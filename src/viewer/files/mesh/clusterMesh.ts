import type { PlainMesh } from './PlainMesh.js';

/** Grid cells along the radius of a fitted mesh. */
const CELLS = 96;

/**
 * A coarse copy of a mesh in the unit sphere: vertices in one grid cell are merged at their mean position. Takes about a second for ten
 * million triangles, and keeps some hundred thousand of them.
 */
export function clusterMesh({ positions, colors, indices }: PlainMesh): PlainMesh {
  const { clusterOf, sizes } = findClusters(positions);
  return {
    positions: meansOf(positions, clusterOf, sizes),
    normals: null,
    colors: colors && meansOf(colors, clusterOf, sizes),
    indices: joinCorners(indices, clusterOf),
  };
}

/** The cluster of each vertex, in order of first appearance, and the number of vertices per cluster. */
function findClusters(positions: Float32Array): { clusterOf: Uint32Array; sizes: Uint32Array } {
  const side = 2 * CELLS + 2;
  const numbers = new Int32Array(side ** 3);
  const clusterOf = new Uint32Array(positions.length / 3);
  let clusters = 0;
  for (let vertex = 0, i = 0; vertex < clusterOf.length; vertex++, i += 3) {
    // Planes through the centre run through the middle of cells: modelled objects often have seams there, and the two sides of a seam must
    // not fall into different cells by rounding.
    const x = ((positions[i] + 1) * CELLS + 0.5) | 0;
    const y = ((positions[i + 1] + 1) * CELLS + 0.5) | 0;
    const z = ((positions[i + 2] + 1) * CELLS + 0.5) | 0;
    const cell = (z * side + y) * side + x;
    if (numbers[cell] === 0) numbers[cell] = ++clusters;
    clusterOf[vertex] = numbers[cell] - 1;
  }
  const sizes = new Uint32Array(clusters);
  for (let vertex = 0; vertex < clusterOf.length; vertex++) sizes[clusterOf[vertex]]++;
  return { clusterOf, sizes };
}

/** The mean of three-component values over each cluster. */
function meansOf(values: Float32Array, clusterOf: Uint32Array, sizes: Uint32Array): Float32Array {
  const sums = new Float64Array(3 * sizes.length);
  for (let vertex = 0, i = 0; vertex < clusterOf.length; vertex++, i += 3) {
    const cluster = 3 * clusterOf[vertex];
    sums[cluster] += values[i];
    sums[cluster + 1] += values[i + 1];
    sums[cluster + 2] += values[i + 2];
  }
  const means = new Float32Array(sums.length);
  for (let cluster = 0, i = 0; cluster < sizes.length; cluster++, i += 3) {
    for (let k = i; k < i + 3; k++) means[k] = sums[k] / sizes[cluster];
  }
  return means;
}

/** The triangles that still have three different vertices. */
function joinCorners(indices: Uint32Array | null, clusterOf: Uint32Array): Uint32Array {
  const count = indices?.length ?? clusterOf.length;
  let kept = new Uint32Array(1 << 16);
  let length = 0;
  for (let i = 0; i + 2 < count; i += 3) {
    const a = clusterOf[indices ? indices[i] : i];
    const b = clusterOf[indices ? indices[i + 1] : i + 1];
    const c = clusterOf[indices ? indices[i + 2] : i + 2];
    if (a === b || b === c || c === a) continue;
    if (length + 3 > kept.length) {
      const longer = new Uint32Array(2 * kept.length);
      longer.set(kept);
      kept = longer;
    }
    kept[length++] = a;
    kept[length++] = b;
    kept[length++] = c;
  }
  return kept.slice(0, length);
}
