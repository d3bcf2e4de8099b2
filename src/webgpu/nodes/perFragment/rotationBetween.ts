/** Counterpart of shaders/perFragment/rotationBetween.glsl. */
import { identity } from '../base/matrices.js';
import { tsl, type Value } from '../base/values.js';

const { cross, dot, float, If, mat3, normalize, vec3 } = tsl;

/** The smallest rotation from one direction to another; the identity for null vectors. */
export function rotationBetween(from: Value, to: Value): Value {
  const start = normalize(from).toVar();
  const end = normalize(to).toVar();
  const axis = cross(start, end).toVar();
  const cosine = dot(start, end).toVar();
  const rotation = identity().toVar();
  // For opposite directions no axis is better than another.
  If(cosine.greaterThan(-0.999), () => {
    const { x, y, z } = axis;
    const crossAxis = mat3(vec3(0, z, y.negate()), vec3(z.negate(), 0, x), vec3(y, x.negate(), 0)).toVar();
    const squared = crossAxis.mul(crossAxis).toVar();
    const share = float(1).div(cosine.add(1)).toVar();
    const column = (k: number): Value =>
      rotation.element(k).add(crossAxis.element(k)).add(squared.element(k).mul(share));
    rotation.assign(mat3(column(0), column(1), column(2)));
  });
  return rotation;
}
