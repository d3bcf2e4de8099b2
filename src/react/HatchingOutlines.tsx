import { extend } from '@react-three/fiber';
import type { ReactElement, Ref } from 'react';
import { type HatchingOutlineParameters, HatchingOutlines as Outlines } from 'three-hatching';

const Element = /* @__PURE__ */ extend(Outlines);

/** The props of `<HatchingOutlines>`: the properties of `HatchingOutlineMaterial`. */
export interface HatchingOutlinesProps extends HatchingOutlineParameters {
  ref?: Ref<Outlines> | undefined;
}

/**
 * Draws the contours, borders and creases of its parent mesh, whose geometry must be prepared with `outlines`. Every prop may change at
 * any time; a prop that is removed goes back to its default.
 *
 * ```tsx
 * <mesh geometry={geometry}>
 *   <hatchingMaterial technique="hatching" tonalArtMap={map} />
 *   <HatchingOutlines outlineWidth={2} wobble={1} />
 * </mesh>
 * ```
 */
export function HatchingOutlines({ ref, ...look }: HatchingOutlinesProps): ReactElement {
  const ofMaterial = Object.fromEntries(Object.entries(look).map(([name, value]) => [`material-${name}`, value]));
  return <Element ref={ref} {...ofMaterial} />;
}
