import { type PerspectiveCamera, type Ray, Raycaster, Vector2, type Vector3 } from 'three';

/** Converts between world space and pixels of an element that shows it, counted from the top left. */
export class ViewportProjection {
  private readonly raycaster = new Raycaster();

  constructor(
    private readonly element: HTMLElement,
    private readonly camera: PerspectiveCamera,
  ) {}

  get size(): { width: number; height: number } {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  /** The position of a pointer. */
  pointer(event: PointerEvent): Vector2 {
    const { left, top } = this.element.getBoundingClientRect();
    return new Vector2(event.clientX - left, event.clientY - top);
  }

  /** The projected position of a world point. */
  project(world: Vector3): Vector2 {
    const { width, height } = this.size;
    const projected = world.clone().project(this.camera);
    return new Vector2(((projected.x + 1) / 2) * width, ((1 - projected.y) / 2) * height);
  }

  /** The ray through a position, in world space. It is overwritten by the next call. */
  ray(position: Vector2): Ray {
    const { width, height } = this.size;
    this.raycaster.setFromCamera(new Vector2((position.x / width) * 2 - 1, 1 - (position.y / height) * 2), this.camera);
    return this.raycaster.ray;
  }
}
