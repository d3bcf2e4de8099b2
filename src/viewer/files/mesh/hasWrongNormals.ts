import { computeAreaNormals, doubleArea } from '../../../mesh/computeAreaNormals.js';
import { runToEnd } from '../../../mesh/phases.js';
import type { PlainMesh } from './PlainMesh.js';

/** The largest share of the area on which normals may be wrong. */
const MOST_WRONG = 0.3;
/** The least cosine between a right normal and its triangle's, for either side. Those of a smoothly shaded box have 0.58. */
const LEAST_COSINE = 0.5;

/**
 * Whether the normals of a file contradict its triangles: on more than 30 % of the area they lean by more than 60° from both sides. Zero
 * vectors, which are computed later, contradict nothing.
 */
export function hasWrongNormals({ positions, normals, indices }: PlainMesh): boolean {
  if (!normals) return false;
  const corners = indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const areaNormals = runToEnd(
    computeAreaNormals({ positions, indices: corners } as Parameters<typeof computeAreaNormals>[0]),
  );
  let all = 0;
  let wrong = 0;
  for (let first = 0; first + 2 < corners.length; first += 3) {
    const area = doubleArea(areaNormals, first / 3);
    all += 3 * area;
    for (let corner = first; corner < first + 3; corner++) {
      const x = normals[3 * corners[corner]];
      const y = normals[3 * corners[corner] + 1];
      const z = normals[3 * corners[corner] + 2];
      const product = x * areaNormals[first] + y * areaNormals[first + 1] + z * areaNormals[first + 2];
      if (Math.abs(product) < LEAST_COSINE * area * Math.sqrt(x * x + y * y + z * z)) wrong += area;
    }
  }
  return wrong > MOST_WRONG * all;
}
