import { type BufferGeometry, MathUtils } from 'three';
import { identityOf } from './identityOf.js';

/** How long lines take to fade into an even grey, and to come out of it, in milliseconds. */
const DURATION = 300;

/** How often a frame is asked for meanwhile, in milliseconds. */
const INTERVAL = 16;

interface Fade {
  start: number;
  from: number;
  to: number;
}

const fades = new WeakMap<object, Fade>();
/** Whether anything has ever faded: until then no mesh of any frame has to be looked up. */
let hasFaded = false;

/** How far the lines on a geometry stand out: from 0, an even grey of the same tone, to 1. Allocates nothing. */
export function lineContrast(geometry: BufferGeometry): number {
  if (!hasFaded) return 1;
  const fade = fades.get(identityOf(geometry));
  if (!fade) return 1;
  return MathUtils.lerp(fade.from, fade.to, MathUtils.smoothstep(performance.now() - fade.start, 0, DURATION));
}

/**
 * Lets the lines on geometries fade into an even grey, where they stay until they come out of it. Where less motion is asked for, and
 * without a page, nothing fades.
 *
 * @param onFrame called whenever a frame is to be drawn
 */
export const fadeOut = (geometries: readonly BufferGeometry[], signal: AbortSignal, onFrame: () => void) =>
  fade(geometries, 1, 0, signal, onFrame);

/** Lets the lines on geometries come out of an even grey. See `fadeOut`. */
export async function fadeIn(
  geometries: readonly BufferGeometry[],
  signal: AbortSignal,
  onFrame: () => void,
): Promise<void> {
  await fade(geometries, 0, 1, signal, onFrame);
  showLines(geometries);
}

/** Ends all fading of the lines on geometries. */
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
  // Not by animation frames: a page in the background has none, and goes on all the same.
  while (performance.now() - start < DURATION && !signal.aborted) {
    onFrame();
    await new Promise((resume) => setTimeout(resume, INTERVAL));
  }
}

const allowsMotion = (): boolean =>
  typeof matchMedia === 'function' && !matchMedia('(prefers-reduced-motion: reduce)').matches;
