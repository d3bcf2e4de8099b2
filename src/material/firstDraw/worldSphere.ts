import { type BufferGeometry, type Object3D, Sphere } from 'three';

/** An object of a scene, and its bounding sphere if it has one. */
interface Bounded extends Object3D {
  geometry?: BufferGeometry;
  boundingSphere?: Sphere | null;
}

/** A bounding sphere of meshes in world space; empty if none of them has bounds. */
export function worldSphere(meshes: Iterable<Object3D>): Sphere {
  const whole = new Sphere().makeEmpty();
  for (const mesh of meshes) {
    // Instances, batches and skins have a sphere beside that of their geometry.
    const { geometry, boundingSphere } = mesh as Bounded;
    const own = boundingSphere ?? geometry?.boundingSphere;
    if (own && own.radius >= 0) whole.union(own.clone().applyMatrix4(mesh.matrixWorld));
  }
  if (whole.isEmpty()) whole.radius = Infinity;
  return whole;
}
