/** The twin of shaders/perFragment/screenGradient.glsl: how fast a function of the place on the object changes on the screen. */
import { SCREEN_CONSTANTS } from '../../../look/constants/patternConstants.js';
import { isOrthographic } from '../base/isOrthographic.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { abs, cameraProjectionMatrix, cross, dFdx, dFdy, dot, length, max, positionView, select, vec2, vec3 } = tsl;

/** The two columns of a matrix: WGSL has no name for one of two by three that three's nodes know. */
export type ScreenMap = readonly [x: Value, y: Value];

const viewportHeight = /* @__PURE__ */ hatchingUniform('viewportHeight', 'float');

/** The centre of the screen as seen from here: what one step in depth shifts. */
export const centreOfScreen = (): Value =>
  select(isOrthographic(), vec2(0), positionView.xy.div(positionView.z)).toVar();

/** View units to a pixel. */
export const viewUnitsPerPixel = (): Value =>
  select(isOrthographic(), 1, positionView.z.negate())
    .mul(2)
    .div(abs(cameraProjectionMatrix.element(1).element(1)).mul(viewportHeight));

/** @param normal view space, of the length at which it stands for as many view units as a pixel of the plane has */
export function screenMapOf(normal: Value, centre: Value, viewToPlace: Value): ScreenMap {
  const { x, y, z } = normal;
  return [
    viewToPlace.mul(vec3(centre.x.mul(y), z.negate().sub(centre.x.mul(x)), y)).toVar(),
    viewToPlace.mul(vec3(z.add(centre.y.mul(y)), centre.y.negate().mul(x), x.negate())).toVar(),
  ];
}

/** @param normal view space, of any length. Where the plane leans away it is held back. */
function screenMapInView(normal: Value, viewToPlace: Value): ScreenMap {
  const centre = centreOfScreen();
  const facing = abs(dot(normal, vec3(centre, 1)));
  const scale = viewUnitsPerPixel().div(max(facing, length(normal).mul(SCREEN_CONSTANTS.LEAST_FACING)));
  return screenMapOf(normal.mul(scale).toVar(), centre, viewToPlace);
}

/**
 * @param n the normal, unit, in the space of the places that functions are of
 * @param viewToPlace from the view to that space, linear part
 */
export const screenMap = (n: Value, viewToPlace: Value): ScreenMap =>
  screenMapInView(n.mul(viewToPlace).toVar(), viewToPlace);

/** The same of the flat triangle that the fragment lies on. */
export const triangleOnScreen = (viewToPlace: Value): ScreenMap =>
  screenMapInView(cross(dFdx(positionView), dFdy(positionView)).toVar(), viewToPlace);

/** The gradient per pixel, on the screen, of a function with this gradient in that space. */
export const screenGradient = (gradient: Value, [x, y]: ScreenMap): Value => vec2(dot(gradient, x), dot(gradient, y));
