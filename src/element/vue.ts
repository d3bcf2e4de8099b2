/**
 * `three-hatching/element`, with the tag `<hatched-model>` known to templates of Vue.
 *
 * @module three-hatching/element/vue
 */
import type { HTMLAttributes, PublicProps } from 'vue';
import type { HatchedModelAttributes, HatchedModelElement } from './element.js';

export * from './element.js';

/** The template props in Vue: attributes and listeners. */
export type HatchedModelProps = HatchedModelAttributes &
  Omit<HTMLAttributes, keyof HatchedModelAttributes | 'onError'> &
  PublicProps & { onError?: ((event: ErrorEvent) => void) | undefined };

declare module 'vue' {
  interface GlobalComponents {
    'hatched-model': new () => HatchedModelElement & { $props: HatchedModelProps };
  }
}
