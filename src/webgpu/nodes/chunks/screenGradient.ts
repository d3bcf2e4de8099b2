import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { abs, cameraProjectionMatrix, dot, positionView, select, vec2, vec3 } = tsl;

/** Counterpart of shaders/perFragment/screenGradient.glsl: screen-space derivatives of functions on the object. */

/** A 2 × 3 matrix by columns, a type that three.js' nodes lack. */
export type ScreenMap = readonly [x: Value, y: Value];

const viewportHeight = /* @__PURE__ */ hatchingUniform('viewportHeight', 'float');

/** The position of the screen's centre relative to the ray of this fragment, per unit of depth. */
export const centreOfScreen = (): Value =>
  select(isOrthographic(), vec2(0), positionView.xy.div(positionView.z)).toVar();

/** The depth; 1 for orthographic cameras. */
const depthOfScreen = (): Value => select(isOrthographic(), 1, positionView.z.negate()).toVar();

/** View units per pixel. */
export const viewUnitsPerPixel = (): Value =>
  depthOfScreen()
    .mul(2)
    .div(abs(cameraProjectionMatrix.element(1).element(1)).mul(viewportHeight));

/** @param normal view space, scaled so that its length is the view units per pixel on the plane */
export function screenMapOf(normal: Value, centre: Value, viewToPlace: Value): ScreenMap {
  const { x, y, z } = normal;
  return [
    viewToPlace.mul(vec3(centre.x.mul(y), z.negate().sub(centre.x.mul(x)), y)).toVar(),
    viewToPlace.mul(vec3(z.add(centre.y.mul(y)), centre.y.negate().mul(x), x.negate())).toVar(),
  ];
}

/** The gradient per pixel of a function, from its gradient in space. */
export const screenGradient = (gradient: Value, [x, y]: ScreenMap): Value => vec2(dot(gradient, x), dot(gradient, y));

/**
 * Counterpart of shaders/perFragment/faceNormals.glsl: the face normal, view space, from screen-space derivatives, which faces the viewer:
 * the geometry has no attribute for it.
 */
export const readFaceNormals = (): Value => tsl.normalFlat;
