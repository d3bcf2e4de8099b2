/** Counterpart of shaders/chunks/unitsPerPixel.glsl. */
import { isOrthographic } from '../base/isOrthographic.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { abs, cameraProjectionMatrix, determinant, pow, select } = tsl;

const viewportHeight = /* @__PURE__ */ hatchingUniform('viewportHeight', 'float');

/** Object units per pixel at a vertex. @param viewToObject linear part */
export function unitsPerPixel(viewToObject: Value, viewPosition: Value): Value {
  const away = select(isOrthographic(), 1, viewPosition.z.negate());
  // The cube root of the determinant: the mean scale over directions.
  const scale = pow(abs(determinant(viewToObject)), 1 / 3);
  return away
    .mul(scale)
    .mul(2)
    .div(abs(cameraProjectionMatrix.element(1).element(1)).mul(viewportHeight));
}
