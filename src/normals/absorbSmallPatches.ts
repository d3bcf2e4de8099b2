import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, triangleOf } from '../mesh/corners.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { Fans } from './buildFans.js';
import { disjointSets, join, rootOf } from './disjointSets.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

const NO_FAN = 0xffffffff;

/**
 * Moves the corners of specks, in place, to the largest fan at their vertex that is not of a speck, if there is one. A
 * speck is a patch of triangles, bounded by edges without twins, of less than `smallestArea`: the folds, spikes and doubled
 * triangles of scans and of decimated meshes, and all degenerate triangles. They are too small for a stroke of their own.
 * A form that is small all over keeps its edges. The numbers of the fans left over stay unused.
 */
export function* absorbSmallPatches(
  adjacency: Adjacency,
  { ofCorner, count }: Fans,
  smallestArea: number,
): Generator<number, void, void> {
  const { canonicalCorners, areaNormals } = adjacency;
  const cornerCount = ofCorner.length;
  const patches = disjointSets(cornerCount / 3);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => joinRange(adjacency, patches, start, end)),
    0,
    0.4,
  );
  const patchAreas = new Float64Array(cornerCount / 3);
  const fanAreas = new Float64Array(count);
  yield* asPhase(
    forEachChunk(cornerCount / 3, (start, end) =>
      addAreas(areaNormals, ofCorner, patches, patchAreas, fanAreas, start, end),
    ),
    0.4,
    0.6,
  );
  const isSpeck = (corner: number) => !(patchAreas[rootOf(patches, triangleOf(corner))] >= smallestArea);
  let vertexCount = 0;
  for (let corner = 0; corner < cornerCount; corner++)
    vertexCount = Math.max(vertexCount, canonicalCorners[corner] + 1);
  const hosts = new Uint32Array(vertexCount).fill(NO_FAN);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) =>
      findHosts(canonicalCorners, ofCorner, fanAreas, isSpeck, hosts, start, end),
    ),
    0.6,
    0.8,
  );
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => moveRange(canonicalCorners, ofCorner, isSpeck, hosts, start, end)),
    0.8,
    1,
  );
}

function joinRange({ twins, canonicalCorners }: Adjacency, patches: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin === NO_TWIN || twin < corner || canonicalCorners[corner] === canonicalCorners[twin]) continue;
    join(patches, triangleOf(corner), triangleOf(twin));
  }
}

/** Adds the areas of some triangles to those of their patches and of their fans. */
function addAreas(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  patches: Uint32Array,
  patchAreas: Float64Array,
  fanAreas: Float64Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const x = areaNormals[3 * triangle];
    const y = areaNormals[3 * triangle + 1];
    const z = areaNormals[3 * triangle + 2];
    const area = 0.5 * Math.sqrt(x * x + y * y + z * z);
    patchAreas[rootOf(patches, triangle)] += area;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) fanAreas[ofCorner[corner]] += area;
  }
}

/** Keeps, for each canonical vertex, the largest fan that is not of a speck. */
function findHosts(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  fanAreas: Float64Array,
  isSpeck: (corner: number) => boolean,
  hosts: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const vertex = canonicalCorners[corner];
    const fan = ofCorner[corner];
    const host = hosts[vertex];
    if (host === fan || isSpeck(corner)) continue;
    if (host === NO_FAN || fanAreas[fan] > fanAreas[host]) hosts[vertex] = fan;
  }
}

function moveRange(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  isSpeck: (corner: number) => boolean,
  hosts: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const host = hosts[canonicalCorners[corner]];
    if (host !== NO_FAN && host !== ofCorner[corner] && isSpeck(corner)) ofCorner[corner] = host;
  }
}
