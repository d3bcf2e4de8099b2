import { type Box3, MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** Share of the picture that the box fills. */
const FILLED = 0.9;

/** How far from the origin the eye must be, in direction `view`, for every corner of a box to be in the picture. */
export function framingDistance(box: Box3, view: Vector3, camera: PerspectiveCamera): number {
  const slopeY = Math.tan(MathUtils.degToRad(camera.fov) / 2) * FILLED;
  const slopeX = slopeY * camera.aspect;
  const toEye = view.clone().normalize();
  const right = new Vector3(0, 1, 0).cross(toEye).normalize();
  const up = toEye.clone().cross(right);
  return Math.max(
    ...boxCorners(box).map(
      (corner) => corner.dot(toEye) + Math.max(Math.abs(corner.dot(right)) / slopeX, Math.abs(corner.dot(up)) / slopeY),
    ),
  );
}

function boxCorners({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z),
  );
}
