import type { PlainMesh } from './PlainMesh.js';

/** Places that count as one, along the radius of a fitted mesh. */
const CELLS = 96;

/**
 * A coarse copy of a mesh that fits into the unit sphere: vertices in the same cell of a grid are one, in their mean place. It takes about
 * a second for ten million triangles, and keeps some hundred thousand of them.
 */
export function clusterMesh({ positions, colors, indices }: PlainMesh): PlainMesh {
  const side = 2 * CELLS + 2;
  const numbers = new Int32Array(side ** 3);
  const count = positions.length / 3;
  const clusterOf = new Uint32Array(count);
  let clusters = 0;
  for (let i = 0; i < count; i++) {
    let cell = 0;
    for (let axis = 2; axis >= 0; axis--) cell = cell * side + Math.floor((positions[3 * i + axis] + 1) * CELLS);
    if (numbers[cell] === 0) numbers[cell] = ++clusters;
    clusterOf[i] = numbers[cell] - 1;
  }
  const sizes = new Uint32Array(clusters);
  for (let i = 0; i < count; i++) sizes[clusterOf[i]]++;
  const means = (values: Float32Array): Float32Array => {
    const sums = new Float64Array(3 * clusters);
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < 3; k++) sums[3 * clusterOf[i] + k] += values[3 * i + k];
    }
    return Float32Array.from(sums, (sum, i) => sum / sizes[Math.floor(i / 3)]);
  };
  return {
    positions: means(positions),
    normals: null,
    colors: colors && means(colors),
    indices: joinCorners(indices, clusterOf),
  };
}

/** The triangles whose corners are three different vertices still. */
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
