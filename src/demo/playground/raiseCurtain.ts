import type { HatchingScene } from '../stage/createScene.js';
import { page } from './page.js';

/**
 * Puts a copy of the drawing over it, and lets nothing but Cancel be used, while a picture is drawn on the same canvas in tiles.
 *
 * @returns takes it away again
 */
export function raiseCurtain(scene: HatchingScene): () => void {
  const { canvas, viewport, card, bar } = page;
  const copy = document.createElement('canvas');
  copy.className = 'curtain';
  copy.setAttribute('aria-hidden', 'true');
  // In one task, because the canvas does not keep its content for longer.
  scene.draw();
  Object.assign(copy, { width: canvas.width, height: canvas.height });
  copy.getContext('2d')?.drawImage(canvas, 0, 0);
  canvas.after(copy);
  const focused = document.activeElement;
  for (const part of [viewport, card, bar]) part.inert = true;
  return () => {
    for (const part of [viewport, card, bar]) part.inert = false;
    if (focused instanceof HTMLElement) focused.focus({ preventScroll: true });
    copy.remove();
  };
}
