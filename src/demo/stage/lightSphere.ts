import { Plane, Ray, Sphere, Vector3 } from 'three';

/** The two points where a ray meets a sphere around the origin; undefined when it misses or starts inside. */
export function intersectSphere(ray: Ray, radius: number): { near: Vector3; far: Vector3 } | undefined {
  const near = new Vector3();
  if (ray.origin.length() <= radius || !ray.intersectSphere(new Sphere(new Vector3(), radius), near)) return undefined;
  const closest = ray.closestPointToPoint(new Vector3(), new Vector3());
  return { near, far: closest.multiplyScalar(2).sub(near) };
}

/** The point on the outline of a sphere around the origin, as seen from the ray's origin, that lies nearest to the ray. */
export function nearestOutlinePoint(ray: Ray, radius: number): Vector3 {
  const distance = ray.origin.length();
  if (distance <= radius) return ray.direction.clone().setLength(radius);
  // The outline is the circle in which the cone of sight touches the sphere.
  const axis = ray.origin.clone().divideScalar(distance);
  const height = (radius * radius) / distance;
  const plane = new Plane(axis, 0);
  const sideways = plane.projectPoint(ray.closestPointToPoint(new Vector3(), new Vector3()), new Vector3());
  return sideways.setLength(Math.sqrt(radius * radius - height * height)).addScaledVector(axis, height);
}

/** Beyond the outline of its sphere, as seen from the eye. */
export function isBehind(light: Vector3, eye: Vector3): boolean {
  return light.dot(eye) < light.lengthSq();
}

/** Behind the model, taken as a sphere of radius 1. */
export function isHidden(light: Vector3, eye: Vector3): boolean {
  const ray = new Ray(eye, new Vector3().subVectors(light, eye).normalize());
  return isBehind(light, eye) && ray.distanceSqToPoint(new Vector3()) < 1;
}
