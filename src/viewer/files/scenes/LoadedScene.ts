import { BackSide, Loader, type Material, type Mesh, type MeshBasicMaterial, type Object3D } from 'three';
import type { FileChange } from '../common/fileChanges.js';
import { ModelError } from '../common/ModelError.js';

/** Hides the sky and ground that three's VRML loader adds, in which the model would be a dot. */
function withoutBackground<Root extends Object3D>(root: Root): Root {
  root.traverse((object) => {
    const { material } = object as Partial<Mesh>;
    if (material && !Array.isArray(material) && isBackground(material)) object.visible = false;
  });
  return root;
}

const isBackground = ({ side, depthTest, depthWrite }: Material): boolean =>
  side === BackSide && !depthTest && !depthWrite;

/** The result of one of three's loaders. The images of its textures are links to pictures. */
export interface LoadedScene {
  root: Object3D;
  /** Names of files that were not dropped along. */
  missing?: string[];
  /** Further notes for the caption. */
  notes?: string[];
  /** Changes that were made to what the file says. */
  changes?: FileChange[];
}

/** Note that displacement maps are not drawn. */
export const DISPLACEMENT_NOTE = 'displacement left out';

/**
 * Wraps a loader's scene, without backgrounds and made-up colours.
 *
 * @param root the loader's result, which may be undefined for a damaged file
 * @throws ModelError if it is
 */
export function sceneOf(root: Object3D | undefined, name: string): LoadedScene {
  if (!root) throw new ModelError(`${name} could not be read; its outline seems to be damaged.`);
  root.traverse(whiteWithoutMaterial);
  return { root: withoutBackground(root) };
}

/** Makes surfaces without a material white; three's loaders make them black or magenta. */
function whiteWithoutMaterial(object: Object3D): void {
  const { isMesh, material } = object as Partial<Mesh>;
  if (!isMesh) return;
  for (const one of [material ?? []].flat() as MeshBasicMaterial[])
    if (one.name === Loader.DEFAULT_MATERIAL_NAME) one.color.set('white');
}
