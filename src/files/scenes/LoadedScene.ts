import type { Object3D } from 'three';
import { ModelError } from '../common/ModelError.js';
import { withoutBackground } from './withoutBackground.js';

/** What one of three's loaders made of a file. Its textures hold links to their pictures. */
export interface LoadedScene {
  root: Object3D;
  /** The names of files that it asks for and that were not dropped. */
  missing?: string[];
  /** What else the caption is to say. */
  notes?: string[];
}

/**
 * The scene of a loader, without a background.
 *
 * @param root what the loader returned: some return nothing for a damaged file
 * @throws ModelError if there is none
 */
export function sceneOf(root: Object3D | undefined, name: string): LoadedScene {
  if (!root) throw new ModelError(`${name} could not be read; its outline seems to be damaged.`);
  return { root: withoutBackground(root) };
}
