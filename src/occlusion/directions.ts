/** The axes of a depth map: `right` and `up` span it, `towards` points at the sky it is seen from. Unit, orthogonal. */
export interface MapAxes {
  right: Vector;
  up: Vector;
  towards: Vector;
}

type Vector = [x: number, y: number, z: number];

// Martin Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018: the plastic number and its powers in
// three dimensions. Any beginning of the sequence is spread evenly, so a bake may stop or go on anywhere.
const RATIO = 1.2207440846057596;

/**
 * The direction number `index` of an even spread over the upper half of the sphere, and a map across it that is turned by
 * another angle each time, so that the pixels of no two maps agree.
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
