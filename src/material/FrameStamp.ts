import type { Camera, WebGLRenderer } from 'three';

/** A number for each renderer, by its `info`: a renderer itself would be kept from being collected. */
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

/** The number of a frame. WebGPURenderer has none, and counts what it draws. */
const frameOf = ({ info: { render } }: WebGLRenderer): number => render.frame ?? render.calls;

/** Remembers a frame of a renderer as a camera sees it, and keeps neither of them. Allocates nothing. */
export class FrameStamp {
  private renderer = 0;
  private camera = -1;
  private frame = -1;

  note(renderer: WebGLRenderer, camera: Camera): void {
    this.renderer = numberOf(renderer);
    this.camera = camera.id;
    this.frame = frameOf(renderer);
  }

  /** Whether it is the frame that was noted last. */
  isOf(renderer: WebGLRenderer, camera: Camera): boolean {
    return frameOf(renderer) === this.frame && camera.id === this.camera && numberOf(renderer) === this.renderer;
  }
}
