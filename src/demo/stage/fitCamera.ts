import { MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** Share of the picture that the points fill. */
const FILLED = 0.94;

/**
 * Places a camera so that points just fill its picture, from a direction.
 *
 * @param positions xyz of each point
 * @param view from the points to the eye, of any length
 * @param times how many times as large the picture is to be, about its middle
 */
export function fitCamera(camera: PerspectiveCamera, positions: ArrayLike<number>, view: Vector3, times = 1): void {
  const toEye = view.clone().normalize();
  const right = new Vector3(0, 1, 0).cross(toEye).normalize();
  const up = toEye.clone().cross(right);
  const slopeY = Math.tan(MathUtils.degToRad(camera.fov) / 2) * FILLED;
  const slopeX = slopeY * camera.aspect;
  // A point is in the picture if |x − x₀| ≤ slope · (distance − depth): for each side, the farthest line of that slope.
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
  camera.position.copy(middle).addScaledVector(toEye, distance / times);
  camera.lookAt(middle);
}
