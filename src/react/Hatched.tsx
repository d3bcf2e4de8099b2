import { useFrame, useThree } from '@react-three/fiber';
import { Children, type ReactElement, type ReactNode, useEffect, useRef, useState } from 'react';
import type { Group, Object3D } from 'three';
import { HatchingMaterial } from 'three-hatching';
import { type HatchedProps, splitProps } from './HatchedProps.js';
import { Hatcher, type HatcherEvents } from './Hatcher.js';

let hasWarned = false;

/** Warns once of a `<Hatched>` that has nothing to hatch, most likely because of a name that the loaded file does not have. */
export function warnIfEmpty(object: Object3D | null | undefined, children: ReactNode): void {
  if (hasWarned || object !== undefined || Children.count(children) > 0) return;
  hasWarned = true;
  if (HatchingMaterial.silent) return;
  console.warn(
    'three-hatching: <Hatched> has no children, and its object is undefined, so there is nothing to hatch. Pass gltf.scene or a node that the file has; pass null while it is being loaded.',
  );
}

/**
 * Hatches its children, or a loaded scene, with `applyHatching`, and hatches again when children are added, removed or changed.
 *
 * ```tsx
 * <Hatched preset="pencil">
 *   <mesh>
 *     <torusKnotGeometry />
 *     <meshStandardMaterial color="tomato" />
 *   </mesh>
 * </Hatched>
 * <Hatched preset="engraving" object={gltf.scene} />
 * ```
 *
 * When it unmounts, everything gets its former look back, and all memory is freed. Children may suspend.
 */
export function Hatched({
  object,
  children,
  showUnhatched = false,
  onHatched,
  onError,
  ...others
}: HatchedProps): ReactElement {
  warnIfEmpty(object, children);
  const { options, group } = splitProps(others);
  const content = useRef<Group>(null);
  const hatcher = useRef<Hatcher | null>(null);
  const invalidate = useThree((state) => state.invalidate);
  const get = useThree((state) => state.get);
  const [failure, setFailure] = useState<{ error: unknown } | null>(null);
  const latest = useRef({ onHatched, onError, showUnhatched });

  useEffect(() => {
    latest.current = { onHatched, onError, showUnhatched };
  });

  useEffect(() => {
    const root = content.current!;
    const events: HatcherEvents = {
      onHatched: (hatched) => {
        latest.current.onHatched?.(hatched);
        invalidate();
      },
      invalidate,
      onError: (error) => {
        if (latest.current.onError) latest.current.onError(error);
        else setFailure({ error });
        invalidate();
      },
    };
    const made = new Hatcher(root, latest.current.showUnhatched, events, () => {
      const { gl: renderer, camera } = get();
      return 'isWebGLRenderer' in renderer ? { renderer, camera } : {};
    });
    hatcher.current = made;
    root.visible = true;
    return () => {
      made.dispose();
      hatcher.current = null;
    };
  }, [invalidate, get]);

  useEffect(() => hatcher.current?.update(options));

  useFrame(() => hatcher.current?.follow());

  if (failure) throw failure.error;
  return (
    <group {...group}>
      <group ref={content} visible={showUnhatched}>
        {object && <primitive object={object} />}
        {children}
      </group>
    </group>
  );
}
