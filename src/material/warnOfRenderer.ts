import { warn } from './diagnostics/warn.js';

let hasWarned = false;

/**
 * Warns once that WebGPURenderer, with any backend, cannot draw materials written in GLSL. three.js only names the material and draws
 * its default material instead; this message also gives the remedy.
 *
 * @param what the name of the class
 * @param hasTwin whether `three-hatching/webgpu` has a class of the same name
 */
export function warnOfRenderer(what: string, hasTwin = true): void {
  if (hasWarned) return;
  hasWarned = true;
  warn(
    `${what}: WebGPURenderer draws no materials that are written in GLSL, with its WebGL 2 backend neither. Draw the scene with WebGLRenderer, from 'three'${hasTwin ? ", or take what has the same name in 'three-hatching/webgpu'" : ''}.`,
    'error',
  );
}
