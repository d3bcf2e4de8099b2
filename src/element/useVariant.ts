import type { Material, Mesh } from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { chosenIndex } from './chosenIndex.js';

const NAME = 'KHR_materials_variants';

interface Variants {
  variants?: { name?: string }[];
}

interface Mappings {
  mappings?: { material: number; variants: number[] }[];
}

/** Gives the meshes of a model the materials of a variant. @throws Error that names all variants, if there is none of this name */
export async function useVariant({ scene, parser }: GLTF, wanted: string): Promise<void> {
  const { variants = [] } = (parser.json.extensions?.[NAME] ?? {}) as Variants;
  const names = variants.map(({ name }, i) => [name ?? `Variant ${i + 1}`]);
  const index = chosenIndex('variant', names, wanted);
  const meshes: [mesh: Mesh, material: number][] = [];
  scene.traverse((object) => {
    const { mappings = [] } = (object.userData.gltfExtensions?.[NAME] ?? {}) as Mappings;
    const mapping = mappings.find((one) => one.variants.includes(index));
    if (mapping && 'isMesh' in object) meshes.push([object as Mesh, mapping.material]);
  });
  for (const [mesh, material] of meshes) {
    mesh.material = (await parser.getDependency('material', material)) as Material;
    parser.assignFinalMaterial(mesh);
  }
}
