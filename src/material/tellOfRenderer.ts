let wasTold = false;

/**
 * Says once that WebGPURenderer, with any backend, cannot draw what is written in GLSL. three.js names the material and draws its own
 * default in its place; this says what to do.
 *
 * @param what the class that cannot be drawn
 */
export function tellOfRenderer(what: string): void {
  if (wasTold) return;
  wasTold = true;
  console.error(
    `${what}: WebGPURenderer draws no materials that are written in GLSL, with its WebGL 2 backend neither. Draw the scene with WebGLRenderer, from 'three'.`,
  );
}
