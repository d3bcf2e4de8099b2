import type { Object3D } from 'three';

/**
 * Names an object for a message by its type, its name and its path, such as `Mesh "crate" at Scene/Group[0]/crate`. In the path, an
 * object without a name appears as its type and its index among its parent's children.
 */
export function describeObject(object: Object3D): string {
  const { name } = object;
  const type = typeOf(object);
  const title = name ? `${type} "${name}"` : type;
  const steps: string[] = [];
  const seen = new Set<Object3D>();
  // The set ends the walk if an object is its own descendant.
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

/** The type of an object; three.js names batches and instanced meshes "Mesh" too. */
function typeOf(object: Object3D): string {
  if ('isBatchedMesh' in object) return 'BatchedMesh';
  return 'isInstancedMesh' in object ? 'InstancedMesh' : object.type;
}
