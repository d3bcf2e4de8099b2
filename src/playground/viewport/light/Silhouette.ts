import { type Box2, Matrix4, type PerspectiveCamera, Vector2, Vector3 } from 'three';

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
