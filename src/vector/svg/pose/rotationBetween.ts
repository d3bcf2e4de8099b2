import { Matrix3, type Vector3 } from 'three';

/**
 * The smallest rotation that takes one direction to another, as shaders/perFragment/rotationBetween.glsl has it; none for vectors without
 * a direction. Normalises both.
 */
export function rotationBetween(from: Vector3, to: Vector3): Matrix3 {
  const rotation = new Matrix3();
  const cosine = from.normalize().dot(to.normalize());
  // About turned round, any axis would do and none is right.
  if (!(cosine > -0.999)) return rotation;
  const { x, y, z } = from.clone().cross(to);
  const scale = 1 / (1 + cosine);
  return rotation.set(
    1 - scale * (y * y + z * z),
    scale * x * y - z,
    scale * x * z + y,
    scale * x * y + z,
    1 - scale * (x * x + z * z),
    scale * y * z - x,
    scale * x * z - y,
    scale * y * z + x,
    1 - scale * (x * x + y * y),
  );
}
