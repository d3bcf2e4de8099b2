import type { BufferGeometry } from 'three';
import { hatchNormal } from '../bake/hatchNormal.js';
import { identityOf } from './identityOf.js';

/** By identity of the geometry, the positions that a prepared geometry was baked with, or had when a clone of it was first seen. */
const bakedPositions = new WeakMap<object, ArrayLike<number>>();

/** Remembers the positions of a geometry that has just been prepared. */
export function rememberPositions(geometry: BufferGeometry): void {
  bakedPositions.set(identityOf(geometry), geometry.attributes.position.array);
}

/** Whether the positions of a prepared geometry are no longer those of the bake. Allocates nothing but on first sight of a clone. */
export function isStale(geometry: BufferGeometry): boolean {
  const { attributes, userData } = geometry;
  // A BatchedMesh fills a geometry of its own, which has no statistics.
  if (userData.hatching === undefined || attributes[hatchNormal.name] === undefined) return false;
  const { position } = attributes;
  // Memory that was freed after the upload has not changed.
  if (!position?.array) return false;
  if ('version' in position && position.version > 0) return true;
  const baked = bakedPositions.get(identityOf(geometry));
  if (baked === undefined) rememberPositions(geometry);
  return baked !== undefined && baked !== position.array;
}
