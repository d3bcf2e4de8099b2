import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, triangleOf } from '../mesh/corners.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { writeNormalized } from './writeNormalized.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

/**
 * Triangles whose normals differ by more than this make an edge of the form. Below 60°, so that every edge that is meant
 * as one stays (a hexagonal prism has 60°); above 45°, so that an octagon still passes for a circle.
 */
const CREASE_DEGREES = 50;

/** The same as the square of the distance between the tips of the two unit normals. */
const CREASE_DISTANCE_SQUARED = 2 - 2 * Math.cos((CREASE_DEGREES * Math.PI) / 180);

/** Enough that a plane whose triangles are tilted by up to 40° at random has no edge left. */
const PASSES = 4;

/**
 * The twins without those across an edge of the form: NO_TWIN there. Scan noise tilts small triangles by more than many
 * an edge, so the angle is not measured between the triangles as they are: their normals are first averaged with those
 * of their neighbours, each weighted by area and by how alike the two are, and not at all beyond the crease angle
 * (bilateral filtering of normals: Zheng, Fu, Au and Tai, 2011). So noise goes, and the faces of a cube know nothing of
 * each other.
 */
export function* cutSharpEdges(adjacency: Adjacency): Generator<number, Int32Array<ArrayBuffer>, void> {
  const { areaNormals } = adjacency;
  const count = areaNormals.length / 3;
  const twins = adjacency.twins.slice();
  const areas = new Float64Array(count);
  let normals = new Float32Array(3 * count);
  let filtered = new Float32Array(3 * count);
  const share = 1 / (PASSES + 2);
  yield* asPhase(
    forEachChunk(count, (start, end) => splitRange(areaNormals, areas, normals, start, end)),
    0,
    share,
  );
  for (let pass = 1; pass <= PASSES; pass++) {
    yield* asPhase(
      forEachChunk(count, (start, end) => filterRange(adjacency, areas, normals, filtered, start, end)),
      pass * share,
      (pass + 1) * share,
    );
    [normals, filtered] = [filtered, normals];
  }
  yield* asPhase(
    forEachChunk(3 * count, (start, end) => cutRange(adjacency.twins, normals, twins, start, end)),
    1 - share,
    1,
  );
  return twins;
}

/** Splits the area normals of some triangles into area (twice) and direction. */
function splitRange(
  areaNormals: Float64Array,
  areas: Float64Array,
  normals: Float32Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const x = areaNormals[3 * triangle];
    const y = areaNormals[3 * triangle + 1];
    const z = areaNormals[3 * triangle + 2];
    areas[triangle] = Math.sqrt(x * x + y * y + z * z);
    writeNormalized(areaNormals, 3 * triangle, normals, 3 * triangle);
  }
}

function filterRange(
  { twins, canonicalCorners }: Adjacency,
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
      if (twin === NO_TWIN || canonicalCorners[corner] === canonicalCorners[twin]) continue;
      const neighbour = triangleOf(twin);
      const neighbourX = normals[3 * neighbour];
      const neighbourY = normals[3 * neighbour + 1];
      const neighbourZ = normals[3 * neighbour + 2];
      const dx = neighbourX - x;
      const dy = neighbourY - y;
      const dz = neighbourZ - z;
      const likeness = 1 - (dx * dx + dy * dy + dz * dz) / CREASE_DISTANCE_SQUARED;
      if (likeness <= 0) continue;
      const weight = likeness * likeness * areas[neighbour];
      sumX += weight * neighbourX;
      sumY += weight * neighbourY;
      sumZ += weight * neighbourZ;
    }
    // All that is summed lies within the crease angle of the own normal, so it cannot cancel.
    const length = Math.sqrt(sumX * sumX + sumY * sumY + sumZ * sumZ) || 1;
    filtered[first] = sumX / length;
    filtered[first + 1] = sumY / length;
    filtered[first + 2] = sumZ / length;
  }
}

function cutRange(before: Int32Array, normals: Float32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = before[corner];
    if (twin === NO_TWIN) continue;
    const a = 3 * triangleOf(corner);
    const b = 3 * triangleOf(twin);
    const dx = normals[a] - normals[b];
    const dy = normals[a + 1] - normals[b + 1];
    const dz = normals[a + 2] - normals[b + 2];
    if (dx * dx + dy * dy + dz * dz > CREASE_DISTANCE_SQUARED) twins[corner] = NO_TWIN;
  }
}
