/** Compiled, never run: the components of the packed library, as a strict consumer's compiler sees them. */
import type { ReactElement } from 'react';
import { BoxGeometry, Group } from 'three';
import type { HatchedScene, TonalArtMap } from 'three-hatching';
import { Hatched, HatchingOutlines, useHatchingGeometry, useTonalArtMap } from 'three-hatching/react';

const scene = new Group();
const box = new BoxGeometry();

export function Drawing({ onHatched }: { onHatched: (hatched: HatchedScene) => void }): ReactElement {
  const map: TonalArtMap = useTonalArtMap({ style: 'woodcut' });
  const geometry = useHatchingGeometry(box, { outlines: true, onError: (error: unknown) => console.error(error) });
  return (
    <>
      <Hatched
        preset="pencil"
        object={scene}
        material={{ ink: 'navy' }}
        outlines={{ wobble: 1 }}
        position={[0, 1, 0]}
        onHatched={onHatched}
        onProgress={(progress: number) => progress.toFixed(2)}
        onClick={(event) => event.stopPropagation()}
      >
        <mesh />
      </Hatched>
      {/* @ts-expect-error: an unknown preset is refused; the props are not `any`. */}
      <Hatched preset="scribble" />
      {/* @ts-expect-error: what an abort signal is for, unmounting does. */}
      <Hatched signal={new AbortController().signal} />
      {geometry && (
        <mesh geometry={geometry}>
          <hatchingMaterial
            technique="hatching"
            tonalArtMap={map}
            ink="#222"
            perTriangle={{ strokeOffset: [0.5, 0] }}
            side={2}
          />
          {/* @ts-expect-error: an unknown technique is refused; the attributes are not `any`. */}
          <hatchingMaterial technique="scribble" />
          <hatchingOutlineMaterial weights={{ creases: 0 }} weights-lit={1} />
          {/* @ts-expect-error: an unknown weight is refused. */}
          <HatchingOutlines weights={{ crease: 0 }} />
          <HatchingOutlines outlineWidth={2} weights={{ lit: 1, shade: 1 }} weights-creases={0.5} ink="navy" />
        </mesh>
      )}
    </>
  );
}
