import { namesOfOwner } from '../material/checkProperty.js';
import type { HatchingComposition } from '../material/groups/HatchingComposition.js';
import type { HatchingCompositionOptions } from '../material/groups/ownedProperties.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { resolveOptions } from './applyOptions.js';
import type { SceneStyle } from './HatchingCall.js';

/** The names of the numbers of a composition. */
export const COMPOSITION_NAMES = /* @__PURE__ */ namesOfOwner('composition');

export type CompositionNumbers = Partial<HatchingCompositionOptions>;

/** The numbers of a composition that is given as a plain object; none of an instance. */
export const plainOf = (composition: HatchingComposition | CompositionNumbers = {}): CompositionNumbers =>
  'isHatchingComposition' in composition ? {} : composition;

/** The numbers that a look gives the composition of its scene. */
export const numbersOf = ({ options: { material } }: SceneStyle): CompositionNumbers =>
  typeof material === 'object' ? plainOf(material.composition) : {};

/** Separates the options that a scene keeps from those of one call. @param present the composition, unless the options have another */
export function styleOf(given: ApplyHatchingOptions, present: HatchingComposition): SceneStyle {
  const { signal, onProgress, ...options } = resolveOptions(given);
  const { material } = options;
  const named = typeof material === 'object' ? material.composition : undefined;
  const composition = named && 'isHatchingComposition' in named ? (named as HatchingComposition) : present;
  return {
    options,
    composition,
    replacements: new Map(),
    maps: new Map(),
    outlineMaker: null,
    measures: null,
    disposables: [],
  };
}
