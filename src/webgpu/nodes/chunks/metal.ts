/** Counterpart of shaders/chunks/metal.glsl: smooth metal that mirrors a room. */
import { METAL_CONSTANTS } from '../../../look/constants/metalConstants.js';
import { ROUGH } from '../../../look/mirrors.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { cameraViewMatrix, dot, mix, normalView, positionViewDirection, smoothstep, vec4 } = tsl;
const { MIRRORED, HORIZON, ROOM, FLOOR } = METAL_CONSTANTS;

const metalness = /* @__PURE__ */ hatchingUniform('metalness', 'float');
const roughness = /* @__PURE__ */ hatchingUniform('roughness', 'float');

/** The share of the tone that the room decides. */
export const mirroredShare = (): Value =>
  metalness.mul(smoothstep(ROUGH[0], ROUGH[1], roughness).oneMinus()).mul(MIRRORED);

/** The light of the room where a surface mirrors it, from 0 to 1. */
export function mirroredRoom(): Value {
  const up = cameraViewMatrix.mul(vec4(0, 1, 0, 0)).xyz.toVar();
  const across = dot(positionViewDirection, normalView).mul(dot(up, normalView)).mul(2);
  const above = across.sub(dot(up, positionViewDirection)).toVar();
  const below = mix(ROOM[0], ROOM[1], smoothstep(FLOOR[0], FLOOR[1], above.negate()));
  return mix(below, 1, smoothstep(-HORIZON, HORIZON, above));
}
