import { doubleArea } from '../../computeAreaNormals.js';
import { chunkPhase } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FaceDirections } from '../directions/faceDirections.js';
import type { FormSurface } from '../FormSurface.js';
import { NO_OFFSET, type SeamRelations } from './seamRelations.js';

/** The right side of the equations: the gradients that φ and φ₂ should have. Two values each, one per family of lines. */
export interface PhaseSource {
  /** For each fan the divergence of the directions around it. */
  forces: Float64Array;
  /** For each offset the force on it. */
  offsetForces: Float64Array;
  /** For each fan the mean of the gradients that its first wedge should have: x, y, z of φ, then of φ₂. */
  slopes: Float32Array;
}

/** Floats per fan in `slopes`. */
export const SLOPE_FLOATS = 6;

/** The slope of the two families, and the angle from the first to the second. */
export interface PhaseSlope {
  /** Lines per object unit. */
  slope: number;
  /** In radians. */
  crossAngle: number;
}

/**
 * Computes the right side. Directions are projected into the triangles instead of the smooth surface, so that relief bends lines.
 *
 * @param shares see `FinePhase`
 */
export function* phaseSource(
  surface: FormSurface,
  directions: FaceDirections,
  seam: FormSeam,
  relations: SeamRelations,
  shares: Float32Array,
  { slope, crossAngle }: PhaseSlope,
): Generator<number, PhaseSource, void> {
  const fanCount = surface.fans.count;
  const counts = new Uint32Array(fanCount);
  const source: PhaseSource = {
    forces: new Float64Array(2 * fanCount),
    offsetForces: new Float64Array(2 * relations.origins.length),
    slopes: new Float32Array(SLOPE_FLOATS * fanCount),
  };
  const turn = { slope, along: slope * Math.cos(crossAngle), across: slope * Math.sin(crossAngle) };
  yield* chunkPhase(shares.length, 0, 0.9, (start, end) =>
    addRange(surface, directions, seam, relations, shares, turn, source, counts, start, end),
  );
  yield* chunkPhase(fanCount, 0.9, 1, (start, end) => meanRange(source.slopes, counts, start, end));
  return source;
}

/** Adds the directions of a range of triangles to their fans. */
function addRange(
  { mesh: { positions, indices }, areaNormals, fans }: FormSurface,
  { across: u, normals }: FaceDirections,
  { flip, wedges }: FormSeam,
  { signs, ofWedge }: SeamRelations,
  shares: Float32Array,
  turn: { slope: number; along: number; across: number },
  { forces, offsetForces, slopes }: PhaseSource,
  counts: Uint32Array,
  start: number,
  end: number,
): void {
  for (let face = start; face < end; face++) {
    const first = 3 * face;
    const ux = flip[face] * u[first];
    const uy = flip[face] * u[first + 1];
    const uz = flip[face] * u[first + 2];
    const nx = normals[first];
    const ny = normals[first + 1];
    const nz = normals[first + 2];
    const x = turn.slope * ux;
    const y = turn.slope * uy;
    const z = turn.slope * uz;
    const x2 = turn.along * ux + turn.across * (ny * uz - nz * uy);
    const y2 = turn.along * uy + turn.across * (nz * ux - nx * uz);
    const z2 = turn.along * uz + turn.across * (nx * uy - ny * ux);
    // The force on a corner is half of the edge opposite to it times u × n, with the unit normal n of the triangle.
    const share = shares[face] === 0 ? 0 : (0.5 * shares[face]) / doubleArea(areaNormals, face);
    const ax = share * areaNormals[first];
    const ay = share * areaNormals[first + 1];
    const az = share * areaNormals[first + 2];
    const fx = y * az - z * ay;
    const fy = z * ax - x * az;
    const fz = x * ay - y * ax;
    const fx2 = y2 * az - z2 * ay;
    const fy2 = z2 * ax - x2 * az;
    const fz2 = x2 * ay - y2 * ax;
    for (let k = 0; k < 3; k++) {
      const corner = first + k;
      const p = 3 * indices[first + ((k + 1) % 3)];
      const q = 3 * indices[first + ((k + 2) % 3)];
      const ex = positions[q] - positions[p];
      const ey = positions[q + 1] - positions[p + 1];
      const ez = positions[q + 2] - positions[p + 2];
      const force = ex * fx + ey * fy + ez * fz;
      const force2 = ex * fx2 + ey * fy2 + ez * fz2;
      const fan = fans.ofCorner[corner];
      const wedge = wedges.ofCorner[corner];
      forces[2 * fan] += signs[wedge] * force;
      forces[2 * fan + 1] += signs[wedge] * force2;
      const offset = ofWedge[wedge];
      if (offset !== NO_OFFSET) {
        offsetForces[2 * offset] += force;
        offsetForces[2 * offset + 1] += force2;
        continue;
      }
      counts[fan]++;
      const i = SLOPE_FLOATS * fan;
      slopes[i] += x;
      slopes[i + 1] += y;
      slopes[i + 2] += z;
      slopes[i + 3] += x2;
      slopes[i + 4] += y2;
      slopes[i + 5] += z2;
    }
  }
}

function meanRange(slopes: Float32Array, counts: Uint32Array, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    const share = 1 / (counts[fan] || 1);
    for (let i = SLOPE_FLOATS * fan; i < SLOPE_FLOATS * (fan + 1); i++) slopes[i] *= share;
  }
}
