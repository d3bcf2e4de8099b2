import type { ReactElement, Ref } from 'react';
import type { HatchingLineParameters, HatchingLines as Lines } from 'three-hatching';
import './elements.js';

/** The props of `<HatchingLines>`: the properties of `HatchingLineMaterial`. */
export interface HatchingLinesProps extends HatchingLineParameters {
  ref?: Ref<Lines> | undefined;
}

/**
 * Draws the contours, borders and creases of its parent mesh, whose geometry must be prepared with `lines`. Every prop may change at
 * any time; a prop that is removed goes back to its default.
 *
 * ```tsx
 * <mesh geometry={geometry}>
 *   <hatchingMaterial technique="anchored" tonalArtMap={map} />
 *   <HatchingLines lineWidth={2} wobble={1} />
 * </mesh>
 * ```
 */
export function HatchingLines({ ref, ...look }: HatchingLinesProps): ReactElement {
  const ofMaterial = Object.fromEntries(Object.entries(look).map(([name, value]) => [`material-${name}`, value]));
  return <hatchingLines ref={ref} {...ofMaterial} />;
}
