import type { InstancedMesh, Object3D } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { fitWeights } from './GltfGeometry.js';

/**
 * Gives instanced meshes the influences of their morph targets, which three's loader forgets: the renderer throws an error where a geometry
 * has morph targets and its mesh has no influences. All instances of a mesh are in the same pose.
 */
export class InstanceShapes implements GLTFLoaderPlugin {
  readonly name = 'instance shapes';

  constructor(private readonly parser: GLTFParser) {}

  /** It runs before the loader binds clips to what they move. */
  async loadNode(index: number): Promise<Object3D> {
    const node = await this.parser.loadNode(index);
    const { nodes, meshes } = this.parser.json;
    const mesh = meshes[nodes[index].mesh];
    const names: string[] | undefined = mesh?.extras?.targetNames;
    // A mesh of several primitives is a group. Objects below other nodes have their influences already.
    for (const part of [node, ...node.children]) {
      if (!isShapeless(part)) continue;
      const shapes = Object.values(part.geometry.morphAttributes)[0]?.length ?? 0;
      part.morphTargetInfluences = fitWeights(nodes[index].weights ?? mesh.weights ?? [], shapes);
      part.morphTargetDictionary = Object.fromEntries(
        part.morphTargetInfluences.map((_, i) => [names?.[i] ?? String(i), i]),
      );
    }
    return node;
  }
}

/** Whether an object is an instanced mesh with morph targets but without influences. */
function isShapeless(object: Object3D): object is InstancedMesh {
  if (!('isInstancedMesh' in object)) return false;
  const { geometry, morphTargetInfluences } = object as InstancedMesh;
  return Object.keys(geometry.morphAttributes).length > 0 && !morphTargetInfluences;
}
