import { type Box3, MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** Shares of the picture that {@link fitCamera} and {@link framingDistance} fill. */
const POINTS_FILL = 0.94;
const BOX_FILLS = 0.9;

/**
 * Places a camera so that points just fill its picture, seen from a given direction.
 *
 * @param positions xyz of each point
 * @param view direction from the points to the eye, of any length
 * @param zoom how many times larger the picture is than one that the points just fill
 */
export function fitCamera(camera: PerspectiveCamera, positions: ArrayLike<number>, view: Vector3, zoom = 1): void {
  const { toEye, right, up, slopeX, slopeY } = frustumAxes(camera, view, POINTS_FILL);
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
}

/** The distance from the origin, in direction `view`, at which every corner of a box is in the picture of a camera. */
export function framingDistance(box: Box3, view: Vector3, camera: PerspectiveCamera): number {
  const { toEye, right, up, slopeX, slopeY } = frustumAxes(camera, view, BOX_FILLS);
  return Math.max(
    ...boxCorners(box).map(
      (corner) => corner.dot(toEye) + Math.max(Math.abs(corner.dot(right)) / slopeX, Math.abs(corner.dot(up)) / slopeY),
    ),
  );
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

function boxCorners({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z),
  );
}
