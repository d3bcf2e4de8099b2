import type { Camera, WebGLRenderer } from 'three';

/** Renderer ids, keyed by `info`: a key that is the renderer itself would keep it from being collected. */
const numbers = new WeakMap<object, number>();
let last = 0;

function numberOf({ info }: WebGLRenderer): number {
  let number = numbers.get(info);
  if (number === undefined) {
    number = ++last;
    numbers.set(info, number);
  }
  return number;
}

/** The renderer's frame number. WebGPURenderer has none; its call number stands in. */
const frameOf = ({ info: { render } }: WebGLRenderer): number => render.frame ?? render.calls;

/** Identifies one frame of one renderer and camera, without keeping either alive. Allocates nothing. */
export class FrameStamp {
  private renderer = 0;
  private camera = -1;
  private frame = -1;

  note(renderer: WebGLRenderer, camera: Camera): void {
    this.renderer = numberOf(renderer);
    this.camera = camera.id;
    this.frame = frameOf(renderer);
  }

  /** Whether this is the frame that was stored last. */
  isOf(renderer: WebGLRenderer, camera: Camera): boolean {
    return frameOf(renderer) === this.frame && camera.id === this.camera && numberOf(renderer) === this.renderer;
  }
}
