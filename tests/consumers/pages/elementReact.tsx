/** Compiled, never run: the web component of the packed library in JSX of React. */
import type { ReactElement } from 'react';
import type { HatchedModelElement } from 'three-hatching/element/react';

export const drawing: ReactElement = (
  <>
    <hatched-model
      src="bust.glb"
      preset="engraving"
      light="-45 40"
      controls
      alt="A bust"
      draco-path="decoders/draco"
      className="wide"
      key="bust"
      ref={(element: HatchedModelElement | null) => console.log(element?.dracoPath)}
      onload={() => console.log('drawn')}
      onerror={({ message }) => console.log(message)}
      onClick={(event) => console.log(event.currentTarget.src)}
    >
      A bust
    </hatched-model>
    <hatched-model src="bust.glb" controls="light" />
    {/* @ts-expect-error: an unknown preset is refused; the attributes are not `any`. */}
    <hatched-model preset="scribble" />
    {/* @ts-expect-error: React never calls this one of a custom element. */}
    <hatched-model onLoad={() => {}} />
  </>
);
