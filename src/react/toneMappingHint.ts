import { NoToneMapping, type WebGLRenderer } from 'three';
import type { HatchedScene } from 'three-hatching';

let wasGiven = false;

/** Warns once if the renderer has a tone mapping, as a `<Canvas>` has by default: it makes paper and ink grey. */
export function hintAtToneMapping({ toneMapping }: WebGLRenderer, { materials }: HatchedScene): void {
  if (wasGiven || toneMapping === NoToneMapping || !materials.some((material) => material.toneMapped)) return;
  wasGiven = true;
  console.warn(
    'three-hatching: this canvas has a tone mapping, which makes paper and ink grey. Use <Canvas flat>, or <Hatched material={{ toneMapped: false }}>.',
  );
}
