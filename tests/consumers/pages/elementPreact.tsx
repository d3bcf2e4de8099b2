/**
 * Compiled, never run: the web component of the packed library in JSX of Preact.
 *
 * @jsxImportSource preact
 */
import type { VNode } from 'preact';
import type { HatchedModelElement } from 'three-hatching/element/preact';

export const drawing: VNode = (
  <>
    <hatched-model
      src="bust.glb"
      preset="engraving"
      controls="light"
      ktx2-path="decoders/basis"
      class="wide"
      key="bust"
      ref={(element: HatchedModelElement | null) => console.log(element?.ktx2Path)}
      onLoad={() => console.log('drawn')}
      onError={({ message }) => console.log(message)}
    >
      A bust
    </hatched-model>
    {/* @ts-expect-error: an unknown preset is refused; the attributes are not `any`. */}
    <hatched-model preset="scribble" />
  </>
);
