import type { BufferGeometry } from 'three';
import { hatchNormal } from '../bake/hatchNormal.js';
import { identityOf } from './identityOf.js';

/** What a geometry had when it was baked, or first seen: enough to tell whether anything else was put in its place. */
interface Sums {
  vertices: number;
  positions: number;
  hatchNormals: number;
}

/** Whether an array of positions is that of a bake. */
interface Verdict {
  bake: object;
  isStale: boolean;
}

/** So many vertices at most are summed up. */
const MOST_SUMMED = 4096;

/** By the identity of `userData.hatching`, an object that clones of a geometry share. */
const bakes = new WeakMap<object, Sums>();
/** By the array of positions: frames must not compare again what they have compared. */
const verdicts = new WeakMap<ArrayLike<number>, Verdict>();

/** Remembers a geometry that has just been prepared. */
export function rememberPositions(geometry: BufferGeometry): void {
  const bake = identityOf(geometry.userData.hatching);
  bakes.set(bake, sumsOf(geometry));
  verdicts.set(geometry.attributes.position.array, { bake, isStale: false });
}

/**
 * Whether the positions of a prepared geometry are no longer those of the bake. One whose bake is not known, such as one that was
 * loaded, is taken as it is first seen. Allocates nothing but on first sight of an array.
 */
export function isStale(geometry: BufferGeometry): boolean {
  const { attributes, userData } = geometry;
  // A BatchedMesh fills a geometry of its own, which has no statistics.
  if (typeof userData.hatching !== 'object' || userData.hatching === null) return false;
  const { position } = attributes;
  // Memory that was freed after the upload has not changed.
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
  const verdict = { bake, isStale: hasOtherPositions(sumsOf(geometry), baked) };
  verdicts.set(position.array, verdict);
  return verdict.isStale;
}

/** Whether positions have changed and stroke normals have not. If both have, the vertices are others, as after `mergeVertices`. */
const hasOtherPositions = (now: Sums, baked: Sums): boolean =>
  now.hatchNormals === baked.hatchNormals && (now.vertices !== baked.vertices || now.positions !== baked.positions);

function sumsOf({ attributes: { position, [hatchNormal.name]: normal } }: BufferGeometry): Sums {
  const step = Math.ceil(normal.count / MOST_SUMMED);
  let positions = 0;
  let hatchNormals = 0;
  for (let i = 0; i < normal.count; i += step) {
    // Weights tell vertices and axes apart.
    positions += (i + 1) * (position.getX(i) + 2 * position.getY(i) + 3 * position.getZ(i));
    hatchNormals += (i + 1) * (normal.getX(i) + 2 * normal.getY(i) + 3 * normal.getZ(i));
  }
  return { vertices: position.count, positions, hatchNormals };
}
