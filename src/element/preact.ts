/**
 * `three-hatching/element`, with the tag `<hatched-model>` known to JSX of Preact.
 *
 * @module three-hatching/element/preact
 */
import type { HTMLAttributes } from 'preact';
import type { HatchedModelAttributes, HatchedModelElement } from './element.js';

export * from './element.js';

/** The JSX props in Preact: attributes and listeners. */
export type HatchedModelProps = HatchedModelAttributes &
  Omit<HTMLAttributes<HatchedModelElement>, keyof HatchedModelAttributes | 'onError'> & {
    onError?: ((event: ErrorEvent) => void) | undefined;
  };

declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements {
      'hatched-model': HatchedModelProps;
    }
  }
}
