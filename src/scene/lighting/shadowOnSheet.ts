type Vector = readonly [x: number, y: number, z: number];

/** An object that casts a shadow on level ground, and its view by a camera. */
export interface Standing {
  /** x, y, z of points of the object in world space: enough of them to tell its extent. */
  points: ArrayLike<number>;
  /** The unit vector upwards. The ground goes through the lowest point. */
  top: Vector;
  /** The matrix from world space to the sheet, in the column order of `Matrix4.elements`. */
  toSheet: ArrayLike<number>;
}

/**
 * The reach of an object's shadow on the ground, from the middle of the sheet towards its edges: up to 1 the shadow lies wholly on the
 * sheet. Infinity under a light at the horizon or below, and for a shadow that reaches behind the eye.
 *
 * @param direction unit vector to a distant light
 */
export function shadowReach({ points, top, toSheet }: Standing, direction: Vector): number {
  const climb = dot(direction, top);
  if (!(climb > 0)) return Infinity;
  const [east, up, south] = direction.map((part) => part / climb);
  const ground = lowest(points, top);
  let reach = 0;
  for (let i = 0; i < points.length; i += 3) {
    const height = points[i] * top[0] + points[i + 1] * top[1] + points[i + 2] * top[2] - ground;
    const place: Vector = [points[i] - height * east, points[i + 1] - height * up, points[i + 2] - height * south];
    reach = Math.max(reach, placeReach(place, toSheet));
  }
  return reach;
}

function lowest(points: ArrayLike<number>, top: Vector): number {
  let least = Infinity;
  for (let i = 0; i < points.length; i += 3) {
    least = Math.min(least, points[i] * top[0] + points[i + 1] * top[1] + points[i + 2] * top[2]);
  }
  return least;
}

/** The distance of a point from the middle of the sheet: 1 at its edges. */
function placeReach([x, y, z]: Vector, m: ArrayLike<number>): number {
  const depth = m[3] * x + m[7] * y + m[11] * z + m[15];
  if (!(depth > 0)) return Infinity;
  const across = m[0] * x + m[4] * y + m[8] * z + m[12];
  const upwards = m[1] * x + m[5] * y + m[9] * z + m[13];
  return Math.max(Math.abs(across), Math.abs(upwards)) / depth;
}

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
