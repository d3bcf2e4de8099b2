import type { Graph } from '../../adjacency/cells.js';
import { doubleArea } from '../../computeAreaNormals.js';
import { nextCorner, previousCorner } from '../../corners.js';
import { chunkPhase } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FormSurface } from '../FormSurface.js';
import { NO_OFFSET, type SeamRelations } from './seamRelations.js';

/** The largest cotangent that is used, that of 5.7°. All three of a sliver are scaled down together, as in the heat equation. */
const LARGEST_COTANGENT = 10;

/**
 * The energy of φ, ½ Σ w(φₐ − φᵦ)² over all edges with their cotangent weights w, in terms of one value per node: of each fan,
 * and on coarser levels of each cell.
 */
export interface PhaseMatrix extends Graph {
  /** For each entry its value in the matrix. */
  values: Float64Array;
  diagonal: Float64Array;
  /** For each entry 1 if it crosses the cut, so that the values on its two sides differ by more than the rise of φ. */
  walls: Uint8Array;
  seam: SeamEdges;
}

/** The edges with an offset at one end or both. */
export interface SeamEdges {
  /** The nodes of the two ends: those of edge i are 2i and 2i + 1, here and below. */
  nodes: Uint32Array;
  /** The sign of each end: φ = sign · (value of the node) + offset. */
  signs: Int8Array;
  /** The number of each end's offset, or NO_OFFSET. */
  offsets: Int32Array;
  /** For each edge its weight. */
  weights: Float64Array;
}

/** The matrix of the fans, and the weights of the triangles. */
export interface FinePhase {
  matrix: PhaseMatrix;
  /** For each triangle its weight: 1, less in slivers, 0 in degenerate ones and around punctures, where φ is undefined. */
  shares: Float32Array;
}

/** Assembles the matrix over fans. */
export function* phaseMatrix(
  surface: FormSurface,
  seam: FormSeam,
  relations: SeamRelations,
): Generator<number, FinePhase, void> {
  const { twins, fans, heat } = surface;
  const shares = new Float32Array(twins.length / 3);
  const cotangents = new Float32Array(twins.length);
  yield* chunkPhase(shares.length, 0, 0.4, (start, end) =>
    cotangentRange(surface, seam, shares, cotangents, start, end),
  );
  const entryCount = heat.neighbours.length;
  const assembly: Assembly = {
    surface,
    wedgeOf: seam.wedges.ofCorner,
    relations,
    cotangents,
    ends: heat.starts.slice(1),
    neighbours: new Uint32Array(entryCount),
    values: new Float64Array(entryCount),
    diagonal: new Float64Array(fans.count),
    walls: new Uint8Array(entryCount),
    seam: { nodes: [], signs: [], offsets: [], weights: [] },
  };
  yield* chunkPhase(twins.length, 0.4, 1, (start, end) => scatterRange(assembly, start, end));
  const { neighbours, values, diagonal, walls } = assembly;
  // A fan without weight, or at a singular point, keeps the value 0.
  for (let fan = 0; fan < diagonal.length; fan++) if (!(diagonal[fan] > 0)) diagonal[fan] = 1;
  const matrix: PhaseMatrix = {
    starts: heat.starts,
    neighbours,
    values,
    diagonal,
    walls,
    seam: {
      nodes: Uint32Array.from(assembly.seam.nodes),
      signs: Int8Array.from(assembly.seam.signs),
      offsets: Int32Array.from(assembly.seam.offsets),
      weights: Float64Array.from(assembly.seam.weights),
    },
  };
  return { matrix, shares };
}

interface Assembly {
  surface: FormSurface;
  wedgeOf: Uint32Array;
  relations: SeamRelations;
  cotangents: Float32Array;
  /** Where the entries of each fan end; entries are filled in from there. */
  ends: Uint32Array;
  neighbours: Uint32Array;
  values: Float64Array;
  diagonal: Float64Array;
  walls: Uint8Array;
  seam: { nodes: number[]; signs: number[]; offsets: number[]; weights: number[] };
}

/** Writes half of the cotangent at each corner of a range of triangles, times the triangle's share. */
function cotangentRange(
  { mesh: { positions, indices }, areaNormals, fans: { ofCorner } }: FormSurface,
  { isPuncture }: FormSeam,
  shares: Float32Array,
  cotangents: Float32Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const area = doubleArea(areaNormals, first / 3);
    if (!(area > 0)) continue;
    if (isPuncture[ofCorner[first]] + isPuncture[ofCorner[first + 1]] + isPuncture[ofCorner[first + 2]] > 0) continue;
    const a = 3 * indices[first];
    const b = 3 * indices[first + 1];
    const c = 3 * indices[first + 2];
    const atA = dotFrom(positions, a, b, c) / area;
    const atB = dotFrom(positions, b, c, a) / area;
    const atC = dotFrom(positions, c, a, b) / area;
    const share = LARGEST_COTANGENT / Math.max(LARGEST_COTANGENT, Math.abs(atA), Math.abs(atB), Math.abs(atC));
    shares[first / 3] = share;
    cotangents[first] = 0.5 * share * atA;
    cotangents[first + 1] = 0.5 * share * atB;
    cotangents[first + 2] = 0.5 * share * atC;
  }
}

/** The scalar product of the edges from `origin` to `a` and to `b`. */
function dotFrom(positions: Float32Array, origin: number, a: number, b: number): number {
  const x = positions[origin];
  const y = positions[origin + 1];
  const z = positions[origin + 2];
  return (
    (positions[a] - x) * (positions[b] - x) +
    (positions[a + 1] - y) * (positions[b + 1] - y) +
    (positions[a + 2] - z) * (positions[b + 2] - z)
  );
}

/** Enters the edges of a range of corners. Both halves of an edge are entered with the later one, as seen from its side. */
function scatterRange(assembly: Assembly, start: number, end: number): void {
  const { surface, wedgeOf, relations, cotangents, ends, neighbours, values, diagonal, walls } = assembly;
  const { twins } = surface;
  const fanOf = surface.fans.ofCorner;
  const { signs, ofWedge } = relations;
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin >= corner) continue;
    const next = nextCorner(corner);
    const from = fanOf[corner];
    const to = fanOf[next];
    const weight = cotangents[previousCorner(corner)] + (twin < 0 ? 0 : cotangents[previousCorner(twin)]);
    const wedge = wedgeOf[corner];
    const other = wedgeOf[next];
    const sign = signs[wedge];
    const otherSign = signs[other];
    const isSeam = ofWedge[wedge] !== NO_OFFSET || ofWedge[other] !== NO_OFFSET;
    const entry = --ends[from];
    const back = --ends[to];
    neighbours[entry] = to;
    neighbours[back] = from;
    values[entry] = values[back] = -weight * sign * otherSign;
    diagonal[from] += weight * sign * sign;
    diagonal[to] += weight * otherSign * otherSign;
    if (isSeam) {
      walls[entry] = walls[back] = 1;
      addSeamEdge(assembly, from, to, wedge, other, weight);
    }
  }
}

function addSeamEdge(
  { relations, seam }: Assembly,
  from: number,
  to: number,
  wedge: number,
  other: number,
  weight: number,
): void {
  seam.nodes.push(from, to);
  seam.signs.push(relations.signs[wedge], relations.signs[other]);
  seam.offsets.push(relations.ofWedge[wedge], relations.ofWedge[other]);
  seam.weights.push(weight);
}
