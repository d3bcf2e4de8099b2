import type { Object3D } from 'three';

/**
 * Checks that no object at, above or below `root` is below itself, which three.js would follow round until the stack is full, and
 * that all children are objects.
 *
 * @throws Error or TypeError naming the caller and the object
 */
export function assertTree(caller: string, root: Object3D): void {
  const above = new Set<Object3D>();
  for (let object: Object3D | null = root; object !== null; object = object.parent) {
    if (above.has(object)) failRound(caller, object);
    above.add(object);
  }
  /** The objects from `root` to where the walk is, with the children that are left to visit. */
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
        `${caller}: child ${last.next - 1} of the ${nameOf(object)} is no THREE.Object3D. Take it out of the children.`,
      );
    }
    if (onPath.has(child)) failRound(caller, child);
    onPath.add(child);
    path.push({ object: child, next: 0 });
  }
}

const nameOf = ({ name, type, uuid }: Object3D): string => `${type} "${name || uuid}"`;

function failRound(caller: string, object: Object3D): never {
  throw new Error(
    `${caller}: the ${nameOf(object)} is below itself, so the scene has no end. Take it out of the children of what is below it.`,
  );
}
