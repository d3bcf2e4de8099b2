import type { Object3D } from 'three';

/**
 * The importance of an object, from 0 to 1: `userData.hatching.importance` of the object or of its nearest ancestor that has one;
 * otherwise 1. Allocates nothing.
 */
export function importanceOf(drawn: Object3D): number {
  for (let object: Object3D | null = drawn; object !== null; object = object.parent) {
    const importance: unknown = object.userData?.hatching?.importance;
    if (typeof importance === 'number' && importance >= 0) return Math.min(importance, 1);
  }
  return 1;
}
