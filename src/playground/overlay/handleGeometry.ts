import { type Box2, Matrix4, type PerspectiveCamera, Plane, Ray, Raycaster, Sphere, Vector2, Vector3 } from 'three';

/** The two points where a ray intersects a sphere around the origin; undefined if it misses or starts inside. */
export function intersectSphere(ray: Ray, radius: number): { near: Vector3; far: Vector3 } | undefined {
  const near = new Vector3();
  if (ray.origin.length() <= radius || !ray.intersectSphere(new Sphere(new Vector3(), radius), near)) return undefined;
  const closest = ray.closestPointToPoint(new Vector3(), new Vector3());
  return { near, far: closest.multiplyScalar(2).sub(near) };
}

/**
 * The radius of a sphere around the origin whose outline has a given projected size.
 *
 * @param distance of the eye from the origin
 * @param size of the outline's radius, in focal lengths
 */
export function radiusWithin(distance: number, size: number): number {
  return distance * Math.sin(Math.atan(size));
}

/** The point nearest to a ray on the outline of a sphere around the origin, as seen from the ray's origin. */
export function nearestOutlinePoint(ray: Ray, radius: number): Vector3 {
  const distance = ray.origin.length();
  if (distance <= radius) return ray.direction.clone().setLength(radius);
  // The outline is the circle where the tangent cone from the eye touches the sphere.
  const axis = ray.origin.clone().divideScalar(distance);
  const height = (radius * radius) / distance;
  const plane = new Plane(axis, 0);
  const sideways = plane.projectPoint(ray.closestPointToPoint(new Vector3(), new Vector3()), new Vector3());
  return sideways.setLength(Math.sqrt(radius * radius - height * height)).addScaledVector(axis, height);
}

/** Whether a light lies beyond the outline of its sphere, as seen from the eye. */
export function isBehind(light: Vector3, eye: Vector3): boolean {
  return light.dot(eye) < light.lengthSq();
}

/** Whether a light is hidden by the model, taken as a sphere of radius 1. */
export function isHidden(light: Vector3, eye: Vector3): boolean {
  const ray = new Ray(eye, new Vector3().subVectors(light, eye).normalize());
  return isBehind(light, eye) && ray.distanceSqToPoint(new Vector3()) < 1;
}

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

/** The directions in which the extent of points is measured, and in which a way around them is searched. */
const DIRECTIONS = Array.from({ length: 16 }, (_, i) =>
  new Vector2(1, 0).rotateAround(new Vector2(), (i * Math.PI) / 8),
);

/** Lengths below this count as zero, in pixels. */
const NEAR = 1e-6;

/** The projected extent of points in several directions, in pixels from the picture's upper left. */
export class Silhouette {
  private readonly reaches: readonly number[];

  /**
   * @param points xyz of each
   * @param size of the picture in pixels
   */
  constructor(points: ArrayLike<number>, camera: PerspectiveCamera, size: { width: number; height: number }) {
    camera.updateMatrixWorld();
    const toPicture = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const reaches = DIRECTIONS.map(() => -Infinity);
    const point = new Vector3();
    for (let i = 0; i < points.length; i += 3) {
      point.set(points[i], points[i + 1], points[i + 2]).applyMatrix4(toPicture);
      const x = ((1 + point.x) / 2) * size.width;
      const y = ((1 - point.y) / 2) * size.height;
      for (let k = 0; k < DIRECTIONS.length; k++) {
        const { x: dx, y: dy } = DIRECTIONS[k];
        reaches[k] = Math.max(reaches[k], x * dx + y * dy);
      }
    }
    this.reaches = reaches;
  }

  /**
   * The shortest move of a disc to a place where it covers none of the points.
   *
   * @param within allowed positions of the disc's centre
   * @param most maximum length of the move, in pixels
   * @returns an offset of length 0 if the disc covers no point already, or if there is no such place
   */
  wayAround(disc: Vector2, radius: number, within: Box2, most: number): Vector2 {
    let shortest: Vector2 | undefined;
    for (const [k, direction] of DIRECTIONS.entries()) {
      const place = beyond(disc, direction, this.reaches[k] + radius, within);
      const way = place?.sub(disc);
      if (way && way.length() <= (shortest?.length() ?? most)) shortest = way;
    }
    return shortest ?? new Vector2();
  }
}

/** A place near another one that lies this far out in a direction, moved along the edge of the allowed area if necessary. */
function beyond(from: Vector2, direction: Vector2, reach: number, within: Box2): Vector2 | undefined {
  const missing = Math.max(0, reach - from.dot(direction));
  const place = within.clampPoint(from.clone().addScaledVector(direction, missing), new Vector2());
  const left = reach - place.dot(direction);
  if (left <= NEAR) return place;
  for (const axis of ['x', 'y'] as const) {
    const along = place.clone();
    along[axis] += left / direction[axis];
    if (within.containsPoint(along)) return along;
  }
  return undefined;
}
