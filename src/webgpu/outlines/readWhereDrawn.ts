import type { WebGPURenderer } from 'three/webgpu';

/**
 * Has WebGL read from what is drawn to. three.js copies the depth of a scene from what is bound for reading, and that is the canvas after an
 * application has read pixels of the same render target (seen in 0.187).
 */
export function readWhereDrawn(renderer: WebGPURenderer): void {
  if (!('isWebGLBackend' in renderer.backend)) return;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const drawn: WebGLFramebuffer | null = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
  if (gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) !== drawn) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, drawn);
}
