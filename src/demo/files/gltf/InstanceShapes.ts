import type { InstancedMesh, Object3D } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { fitWeights } from './GltfGeometry.js';

/**
 * Gives instances the morph targets of their mesh, which three's loader forgets: its renderer draws no geometry with morph targets on a
 * mesh without influences, but throws an error. All instances of a mesh are in the same pose.
 */
export class InstanceShapes implements GLTFLoaderPlugin {
  readonly name = 'instance shapes';

  constructor(private readonly parser: GLTFParser) {}

  /** Before clips look for what they move. */
  async loadNode(index: number): Promise<Object3D> {
    const node = await this.parser.loadNode(index);
    const { nodes, meshes } = this.parser.json;
    const mesh = meshes[nodes[index].mesh];
    const names: string[] | undefined = mesh?.extras?.targetNames;
    // A mesh of several parts is a group. What lies below other nodes has its influences already.
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

/** Whether it is an instanced mesh that has not got the influences of its morph targets. */
function isShapeless(object: Object3D): object is InstancedMesh {
  if (!('isInstancedMesh' in object)) return false;
  const { geometry, morphTargetInfluences } = object as InstancedMesh;
  return Object.keys(geometry.morphAttributes).length > 0 && !morphTargetInfluences;
}
