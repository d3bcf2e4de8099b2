import type { ApplyHatchingOptions } from 'three-hatching';

/** The options of `applyHatching` that are props of `<Hatched>`, which sets the others itself. */
export type HatchedOptions = Omit<ApplyHatchingOptions, 'signal' | 'renderer' | 'camera' | 'invalidate'>;

/** All options of `<Hatched>`, left out. */
export const NO_OPTIONS: Record<keyof HatchedOptions, undefined> = {
  preset: undefined,
  material: undefined,
  shadow: undefined,
  outlines: undefined,
  form: undefined,
  tonalArtMap: undefined,
  tilesPerWorldUnit: undefined,
  adjacency: undefined,
  layout: undefined,
  creaseAngle: undefined,
  smoothingRadius: undefined,
  weldTolerance: undefined,
  detail: undefined,
  filter: undefined,
  onGeometry: undefined,
  onFormProgress: undefined,
  onProgress: undefined,
  createWorker: undefined,
};
