import { NoToneMapping, type WebGLRenderer } from 'three';
import type { HatchedScene } from 'three-hatching';

let wasGiven = false;

/** Says once that a tone mapping, which a `<Canvas>` has unless told otherwise, greys paper and ink. */
export function hintAtToneMapping({ toneMapping }: WebGLRenderer, { materials }: HatchedScene): void {
  if (wasGiven || toneMapping === NoToneMapping || !materials.some((material) => material.toneMapped)) return;
  wasGiven = true;
  console.warn(
    'three-hatching: this canvas has a tone mapping, which greys paper and ink. Use <Canvas flat>, or <Hatched material={{ toneMapped: false }}>.',
  );
}
