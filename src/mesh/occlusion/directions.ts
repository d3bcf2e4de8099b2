/** The axes of a depth map: unit vectors, orthogonal. `right` and `up` span the map, `towards` points at the first sky. */
export interface MapAxes {
  right: Vector;
  up: Vector;
  towards: Vector;
}

type Vector = [x: number, y: number, z: number];

// The generalised golden ratio in three dimensions (Martin Roberts, "The unreasonable effectiveness of quasirandom sequences",
// 2018). Any beginning of the sequence is evenly distributed, so a bake may stop or continue after any number of directions.
const RATIO = 1.2207440846057596;

/**
 * The axes for direction number `index` in an even distribution over the upper half of the sphere. Each map is rotated about its
 * direction by a different angle, so that the pixel grids of no two maps coincide.
 */
export function mapAxes(index: number): MapAxes {
  const height = fraction(0.5 + (index + 1) / RATIO);
  const longitude = 2 * Math.PI * fraction(0.5 + (index + 1) / RATIO ** 2);
  const roll = 2 * Math.PI * fraction(0.5 + (index + 1) / RATIO ** 3);
  const radius = Math.sqrt(1 - height * height);
  const towards: Vector = [radius * Math.cos(longitude), height, radius * Math.sin(longitude)];
  const level: Vector = [-Math.sin(longitude), 0, Math.cos(longitude)];
  const steep = cross(towards, level);
  const cosine = Math.cos(roll);
  const sine = Math.sin(roll);
  const right = level.map((value, i) => cosine * value + sine * steep[i]) as Vector;
  return { right, up: cross(towards, right), towards };
}

const fraction = (x: number): number => x - Math.floor(x);

const cross = ([a, b, c]: Vector, [x, y, z]: Vector): Vector => [b * z - c * y, c * x - a * z, a * y - b * x];
