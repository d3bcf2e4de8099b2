/** Baked ambient occlusion, from the attribute to the light that it takes. */
import type { BufferGeometry } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { attribute, dot, max, normalGeometry, select, smoothstep, vec4 } = tsl;
const { CAVITY, HOLLOW } = TONE_CONSTANTS;

/**
 * Counterpart of shaders/chunks/hatchNormal.glsl.
 *
 * xyz: the normal smoothed to the scale of a stroke, zero if the geometry has none. w: minus the baked occlusion, 1 if the geometry has no
 * such attribute.
 */
export const hatchNormal = ({ geometry }: NodeBuilder): Value =>
  (geometry as BufferGeometry).hasAttribute('hatchNormal') ? attribute('hatchNormal', 'vec4') : vec4(0, 0, 0, 1);

/** The smoothed normal, or the geometry's own where it was not prepared. */
export function strokeNormalOf(builder: NodeBuilder): Value {
  const smoothed = hatchNormal(builder).xyz.toVar();
  return select(dot(smoothed, smoothed).greaterThan(0.25), smoothed, normalGeometry);
}

/** Counterpart of shaders/chunks/occlusion.glsl: 0 where a surface sees the whole sky, 1 where it sees none of it. */

/** The baked ambient occlusion. */
const vOcclusion: Value = /* @__PURE__ */ tsl.varyingProperty('float', 'vOcclusion');

/** Counterpart of shaders/chunks/emitOcclusion.glsl. Instances stand in different places, so occlusion is not baked for them. */
export function emitOcclusion(builder: NodeBuilder): void {
  const isPlaced = ['isInstancedMesh', 'isBatchedMesh'].some((kind) => kind in (builder.object as object));
  vOcclusion.assign(isPlaced ? 0 : max(hatchNormal(builder).w.negate(), 0));
}

/** Counterpart of shaders/chunks/occlude.glsl: the light that ambient occlusion takes. */

const occlusion = /* @__PURE__ */ hatchingUniform('occlusion', 'float');
const hollowStrength = /* @__PURE__ */ hatchingUniform('hollowStrength', 'float');

/** The share of ambient light that is left. */
export const openToSky = (): Value => occlusion.mul(vOcclusion).oneMinus();

/** The share of directed light that is left: little less than all, except where most of the sky is hidden. */
export const openToLights = (): Value =>
  occlusion
    .mul(vOcclusion)
    .mul(smoothstep(0, CAVITY, vOcclusion))
    .oneMinus();

/** The darkness of deep hollows, which light does not lessen. */
export const hollowness = (): Value => hollowStrength.mul(occlusion).mul(smoothstep(HOLLOW[0], HOLLOW[1], vOcclusion));
