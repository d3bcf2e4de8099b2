import { MathUtils, Spherical, Vector3 } from 'three';
import { proportionOf } from '../../viewer/sceneSetup/framing.js';

/** The range and step by which the view may be turned about the up axis and raised, in degrees, and the turn with the highest cost. */
const TURN = { most: 75, step: 5, bad: 45 };
const RISE = { most: 30, step: 5, bad: 20 };
/** The minimum angle of a view from straight above, in degrees. */
const LEAST_POLAR = 30;
/** The number of points that suffice to measure a model's width. */
const ENOUGH_POINTS = 1500;

/**
 * The view nearest to a given one in which the aspect of points does not exceed `most`; if none exists, the one with the lowest aspect.
 *
 * @param framedPoints xyz of each point
 * @param first direction to the eye
 * @param most maximum aspect (width / height)
 */
export function turnedView(framedPoints: ArrayLike<number>, first: Vector3, most: number): Vector3 {
  const points = someOf(framedPoints);
  let best = first;
  let least = Infinity;
  for (const { view, cost } of views(first)) {
    if (cost >= least) continue;
    const excess = Math.max(0, proportionOf(points, view) - most);
    if (cost + WIDE * excess >= least) continue;
    least = cost + WIDE * excess;
    best = view;
  }
  return best;
}

/** The cost of one unit of excess aspect: more than any turn. */
const WIDE = 100;

/** The candidate views around a given one, which comes first. @returns with the cost of each */
function* views(first: Vector3): Generator<{ view: Vector3; cost: number }, void, void> {
  const { theta, phi } = new Spherical().setFromVector3(first);
  for (let rise = 0; rise <= RISE.most; rise += RISE.step) {
    const polar = phi - MathUtils.degToRad(rise);
    if (rise > 0 && polar < MathUtils.degToRad(LEAST_POLAR)) break;
    for (let turn = 0; turn <= TURN.most; turn += TURN.step) {
      for (const side of turn === 0 ? [1] : [-1, 1]) {
        const view = new Vector3().setFromSphericalCoords(1, polar, theta + MathUtils.degToRad(side * turn));
        yield { view, cost: (turn / TURN.bad) ** 2 + (rise / RISE.bad) ** 2 };
      }
    }
  }
}

function someOf(framedPoints: ArrayLike<number>): ArrayLike<number> {
  const step = Math.ceil(framedPoints.length / 3 / ENOUGH_POINTS);
  if (step <= 1) return framedPoints;
  const points: number[] = [];
  for (let i = 0; i + 2 < framedPoints.length; i += 3 * step)
    points.push(framedPoints[i], framedPoints[i + 1], framedPoints[i + 2]);
  return points;
}
