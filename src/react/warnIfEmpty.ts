import { Children, type ReactNode } from 'react';
import type { Object3D } from 'three';
import { HatchingMaterial } from 'three-hatching';

let hasWarned = false;

/** Warns once of a `<Hatched>` that was given nothing to hatch: most likely a name that the loaded file does not have. */
export function warnIfEmpty(object: Object3D | null | undefined, children: ReactNode): void {
  if (hasWarned || object !== undefined || Children.count(children) > 0) return;
  hasWarned = true;
  if (HatchingMaterial.silent) return;
  console.warn(
    'three-hatching: <Hatched> has no children, and its object is undefined, so there is nothing to hatch. Pass gltf.scene or a node that the file has; pass null while it is being loaded.',
  );
}
