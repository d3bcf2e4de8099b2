import { rendererName } from './rendererName.js';

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/**
 * Whether the browser draws WebGL 2 in software, without a graphics card or a driver for it.
 *
 * @param renderer its name, if known; otherwise a context is created to find out
 */
export function drawsInSoftware(renderer?: string): boolean {
  if (renderer !== undefined) return SOFTWARE.test(renderer);
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (!gl) return false;
  const name = rendererName(gl);
  // Browsers allow a page few contexts.
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(name);
}
