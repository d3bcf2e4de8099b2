import { MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** The share of the picture that {@link fitCamera} fills, of its width or its height. */
const POINTS_FILL = 0.94;

/**
 * Places a camera so that points just fill its picture, seen from a given direction.
 *
 * @param positions xyz of each point
 * @param view direction from the points to the eye, of any length
 * @param zoom how many times larger the picture is than one that the points just fill
 * @param fill the share of the picture that they fill, of its width or its height
 * @returns what the camera looks at: of its line of sight, the point nearest to the origin
 */
export function fitCamera(
  camera: PerspectiveCamera,
  positions: ArrayLike<number>,
  view: Vector3,
  zoom = 1,
  fill = POINTS_FILL,
): Vector3 {
  const { toEye, right, up, slopeX, slopeY } = frustumAxes(camera, view, fill);
  // A point is in the picture if |x − x₀| ≤ slope · (distance − depth). For each side, only the point
  // that is farthest out counts.
  const sides = { left: -Infinity, right: -Infinity, below: -Infinity, above: -Infinity };
  const point = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    point.fromArray(positions, i);
    const x = point.dot(right);
    const y = point.dot(up);
    const depth = point.dot(toEye);
    sides.left = Math.max(sides.left, -x + slopeX * depth);
    sides.right = Math.max(sides.right, x + slopeX * depth);
    sides.below = Math.max(sides.below, -y + slopeY * depth);
    sides.above = Math.max(sides.above, y + slopeY * depth);
  }
  const distance = Math.max((sides.left + sides.right) / (2 * slopeX), (sides.below + sides.above) / (2 * slopeY));
  const middle = right
    .multiplyScalar((sides.right - sides.left) / 2)
    .addScaledVector(up, (sides.above - sides.below) / 2);
  camera.position.copy(middle).addScaledVector(toEye, distance / zoom);
  camera.lookAt(middle);
  return middle;
}

/**
 * The axes of a camera that looks against `view`, and how fast its frustum widens along them.
 *
 * @param fill share of the frustum that counts
 */
function frustumAxes(camera: PerspectiveCamera, view: Vector3, fill: number) {
  const toEye = view.clone().normalize();
  const right = new Vector3(0, 1, 0).cross(toEye).normalize();
  const up = toEye.clone().cross(right);
  const slopeY = Math.tan(MathUtils.degToRad(camera.fov) / 2) * fill;
  return { toEye, right, up, slopeX: slopeY * camera.aspect, slopeY };
}
