import type { Camera, Scene, WebGLRenderer } from 'three';
import { type IntersectingOutlines, wantsIntersections } from './IntersectingOutlines.js';
import type { NewPart } from './MeetingLines.js';
import type { OutlinePart } from './OutlineParts.js';
import type * as SceneIntersections from './SceneIntersections.js';
import type { DrawnOutlines } from './ScreenLines.js';

export type { FetchMoving } from './SceneIntersections.js';

let loaded: typeof SceneIntersections | null = null;
/** Outlines that were drawn before the code was there. */
const waiting = /* @__PURE__ */ new Map<IntersectingOutlines, NewPart>();

/** Fetches the code that finds lines of intersection, and computes them below an object. */
export async function loadIntersections(): Promise<typeof SceneIntersections> {
  loaded ??= await import('./SceneIntersections.js');
  for (const [outlines, newPart] of waiting) loaded.withIntersections(outlines, [], newPart);
  waiting.clear();
  return loaded;
}

/** The parts of outlines to draw, with the lines where their mesh meets others, as far as those are wanted and known. */
export function drawnParts(
  outlines: IntersectingOutlines,
  parts: readonly OutlinePart[],
  newPart: NewPart,
): readonly OutlinePart[] {
  if (!wantsIntersections(outlines)) return parts;
  if (loaded) return loaded.withIntersections(outlines, parts, newPart);
  // What cannot be fetched leaves lines out, no more.
  if (waiting.size === 0) loadIntersections().catch(() => {});
  waiting.set(outlines, newPart);
  return parts;
}

/**
 * Draws the lines between parts that move against each other, after the outlines of a mesh, if those want them.
 *
 * @param fetch fetches the code for the renderer. Default: that for WebGLRenderer
 */
export function drawMovingLines(
  outlines: DrawnOutlines,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  fetch?: SceneIntersections.FetchMoving,
): void {
  if (wantsIntersections(outlines)) loaded?.drawMoving(outlines, renderer, scene, camera, fetch);
}

/** Frees the lines where the mesh of outlines meets others. */
export function forgetIntersections(outlines: IntersectingOutlines): void {
  waiting.delete(outlines);
  loaded?.forgetIntersections(outlines);
}
