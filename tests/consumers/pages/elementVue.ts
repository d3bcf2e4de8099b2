/** Compiled, never run: the web component of the packed library as templates of Vue see it. */
import type { HatchedModelElement } from 'three-hatching/element/vue';
import type { GlobalComponents } from 'vue';

type Props = InstanceType<GlobalComponents['hatched-model']>['$props'];

export const bust: Props = {
  src: 'bust.glb',
  preset: 'engraving',
  controls: true,
  alt: 'A bust',
  'draco-path': 'decoders/draco',
  class: { wide: true },
  key: 'bust',
  onLoad: () => console.log('drawn'),
  onError: ({ message }) => console.log(message),
};
export const element = (one: InstanceType<GlobalComponents['hatched-model']>): HatchedModelElement => one;

// @ts-expect-error: an unknown preset is refused; the attributes are not `any`.
export const wrong: Props = { preset: 'scribble' };
