import type { Object3D } from 'three';

/**
 * Checks that no object at, above or below `root` is below itself, which three.js would follow round until the stack is full.
 *
 * @throws Error naming the caller and the object
 */
export function assertTree(caller: string, root: Object3D): void {
  const above = new Set<Object3D>();
  for (let object: Object3D | null = root; object !== null; object = object.parent) {
    if (above.has(object)) fail(caller, object);
    above.add(object);
  }
  /** The objects from `root` to where the walk is, with the children that are left to visit. */
  const path = [{ object: root, next: 0 }];
  const onPath = new Set([root]);
  for (let last = path.at(-1); last; last = path.at(-1)) {
    const child = last.object.children[last.next++];
    if (child === undefined) {
      onPath.delete(last.object);
      path.pop();
      continue;
    }
    if (onPath.has(child)) fail(caller, child);
    onPath.add(child);
    path.push({ object: child, next: 0 });
  }
}

function fail(caller: string, { name, type, uuid }: Object3D): never {
  throw new Error(
    `${caller}: the ${type} "${name || uuid}" is below itself, so the scene has no end. Take it out of the children of what is below it.`,
  );
}
