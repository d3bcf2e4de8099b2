/** Counterpart of shaders/chunks/fading.glsl: the share of ink that fading leaves at a place, 1 where nothing fades. */
import { FADING_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { cameraViewMatrix, clamp, dot, exp, float, length, select, sin, smoothstep, vec3 } = tsl;
const { AIR, FOCUS_END, FRONT_GAIN, UNEVEN, VIGNETTE_START } = FADING_CONSTANTS;

const depthFading = /* @__PURE__ */ hatchingUniform('depthFading', 'vec3');
const focusing = /* @__PURE__ */ hatchingUniform('focusing', 'vec4');
const vignette = /* @__PURE__ */ hatchingUniform('vignette', 'float');
const sheet = /* @__PURE__ */ hatchingUniform('sheet', 'vec4');
const importance = /* @__PURE__ */ hatchingUniform('importance', 'float');

/** Strength of aerial perspective: 0 in front, 1 at the back. */
function airBefore(viewPosition: Value): Value {
  const way = clamp(viewPosition.z.negate().sub(depthFading.x).div(depthFading.y.sub(depthFading.x)), 0, 1);
  const air = exp(way.mul(-AIR))
    .oneMinus()
    .div(1 - Math.exp(-AIR));
  return select(depthFading.z.equal(0), float(0), air);
}

/** The irregularity of a hand-drawn edge, in [-UNEVEN, UNEVEN]: sines whose phases vary with one another. The numbers are arbitrary. */
function uneven(p: Value): Value {
  const a = sin(dot(p, vec3(4.3, 3.1, -3.7)).add(sin(dot(p, vec3(-2.9, 5.3, 4.1))).mul(1.6)));
  const b = sin(
    dot(p, vec3(-11, 13, 9))
      .add(sin(dot(p, vec3(7, -5, 6))).mul(1.3))
      .add(2),
  );
  return a.mul(0.65).add(b.mul(0.35)).mul(UNEVEN);
}

function inFocus(viewPosition: Value): Value {
  // In world space the edge stays in place as the camera moves.
  const way = viewPosition.sub(focusing.xyz).toVar();
  const [x, y, z] = [0, 1, 2].map((column) => dot(way, cameraViewMatrix.element(column).xyz));
  const away = vec3(x, y, z).div(focusing.w).toVar();
  const focused = smoothstep(1, FOCUS_END, length(away).mul(uneven(away).add(1))).oneMinus();
  return select(focusing.w.equal(0), float(1), focused);
}

function onSheet(pixel: Value): Value {
  const away = pixel.sub(sheet.xy).mul(2).div(sheet.zw).sub(1).toVar();
  const outside = smoothstep(VIGNETTE_START, 1, length(away).mul(uneven(vec3(away.mul(2), 0)).add(1)));
  return select(vignette.equal(0), float(1), vignette.mul(outside).oneMinus());
}

/** A factor on the tone. @param pixel of the render target, counted from the lower left */
export const fadingAt = (viewPosition: Value, pixel: Value): Value =>
  importance
    .mul(inFocus(viewPosition))
    .mul(onSheet(pixel))
    .mul(depthFading.z.mul(airBefore(viewPosition)).oneMinus());

/** A factor on the width of outlines. */
export const outlineFadingAt = (viewPosition: Value, pixel: Value): Value =>
  fadingAt(viewPosition, pixel).mul(depthFading.z.mul(FRONT_GAIN).mul(airBefore(viewPosition).oneMinus()).add(1));

export const mostOutlineFading = (): Value => depthFading.z.mul(FRONT_GAIN).add(1);
