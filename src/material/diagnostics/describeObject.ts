import type { Object3D } from 'three';

/**
 * Names an object for a message by its type, its name and its path, as in `Mesh "crate" at Scene/Group[0]/crate`. An object without
 * a name stands in the path with its type and its place among the children of its parent.
 */
export function describeObject(object: Object3D): string {
  const { name } = object;
  const type = typeOf(object);
  const title = name ? `${type} "${name}"` : type;
  const steps: string[] = [];
  const seen = new Set<Object3D>();
  // The set ends the walk where an object is its own descendant.
  for (let step: Object3D | null = object; step !== null && !seen.has(step); step = step.parent) {
    seen.add(step);
    steps.unshift(stepTo(step));
  }
  return steps.length > 1 ? `${title} at ${steps.join('/')}` : title;
}

function stepTo(object: Object3D): string {
  if (object.name || !object.parent) return object.name || typeOf(object);
  return `${typeOf(object)}[${object.parent.children.indexOf(object)}]`;
}

/** three.js calls batches and instances "Mesh", too. */
function typeOf(object: Object3D): string {
  if ('isBatchedMesh' in object) return 'BatchedMesh';
  return 'isInstancedMesh' in object ? 'InstancedMesh' : object.type;
}
