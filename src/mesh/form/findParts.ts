import { findPatches } from '../normals/findPatches.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** The connected parts of a mesh. Each is a shape of its own: sizes on it are relative to the part, not to the whole. */
export interface Parts {
  /** For each triangle its part. */
  ofTriangle: Uint32Array;
  /** For each part its bounding radius, as a share of that of the mesh. */
  shares: Float32Array<ArrayBuffer>;
}

/** Smaller parts count as having this share of the mesh: lines are coarser than their form. */
const SMALLEST_SHARE = 0.01;

/** Floats per part in boxes: the least x, y, z, then the largest. */
const BOX_FLOATS = 6;

/**
 * Finds the parts of a mesh.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`), and not yet at creases
 * @param radius the bounding radius of the mesh
 */
export function* findParts(
  mesh: TriangleMesh,
  twins: Int32Array<ArrayBuffer>,
  areaNormals: Float64Array<ArrayBuffer>,
  radius: number,
): Generator<number, Parts, void> {
  const { ofTriangle, areas } = yield* asPhase(findPatches({ twins, areaNormals }), 0, 0.6);
  const shares = new Float32Array(areas.length).fill(1);
  // The only part is the mesh.
  if (areas.length === 1) return { ofTriangle, shares };
  const boxes = new Float64Array(BOX_FLOATS * areas.length);
  for (let i = 0; i < boxes.length; i++) boxes[i] = i % BOX_FLOATS < 3 ? Infinity : -Infinity;
  yield* asPhase(
    forEachChunk(twins.length, (start, end) => encloseRange(mesh, ofTriangle, boxes, start, end)),
    0.6,
    0.8,
  );
  const squares = new Float64Array(areas.length);
  yield* asPhase(
    forEachChunk(twins.length, (start, end) => reachRange(mesh, ofTriangle, boxes, squares, start, end)),
    0.8,
    1,
  );
  for (let part = 0; part < shares.length; part++)
    shares[part] = Math.min(1, Math.max(SMALLEST_SHARE, Math.sqrt(squares[part]) / (radius || 1)));
  return { ofTriangle, shares };
}

function encloseRange(
  { positions, indices }: TriangleMesh,
  ofTriangle: Uint32Array,
  boxes: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const box = BOX_FLOATS * ofTriangle[Math.floor(corner / 3)];
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * indices[corner] + axis];
      boxes[box + axis] = Math.min(boxes[box + axis], value);
      boxes[box + 3 + axis] = Math.max(boxes[box + 3 + axis], value);
    }
  }
}

/** Finds the square of the largest distance of the corners of each part from the middle of its box. */
function reachRange(
  { positions, indices }: TriangleMesh,
  ofTriangle: Uint32Array,
  boxes: Float64Array,
  squares: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const part = ofTriangle[Math.floor(corner / 3)];
    let square = 0;
    for (let axis = 0; axis < 3; axis++) {
      const middle = 0.5 * (boxes[BOX_FLOATS * part + axis] + boxes[BOX_FLOATS * part + 3 + axis]);
      square += (positions[3 * indices[corner] + axis] - middle) ** 2;
    }
    squares[part] = Math.max(squares[part], square);
  }
}
