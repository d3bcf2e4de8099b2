import type { Object3D } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';

/**
 * Checks that all objects at or below `root` are Object3Ds, and that no object is its own descendant, which would make three.js recurse
 * without end.
 *
 * @throws Error or TypeError that names the caller and the object
 */
export function assertTree(caller: string, root: Object3D): void {
  const above = new Set<Object3D>();
  for (let object: Object3D | null = root; object !== null; object = object.parent) {
    if (above.has(object)) failCycle(caller, object);
    above.add(object);
  }
  /** The objects from `root` down to the current one, each with the index of the child to visit next. */
  const path = [{ object: root, next: 0 }];
  const onPath = new Set([root]);
  for (let last = path.at(-1); last; last = path.at(-1)) {
    const { object } = last;
    if (last.next >= object.children.length) {
      onPath.delete(object);
      path.pop();
      continue;
    }
    const child = object.children[last.next++];
    if (!child?.isObject3D) {
      throw new TypeError(
        `${caller}: child ${last.next - 1} of the ${describeObject(object)} is not a THREE.Object3D. Remove it from the children.`,
      );
    }
    if (onPath.has(child)) failCycle(caller, child);
    onPath.add(child);
    path.push({ object: child, next: 0 });
  }
}

function failCycle(caller: string, object: Object3D): never {
  throw new Error(
    `${caller}: the ${describeObject(object)} is its own descendant, so the scene has a cycle. Remove it from the children of its descendants.`,
  );
}
