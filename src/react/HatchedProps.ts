import type { ThreeElements } from '@react-three/fiber';
import type { ReactNode } from 'react';
import type { Object3D } from 'three';
import type { ApplyHatchingOptions, HatchedScene } from 'three-hatching';

type HatchedOptions = Omit<ApplyHatchingOptions, 'signal' | 'replaces'>;
type GroupProps = Omit<ThreeElements['group'], keyof ApplyHatchingOptions | 'object' | 'onError' | 'children'>;

/**
 * What `<Hatched>` takes: the options of `applyHatching`, those below, and everything that a group takes.
 *
 * Options may change at any time. Parameters of `material` and `lines`, and the map, count from the next frame on; where the
 * geometry has to be prepared anew, the last look is drawn meanwhile. Functions are called when they are needed, and another
 * function alone changes nothing.
 */
export interface HatchedProps extends HatchedOptions, GroupProps {
  children?: ReactNode;
  /** A loaded scene, such as `gltf.scene`, beside the children or in their place. It is not disposed of. */
  object?: Object3D | undefined;
  /** Whether the children are shown with their own materials until they are hatched. Default: they are not shown. */
  showUnhatched?: boolean | undefined;
  /** Called whenever the scene has been hatched or has got new values. `hatched.skipped` says what was left as it is, and why. */
  onHatched?: ((hatched: HatchedScene) => void) | undefined;
  /** Called if the scene cannot be hatched; it is then shown as it is. Left out: the error goes to the nearest error boundary. */
  onError?: ((error: unknown) => void) | undefined;
}

const OPTION_NAMES: Record<keyof HatchedOptions, true> = {
  preset: true,
  material: true,
  lines: true,
  tonalArtMap: true,
  strokeScale: true,
  layout: true,
  creaseAngle: true,
  smoothingRadius: true,
  weldTolerance: true,
  filter: true,
  onGeometry: true,
  onProgress: true,
  createWorker: true,
};

/** Tells the options of hatching from what a group takes. */
export function splitProps(props: HatchedOptions & GroupProps): { options: HatchedOptions; group: GroupProps } {
  const options: Record<string, unknown> = {};
  const group: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(props)) (name in OPTION_NAMES ? options : group)[name] = value;
  return { options, group };
}
