/**
 * `three-hatching/element`, with the tag `<hatched-model>` known to JSX of React 19.
 *
 * @module three-hatching/element/react
 */
import type { ClassAttributes, HTMLAttributes } from 'react';
import type { HatchedModelAttributes, HatchedModelElement } from './element.js';

export * from './element.js';

/** The JSX props in React: attributes, and listeners under the names of their events, which React adds to custom elements unchanged. */
export interface HatchedModelProps
  extends HatchedModelAttributes,
    ClassAttributes<HatchedModelElement>,
    Omit<HTMLAttributes<HatchedModelElement>, 'onLoad' | 'onError'> {
  onload?: ((event: Event) => void) | undefined;
  onerror?: ((event: ErrorEvent) => void) | undefined;
}

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hatched-model': HatchedModelProps;
    }
  }
}
