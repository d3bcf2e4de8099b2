import type { Object3D } from 'three';

/** What one of three's loaders made of a file. Its textures hold links to their pictures. */
export interface LoadedScene {
  root: Object3D;
  /** The names of files that it asks for and that were not dropped. */
  missing?: string[];
  /** What else the caption is to say. */
  notes?: string[];
  /** The up axis, if the loader has not turned the scene to y. */
  upAxis?: 'y' | 'z';
}
