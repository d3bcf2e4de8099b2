import { type ThreeElements, useFrame, useThree } from '@react-three/fiber';
import {
  Children,
  type ReactElement,
  type ReactNode,
  type Ref,
  useEffect,
  useImperativeHandle,
  useRef,
  useState,
} from 'react';
import type { Group, Object3D } from 'three';
import { type ApplyHatchingOptions, type HatchedScene, HatchingMaterial } from 'three-hatching';
import { Hatcher, type HatcherEvents } from './Hatcher.js';
import { type HatchedOptions, NO_OPTIONS } from './hatchedOptions.js';

/** The group props of `<Hatched>`. */
export type HatchedGroupProps = Omit<
  ThreeElements['group'],
  keyof ApplyHatchingOptions | 'hatched' | 'object' | 'onError' | 'children'
>;

/**
 * The props of `<Hatched>`: the options of `applyHatching`, those below, and all props of a group.
 *
 * Options may change at any time. The last look is drawn until the next one is ready, which takes longer only if geometry must be
 * prepared or a map drawn. A new function alone changes nothing: the latest function is called when it is needed.
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
  /**
   * Receives the handle of the hatched scene, which stays the same as long as the component is mounted: `hatched.materialOf(mesh)`,
   * `hatched.background`. It is `null` until the scene is hatched for the first time. Change the look by props, not by `setPreset`.
   */
  hatched?: Ref<HatchedScene> | undefined;
  /** Called whenever the scene was hatched or changed. `hatched.skipped` lists the meshes that were left alone, and why. */
  onHatched?: ((hatched: HatchedScene) => void) | undefined;
  /** Called if the scene cannot be hatched; it is then shown unhatched. By default the error goes to the nearest error boundary. */
  onError?: ((error: unknown) => void) | undefined;
}

/** Separates the options of hatching from the props of the group. */
function splitProps(props: HatchedOptions & HatchedGroupProps): {
  options: HatchedOptions;
  group: HatchedGroupProps;
} {
  const options: Record<string, unknown> = {};
  const group: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(props)) (name in NO_OPTIONS ? options : group)[name] = value;
  return { options, group };
}

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
  hatched: handle,
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
  const [scene, setScene] = useState<HatchedScene | null>(null);
  useImperativeHandle(handle, () => scene!, [scene]);
  const latest = useRef({ onHatched, onError, showUnhatched });

  useEffect(() => {
    latest.current = { onHatched, onError, showUnhatched };
  });

  useEffect(() => {
    const root = content.current!;
    const events: HatcherEvents = {
      onHatched: (hatched) => {
        setScene(hatched);
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
