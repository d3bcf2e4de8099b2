import type { ThreeElements } from '@react-three/fiber';
import type { ReactNode } from 'react';
import type { Object3D } from 'three';
import type { ApplyHatchingOptions, HatchedScene } from 'three-hatching';

/** The options of `applyHatching` that are props of `<Hatched>`, which sets the others itself. */
export type HatchedOptions = Omit<ApplyHatchingOptions, 'signal' | 'replaces' | 'renderer' | 'camera' | 'invalidate'>;
/** The group props of `<Hatched>`. */
export type HatchedGroupProps = Omit<
  ThreeElements['group'],
  keyof ApplyHatchingOptions | 'object' | 'onError' | 'children'
>;

/**
 * The props of `<Hatched>`: the options of `applyHatching`, those below, and all props of a group.
 *
 * Options may change at any time. Parameters of `material` and `outlines`, and the map, take effect in the next frame. If the geometry
 * must be prepared again, the last look is drawn until it is ready. A new function alone changes nothing: the latest function is called
 * when it is needed.
 */
export interface HatchedProps extends HatchedOptions, HatchedGroupProps {
  children?: ReactNode;
  /**
   * A loaded scene, such as `gltf.scene`, besides the children or instead of them. It is not disposed of. Pass `null` while it is
   * loading: `undefined` without children causes a warning, because it is probably a mistake.
   */
  object?: Object3D | null | undefined;
  /** Whether the children are shown with their own materials until they are hatched. Default: false, they are hidden. */
  showUnhatched?: boolean | undefined;
  /** Called whenever the scene was hatched or restyled. `hatched.skipped` lists the meshes that were left alone, and why. */
  onHatched?: ((hatched: HatchedScene) => void) | undefined;
  /** Called if the scene cannot be hatched; it is then shown unhatched. By default the error goes to the nearest error boundary. */
  onError?: ((error: unknown) => void) | undefined;
}

const OPTION_NAMES: Record<keyof HatchedOptions, true> = {
  preset: true,
  material: true,
  outlines: true,
  form: true,
  tonalArtMap: true,
  tilesPerWorldUnit: true,
  adjacency: true,
  layout: true,
  creaseAngle: true,
  smoothingRadius: true,
  weldTolerance: true,
  detail: true,
  filter: true,
  onGeometry: true,
  onFormProgress: true,
  onProgress: true,
  createWorker: true,
};

/** Separates the options of hatching from the props of the group. */
export function splitProps(props: HatchedOptions & HatchedGroupProps): {
  options: HatchedOptions;
  group: HatchedGroupProps;
} {
  const options: Record<string, unknown> = {};
  const group: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(props)) (name in OPTION_NAMES ? options : group)[name] = value;
  return { options, group };
}
