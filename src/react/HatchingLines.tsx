import type { ReactElement, Ref } from 'react';
import type { HatchingLineParameters, HatchingLines as Lines } from 'three-hatching';
import './elements.js';

/** What `<HatchingLines>` takes: the properties of `HatchingLineMaterial`. */
export interface HatchingLinesProps extends HatchingLineParameters {
  ref?: Ref<Lines> | undefined;
}

/**
 * Contours, borders and creases of the mesh it is a child of, whose geometry was prepared with `lines`. Every property may
 * change at any time; one that is taken away goes back to its default.
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
