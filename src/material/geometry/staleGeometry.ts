import type { BufferGeometry } from 'three';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { identityOf } from './identityOf.js';

/** Checksums of a geometry from when it was baked or first seen, which show whether its attributes were replaced since. */
interface Checksums {
  vertices: number;
  positions: number;
  hatchNormals: number;
}

/** The cached result of a comparison: whether an array of positions differs from that of a bake. */
interface Verdict {
  bake: object;
  isStale: boolean;
}

/** The greatest number of vertices that enter a checksum. */
const MAX_SUMMED = 4096;

/** Keyed by the identity of `userData.hatching`, an object that the clones of a geometry share. */
const bakes = new WeakMap<object, Checksums>();
/** Keyed by arrays of positions, so that each array is compared only once, and not in every frame. */
const verdicts = new WeakMap<ArrayLike<number>, Verdict>();

/** Stores the checksums of a geometry that has just been prepared. */
export function rememberPositions(geometry: BufferGeometry): void {
  const bake = identityOf(geometry.userData.hatching);
  bakes.set(bake, checksumsOf(geometry));
  verdicts.set(geometry.attributes.position.array, { bake, isStale: false });
}

/**
 * Whether the positions of a prepared geometry are no longer those of the bake. A geometry whose bake is unknown, for example because
 * it was loaded, counts as fresh when it is first seen. Allocates only when it first sees an array.
 */
export function isStale(geometry: BufferGeometry): boolean {
  const { attributes, userData } = geometry;
  // The geometry of a BatchedMesh has no statistics.
  if (typeof userData.hatching !== 'object' || userData.hatching === null) return false;
  const { position } = attributes;
  // An array that was freed after the upload cannot have changed.
  if (!position?.array || !attributes[hatchNormal.name]?.array) return false;
  if ('version' in position && position.version > 0) return true;
  const bake = identityOf(userData.hatching);
  const known = verdicts.get(position.array);
  if (known?.bake === bake) return known.isStale;
  const baked = bakes.get(bake);
  if (baked === undefined) {
    rememberPositions(geometry);
    return false;
  }
  const verdict = { bake, isStale: hasOtherPositions(checksumsOf(geometry), baked) };
  verdicts.set(position.array, verdict);
  return verdict.isStale;
}

/**
 * Whether the positions alone have changed. If the hatch normals have changed too, these are other vertices, as after `mergeVertices`.
 */
const hasOtherPositions = (now: Checksums, baked: Checksums): boolean =>
  now.hatchNormals === baked.hatchNormals && (now.vertices !== baked.vertices || now.positions !== baked.positions);

function checksumsOf({ attributes: { position, [hatchNormal.name]: normal } }: BufferGeometry): Checksums {
  const step = Math.ceil(normal.count / MAX_SUMMED);
  let positions = 0;
  let hatchNormals = 0;
  for (let i = 0; i < normal.count; i += step) {
    // The weights make the sums change when vertices or axes are swapped.
    positions += (i + 1) * (position.getX(i) + 2 * position.getY(i) + 3 * position.getZ(i));
    hatchNormals += (i + 1) * (normal.getX(i) + 2 * normal.getY(i) + 3 * normal.getZ(i));
  }
  return { vertices: position.count, positions, hatchNormals };
}
