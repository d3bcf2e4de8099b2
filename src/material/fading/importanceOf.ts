import type { Object3D } from 'three';

/**
 * How much an object matters, from 0 to 1: `userData.hatching.importance` of it, or of the nearest object above it that has one; 1 where
 * nobody says. Allocates nothing.
 */
export function importanceOf(drawn: Object3D): number {
  for (let object: Object3D | null = drawn; object !== null; object = object.parent) {
    const importance: unknown = object.userData?.hatching?.importance;
    if (typeof importance === 'number' && importance >= 0) return Math.min(importance, 1);
  }
  return 1;
}
