import type { PerspectiveCamera, Scene, WebGLRenderer } from 'three';

/** Milliseconds of a frame: of its script alone, and until one of its pixels can be read. */
export interface DrawnTimes {
  script: number;
  frame: number;
}

/** A function that draws a scene and tells how long that took. */
export function drawer(renderer: WebGLRenderer, camera: PerspectiveCamera): (scene: Scene) => DrawnTimes {
  const gl = renderer.getContext();
  const pixel = new Uint8Array(4);
  return (scene) => {
    const start = performance.now();
    renderer.render(scene, camera);
    const script = performance.now() - start;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return { script, frame: performance.now() - start };
  };
}
