import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { cosineBetween, doubleArea } from '../computeAreaNormals.js';
import { NO_TWIN, triangleOf } from '../corners.js';
import { chunkPhase, forEachChunk, release } from '../phases.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

/** Keeps rounding from treating equal edges differently on a mesh built with exactly the crease angle. */
const COSINE_TOLERANCE = 1e-6;

/**
 * Sets the twins of an edge to NO_TWIN, in place, where the normals of its two triangles differ by `creaseAngle` radians or
 * more. The neighbour then contributes nothing (Suarez et al., section 3.3: the faces of a cube do not influence each
 * other).
 */
export function* cutCreases(adjacency: Adjacency, creaseAngle: number): Generator<number, void, void> {
  const creaseCosine = Math.cos(creaseAngle) + COSINE_TOLERANCE;
  yield* forEachChunk(adjacency.twins.length, (start, end) => cutCreasesRange(adjacency, creaseCosine, start, end));
}

function cutCreasesRange(
  { twins, canonicalCorners, areaNormals }: Adjacency,
  creaseCosine: number,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin < corner) continue;
    const cosine = cosineBetween(areaNormals, triangleOf(corner), triangleOf(twin));
    // A triangle with the opposite winding has its normal on the other side.
    const isInconsistent = canonicalCorners[corner] === canonicalCorners[twin];
    if ((isInconsistent ? -cosine : cosine) > creaseCosine) continue;
    twins[corner] = NO_TWIN;
    twins[twin] = NO_TWIN;
  }
}

/**
 * An edge is sharp if the filtered normals of its triangles differ by more than this. It is below 60°, so that the edges of a
 * hexagonal prism stay sharp, and above 45°, so that an octagonal prism counts as round.
 */
const CREASE_DEGREES = 50;

/** The crease angle as the squared distance between the tips of two unit normals. */
const CREASE_DISTANCE_SQUARED = 2 - 2 * Math.cos((CREASE_DEGREES * Math.PI) / 180);

/** Its inverse: divisions would take several times as long as multiplications. */
const PER_CREASE_DISTANCE_SQUARED = 1 / CREASE_DISTANCE_SQUARED;

/** Number of passes; four remove all edges from a plane whose triangles are tilted at random by up to 40°. */
const PASSES = 4;

/**
 * Sets the twins of every sharp edge to NO_TWIN, in place. The noise of a scan tilts small triangles more than some sharp edges
 * do, so the angle is measured between filtered normals. Each normal is averaged with those of the neighbours, weighted by area
 * and by similarity, with weight zero beyond the crease angle (bilateral filtering of normals: Zheng, Fu, Au and Tai, 2011).
 * This removes noise, but the faces of a cube do not influence each other.
 *
 * @param twins without those of edges where the windings contradict each other (`consistentTwins`)
 */
export function* cutSharpEdges(twins: Int32Array, areaNormals: Float64Array): Generator<number, void, void> {
  const count = areaNormals.length / 3;
  const areas = new Float64Array(count);
  let normals = new Float32Array(3 * count);
  let filtered = new Float32Array(3 * count);
  const share = 1 / (PASSES + 2);
  yield* chunkPhase(count, 0, share, (start, end) => splitRange(areaNormals, areas, normals, start, end));
  for (let pass = 1; pass <= PASSES; pass++) {
    yield* chunkPhase(count, pass * share, (pass + 1) * share, (start, end) =>
      filterRange(twins, areas, normals, filtered, start, end),
    );
    [normals, filtered] = [filtered, normals];
  }
  yield* chunkPhase(3 * count, 1 - share, 1, (start, end) => cutRange(normals, twins, start, end));
  release(areas, normals, filtered);
}

/** Splits the area normals of a range of triangles into double areas and unit normals. */
function splitRange(
  areaNormals: Float64Array,
  areas: Float64Array,
  normals: Float32Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const area = doubleArea(areaNormals, triangle);
    areas[triangle] = area;
    if (area === 0) continue;
    normals[3 * triangle] = areaNormals[3 * triangle] / area;
    normals[3 * triangle + 1] = areaNormals[3 * triangle + 1] / area;
    normals[3 * triangle + 2] = areaNormals[3 * triangle + 2] / area;
  }
}

function filterRange(
  twins: Int32Array,
  areas: Float64Array,
  normals: Float32Array,
  filtered: Float32Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const own = areas[triangleOf(first)];
    const x = normals[first];
    const y = normals[first + 1];
    const z = normals[first + 2];
    let sumX = own * x;
    let sumY = own * y;
    let sumZ = own * z;
    for (let corner = first; corner < first + 3; corner++) {
      const twin = twins[corner];
      if (twin === NO_TWIN) continue;
      const neighbour = triangleOf(twin);
      const neighbourX = normals[3 * neighbour];
      const neighbourY = normals[3 * neighbour + 1];
      const neighbourZ = normals[3 * neighbour + 2];
      const dx = neighbourX - x;
      const dy = neighbourY - y;
      const dz = neighbourZ - z;
      const similarity = 1 - (dx * dx + dy * dy + dz * dz) * PER_CREASE_DISTANCE_SQUARED;
      if (similarity <= 0) continue;
      const weight = similarity * similarity * areas[neighbour];
      sumX += weight * neighbourX;
      sumY += weight * neighbourY;
      sumZ += weight * neighbourZ;
    }
    // Every term lies within the crease angle of the triangle's normal, so the sum cannot cancel to zero.
    const length = Math.sqrt(sumX * sumX + sumY * sumY + sumZ * sumZ) || 1;
    filtered[first] = sumX / length;
    filtered[first + 1] = sumY / length;
    filtered[first + 2] = sumZ / length;
  }
}

/** Cuts the edges whose first halves lie in a range, both halves at once. */
function cutRange(normals: Float32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin < corner) continue;
    const a = 3 * triangleOf(corner);
    const b = 3 * triangleOf(twin);
    const dx = normals[a] - normals[b];
    const dy = normals[a + 1] - normals[b + 1];
    const dz = normals[a + 2] - normals[b + 2];
    if (!(dx * dx + dy * dy + dz * dz > CREASE_DISTANCE_SQUARED)) continue;
    twins[corner] = NO_TWIN;
    twins[twin] = NO_TWIN;
  }
}
