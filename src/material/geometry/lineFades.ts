import { type BufferGeometry, MathUtils } from 'three';
import { identityOf } from './identityOf.js';

/** The duration in which lines fade into an even grey, and of the reverse, in milliseconds. */
const DURATION_MS = 300;

/** The interval between frames of a fade, in milliseconds. */
const INTERVAL_MS = 16;

interface Fade {
  start: number;
  from: number;
  to: number;
}

const fades = new WeakMap<object, Fade>();
/** Whether anything has ever faded: if not, meshes need not be looked up in each frame. */
let hasFaded = false;

/** The contrast of the lines on a geometry: from 0, an even grey of the same tone, to 1. Allocates nothing. */
export function lineContrast(geometry: BufferGeometry): number {
  if (!hasFaded) return 1;
  const fade = fades.get(identityOf(geometry));
  if (!fade) return 1;
  return MathUtils.lerp(fade.from, fade.to, MathUtils.smoothstep(performance.now() - fade.start, 0, DURATION_MS));
}

/**
 * Fades the lines on geometries into an even grey, where they stay until `fadeIn`. If reduced motion is preferred, and outside of a
 * page, nothing fades.
 *
 * @param onFrame called whenever a frame must be drawn
 */
export const fadeOut = (geometries: readonly BufferGeometry[], signal: AbortSignal, onFrame: () => void) =>
  fade(geometries, 1, 0, signal, onFrame);

/** Fades the lines on geometries back in. See `fadeOut`. */
export async function fadeIn(
  geometries: readonly BufferGeometry[],
  signal: AbortSignal,
  onFrame: () => void,
): Promise<void> {
  await fade(geometries, 0, 1, signal, onFrame);
  showLines(geometries);
}

/** Ends all fades of the lines on geometries at once, with full contrast. */
export function showLines(geometries: readonly BufferGeometry[]): void {
  for (const geometry of geometries) fades.delete(identityOf(geometry));
}

async function fade(
  geometries: readonly BufferGeometry[],
  from: number,
  to: number,
  signal: AbortSignal,
  onFrame: () => void,
): Promise<void> {
  if (!allowsMotion()) return;
  const start = performance.now();
  hasFaded = true;
  for (const geometry of geometries) fades.set(identityOf(geometry), { start, from, to });
  // A timer instead of animation frames, because a background page has none and must finish too.
  while (performance.now() - start < DURATION_MS && !signal.aborted) {
    onFrame();
    await new Promise((resume) => setTimeout(resume, INTERVAL_MS));
  }
}

const allowsMotion = (): boolean =>
  typeof matchMedia === 'function' && !matchMedia('(prefers-reduced-motion: reduce)').matches;
