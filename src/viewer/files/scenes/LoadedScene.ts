import { BackSide, Loader, type Material, type Mesh, type MeshBasicMaterial, type Object3D } from 'three';
import { ModelError } from '../common/ModelError.js';

/** Hides the sky and the ground that three's loader for VRML builds around a scene: the model would be a dot in them. */
function withoutBackground<Root extends Object3D>(root: Root): Root {
  root.traverse((object) => {
    const { material } = object as Partial<Mesh>;
    if (material && !Array.isArray(material) && isBackground(material)) object.visible = false;
  });
  return root;
}

const isBackground = ({ side, depthTest, depthWrite }: Material): boolean =>
  side === BackSide && !depthTest && !depthWrite;

/** What one of three's loaders made of a file. Its textures hold links to their pictures. */
export interface LoadedScene {
  root: Object3D;
  /** The names of files that it asks for and that were not dropped. */
  missing?: string[];
  /** What else the caption is to say. */
  notes?: string[];
}

/** Says that surfaces are drawn without the pictures that move their points. */
export const DISPLACEMENT_NOTE = 'displacement left out';

/**
 * The scene of a loader, without a background and the colours that it makes up.
 *
 * @param root what the loader returned: some return nothing for a damaged file
 * @throws ModelError if there is none
 */
export function sceneOf(root: Object3D | undefined, name: string): LoadedScene {
  if (!root) throw new ModelError(`${name} could not be read; its outline seems to be damaged.`);
  root.traverse(whiteWithoutMaterial);
  return { root: withoutBackground(root) };
}

/** Surfaces without a material are white: three's loaders paint them in colours of their own, black or magenta. */
function whiteWithoutMaterial(object: Object3D): void {
  const { isMesh, material } = object as Partial<Mesh>;
  if (!isMesh) return;
  for (const one of [material ?? []].flat() as MeshBasicMaterial[])
    if (one.name === Loader.DEFAULT_MATERIAL_NAME) one.color.set('white');
}
