import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  DRAWN_WHOLE,
  MATERIAL_BORDER,
} from '../bake/outlineLayout.js';
import { cosineBetween, isDegenerate } from '../computeAreaNormals.js';
import { NO_TWIN, nextCorner, triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { asPhase, chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** The mesh that is searched for feature edges. */
export interface FeatureSurface {
  mesh: TriangleMesh;
  /** For each corner its canonical vertex: corners at the same position share one. */
  canonicalCorners: Uint32Array;
  areaNormals: Float64Array;
  /** Twins before any edge was cut. */
  joinedTwins: Int32Array;
  /** Twins with NO_TWIN at sharp edges and where windings contradict each other. */
  sharpTwins: Int32Array;
  /** The fan of each corner. */
  ofCorner: Uint32Array;
  /** Unit normals, three per fan. */
  normals: Float32Array;
  /** The geometry group of each triangle; null if there is only one. */
  triangleGroups: Uint16Array | null;
}

/** Decides which sharp edges are drawn. */
export interface CreaseLimits {
  /**
   * Edges are creases if the normals of their triangles differ by at least this angle, in radians. With null, the edges that the
   * bake cuts as sharp are creases.
   */
  featureAngle: number | null;
  /**
   * Connected creases are drawn if they are at least this long in total, in object units. Straight lines of at least this length
   * are drawn a little beyond their ends.
   */
  creaseLength: number;
}

/** The edges that are drawn, or that the contour may run along. */
export interface FeatureEdges {
  /** Four fans per edge: left at the start, left at the end, right at the start, right at the end. A border has the left ones twice. */
  fans: Uint32Array<ArrayBuffer>;
  /** The flags of each edge (`outlineLayout.ts`). */
  flags: Uint8Array<ArrayBuffer>;
}

/** Keeps rounding from treating equal edges differently on a mesh built with exactly the crease angle. */
const COSINE_TOLERANCE = 1e-6;

/** The cosine of 30°. Cut edges with a smaller angle are no creases; a `creaseAngle` of 0 cuts such edges. */
const FLATTEST_CREASE = Math.cos(Math.PI / 6);

/** A line turns at a vertex if its two edges deviate from a straight line by more than 40°. This is |d₁ + d₂|² at that angle. */
const TURN_SQUARED = 2 - 2 * Math.cos((40 * Math.PI) / 180);

/**
 * Finds borders, creases, edges between groups, and edges that the contour may run along because the normals on their two sides
 * differ. Creases are filtered by length: those of scans are many and short, those of machine parts are long.
 */
export function* findFeatureEdges(
  surface: FeatureSurface,
  limits: CreaseLimits,
): Generator<number, FeatureEdges, void> {
  const { mesh, canonicalCorners, joinedTwins } = surface;
  const corners: number[] = [];
  const kinds: number[] = [];
  const creaseCosine = limits.featureAngle === null ? null : Math.cos(limits.featureAngle) + COSINE_TOLERANCE;
  yield* chunkPhase(mesh.indices.length, 0, 0.7, (start, end) =>
    collectRange(surface, creaseCosine, corners, kinds, start, end),
  );
  yield* asPhase(dropShortCreases(surface, corners, kinds, limits.creaseLength), 0.7, 0.85);

  // An edge without a kind is kept only if the fans on its two sides differ: the contour may run along it.
  const kept: number[] = [];
  for (let i = 0; i < corners.length; i++) if (kinds[i] !== 0 || separatesFans(surface, corners[i])) kept.push(i);
  const numbers = Uint32Array.from(kept);
  const fans = new Uint32Array(4 * numbers.length);
  const flags = new Uint8Array(numbers.length);
  for (let i = 0; i < numbers.length; i++) {
    const corner = corners[numbers[i]];
    writeFans(surface, corner, fans, 4 * i);
    flags[i] = kinds[numbers[i]];
    const twin = joinedTwins[corner];
    if (twin !== NO_TWIN && canonicalCorners[twin] === canonicalCorners[corner]) flags[i] |= CONTRARY;
  }
  markCorners(surface, corners, numbers, flags, limits.creaseLength);
  yield 1;
  return { fans, flags };
}

/** Collects the edges in a range of corners that may be feature edges, each by one of its half-edges, and their kinds. */
function collectRange(
  surface: FeatureSurface,
  creaseCosine: number | null,
  corners: number[],
  kinds: number[],
  start: number,
  end: number,
): void {
  const { areaNormals, joinedTwins, sharpTwins, canonicalCorners, triangleGroups } = surface;
  for (let corner = start; corner < end; corner++) {
    const twin = joinedTwins[corner];
    const triangle = triangleOf(corner);
    if (twin === NO_TWIN) {
      if (isDegenerate(areaNormals, triangle)) continue;
      corners.push(corner);
      kinds.push(BORDER);
      continue;
    }
    if (twin < corner) continue;
    const other = triangleOf(twin);
    let kind = triangleGroups !== null && triangleGroups[triangle] !== triangleGroups[other] ? MATERIAL_BORDER : 0;
    // Where the windings contradict each other, the angle between the triangles is unknown.
    if (canonicalCorners[corner] !== canonicalCorners[twin]) {
      const isCrease =
        creaseCosine === null
          ? sharpTwins[corner] === NO_TWIN && bends(surface, corner)
          : cosineBetween(areaNormals, triangle, other) <= creaseCosine;
      if (isCrease) kind |= CREASE;
    }
    if (kind === 0 && !separatesFans(surface, corner)) continue;
    corners.push(corner);
    kinds.push(kind);
  }
}

/** Whether the fans on the two sides of an edge differ at either end. */
function separatesFans({ ofCorner, joinedTwins, canonicalCorners }: FeatureSurface, corner: number): boolean {
  const twin = joinedTwins[corner];
  if (twin === NO_TWIN) return true;
  if (canonicalCorners[corner] === canonicalCorners[twin]) return true;
  return ofCorner[corner] !== ofCorner[nextCorner(twin)] || ofCorner[nextCorner(corner)] !== ofCorner[twin];
}

/** Whether, at the start or the end of an edge with a twin, the normals on its two sides differ by more than 30°. */
function bends({ ofCorner, joinedTwins, normals }: FeatureSurface, corner: number): boolean {
  const twin = joinedTwins[corner];
  const start = cosineOf(normals, ofCorner[corner], ofCorner[nextCorner(twin)]);
  const end = cosineOf(normals, ofCorner[nextCorner(corner)], ofCorner[twin]);
  return Math.min(start, end) < FLATTEST_CREASE;
}

const cosineOf = (normals: Float32Array, a: number, b: number): number =>
  normals[3 * a] * normals[3 * b] + normals[3 * a + 1] * normals[3 * b + 1] + normals[3 * a + 2] * normals[3 * b + 2];

function writeFans(
  { ofCorner, joinedTwins, canonicalCorners }: FeatureSurface,
  corner: number,
  fans: Uint32Array,
  target: number,
): void {
  const twin = joinedTwins[corner];
  fans[target] = ofCorner[corner];
  fans[target + 1] = ofCorner[nextCorner(corner)];
  const isBorder = twin === NO_TWIN;
  const isContrary = !isBorder && canonicalCorners[corner] === canonicalCorners[twin];
  const start = isBorder ? corner : isContrary ? twin : nextCorner(twin);
  const end = isBorder ? nextCorner(corner) : isContrary ? nextCorner(twin) : twin;
  fans[target + 2] = ofCorner[start];
  fans[target + 3] = ofCorner[end];
}

/** Removes the flag CREASE from all edges of connected creases whose total length is less than `shortest`. */
function* dropShortCreases(
  { mesh, canonicalCorners }: FeatureSurface,
  corners: readonly number[],
  kinds: number[],
  shortest: number,
): Generator<number, void, void> {
  if (shortest <= 0) return;
  const vertexCount = mesh.positions.length / 3;
  const chains = disjointSets(vertexCount);
  const ends = (i: number) => [canonicalCorners[corners[i]], canonicalCorners[nextCorner(corners[i])]] as const;
  for (let i = 0; i < corners.length; i++) if (kinds[i] & CREASE) join(chains, ...ends(i));
  yield 0.4;
  const lengths = new Float64Array(vertexCount);
  for (let i = 0; i < corners.length; i++) {
    if (kinds[i] & CREASE) lengths[rootOf(chains, ends(i)[0])] += distance(mesh.positions, ...ends(i));
  }
  yield 0.8;
  for (let i = 0; i < corners.length; i++) {
    if (kinds[i] & CREASE && lengths[rootOf(chains, ends(i)[0])] < shortest) kinds[i] &= ~CREASE;
  }
  yield 1;
}

function distance(positions: Float32Array, a: number, b: number): number {
  const x = positions[3 * b] - positions[3 * a];
  const y = positions[3 * b + 1] - positions[3 * a + 1];
  const z = positions[3 * b + 2] - positions[3 * a + 2];
  return Math.sqrt(x * x + y * y + z * z);
}

/**
 * Marks the ends of edges at which a line ends, branches or turns after a straight run of at least `shortest`. Lines are drawn a little
 * beyond such corners, as by hand, but not beyond the many corners of a scan. Only edges drawn over their whole length count.
 */
function markCorners(
  { mesh, canonicalCorners }: FeatureSurface,
  corners: readonly number[],
  numbers: Uint32Array,
  flags: Uint8Array,
  shortest: number,
): void {
  const { positions } = mesh;
  const degrees = new Uint32Array(positions.length / 3);
  const sums = new Float32Array(positions.length);
  const ends = (i: number) => {
    const corner = corners[numbers[i]];
    return [canonicalCorners[corner], canonicalCorners[nextCorner(corner)]] as const;
  };
  for (let i = 0; i < numbers.length; i++) {
    if (!(flags[i] & DRAWN_WHOLE)) continue;
    const [a, b] = ends(i);
    const length = distance(positions, a, b) || 1;
    degrees[a]++;
    degrees[b]++;
    for (let axis = 0; axis < 3; axis++) {
      const direction = (positions[3 * b + axis] - positions[3 * a + axis]) / length;
      sums[3 * a + axis] += direction;
      sums[3 * b + axis] -= direction;
    }
  }
  const isCorner = (vertex: number): boolean => {
    const x = sums[3 * vertex];
    const y = sums[3 * vertex + 1];
    const z = sums[3 * vertex + 2];
    return degrees[vertex] !== 2 || x * x + y * y + z * z > TURN_SQUARED;
  };

  // Edges that continue each other in a straight line form one run.
  const runs = disjointSets(numbers.length);
  const edgeAt = new Map<number, number>();
  for (let i = 0; i < numbers.length; i++) {
    if (!(flags[i] & DRAWN_WHOLE)) continue;
    for (const vertex of ends(i)) {
      if (isCorner(vertex)) continue;
      const other = edgeAt.get(vertex);
      if (other === undefined) edgeAt.set(vertex, i);
      else join(runs, other, i);
    }
  }
  const lengths = new Float64Array(numbers.length);
  for (let i = 0; i < numbers.length; i++) {
    if (flags[i] & DRAWN_WHOLE) lengths[rootOf(runs, i)] += distance(positions, ...ends(i));
  }
  for (let i = 0; i < numbers.length; i++) {
    if (!(flags[i] & DRAWN_WHOLE) || lengths[rootOf(runs, i)] < shortest) continue;
    const [a, b] = ends(i);
    if (isCorner(a)) flags[i] |= CORNER_AT_START;
    if (isCorner(b)) flags[i] |= CORNER_AT_END;
  }
}
