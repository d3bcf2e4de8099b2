import type { Mesh, Object3D } from 'three';
import type { FindFile } from '../common/Surroundings.js';
import { counted } from '../common/shownText.js';
import type { ReadGltf } from '../gltf/readGltf.js';
import { farCentre } from '../mesh/nearFloats.js';

/** Larger scenes would take too long to convert to glTF, and would not be animated anyway. */
const MAX_VERTICES = 300_000;

/** Vertices farther from their mesh's origin than this multiple of its size are too coarse in glTF's single precision. */
const MAX_DISTANCE = 1000;

/**
 * Reads an animated scene by converting it to glTF, whose reader checks and keeps motion.
 *
 * @param root with its clips; unusable afterwards
 * @returns undefined if nothing moves, or the motion cannot be shown
 */
export async function readMoving(root: Object3D, name: string, findFile: FindFile): Promise<ReadGltf | undefined> {
  if (root.animations.length === 0 || countVertices(root) > MAX_VERTICES || isFar(root)) return undefined;
  try {
    const { sceneToGltf } = await import('./sceneToGltf.js');
    const { glb, pictures, leftOut } = await sceneToGltf(root);
    const { readGltf } = await import('../gltf/readGltf.js');
    const read = await readGltf(glb, name, true, async (uri) => {
      const inside = pictures.get(uri);
      return inside ? new Uint8Array(await inside.arrayBuffer()) : findFile(uri);
    });
    if (!('arrays' in read.content) || !moves(read.content.json)) return undefined;
    const notes = leftOut > 0 ? [counted(leftOut, 'damaged animation track', 'left out')] : [];
    return { ...read, notes: [...read.notes, ...notes] };
  } catch {
    // The scene is then shown at rest.
    return undefined;
  }
}

const moves = (json: { animations?: unknown[] }): boolean => (json.animations?.length ?? 0) > 0;

/** Whether a mesh's vertices lie far from its origin. */
function isFar(root: Object3D): boolean {
  let isFound = false;
  root.traverse((object) => {
    const position = (object as Partial<Mesh>).geometry?.getAttribute('position');
    isFound ||= position !== undefined && farCentre(position.array, MAX_DISTANCE) !== undefined;
  });
  return isFound;
}

function countVertices(root: Object3D): number {
  let vertices = 0;
  root.traverse((object) => {
    vertices += (object as Partial<Mesh>).geometry?.getAttribute('position')?.count ?? 0;
  });
  return vertices;
}
