/** Baked ambient occlusion, from the attribute to the light that it takes. */
import { BackSide, type BufferGeometry, DoubleSide } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { OCCLUSION_LEVELS } from '../../../mesh/occlusion/occlusionSides.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { attribute, dot, floor, Fn, frontFacing, max, normalGeometry, select, smoothstep, vec2, vec4 } = tsl;
const { CAVITY, HOLLOW } = TONE_CONSTANTS;
const { SIDE_LEVELS } = OCCLUSION_LEVELS;

/**
 * Counterpart of shaders/chunks/hatchNormal.glsl.
 *
 * xyz: the normal smoothed to the scale of a stroke, zero if the geometry has none. w: the baked occlusion, 1 if the geometry has no such
 * attribute.
 */
export const hatchNormal = ({ geometry }: NodeBuilder): Value =>
  (geometry as BufferGeometry).hasAttribute('hatchNormal') ? attribute('hatchNormal', 'vec4') : vec4(0, 0, 0, 1);

/** The smoothed normal, or the geometry's own where it was not prepared. */
export function strokeNormalOf(builder: NodeBuilder): Value {
  const smoothed = hatchNormal(builder).xyz.toVar();
  return select(dot(smoothed, smoothed).greaterThan(0.25), smoothed, normalGeometry);
}

/** The occlusion of the front and of the back. */
function occlusionOfSides(w: Value): Value {
  const both = floor(w.mul(32767).add(0.5)).toVar();
  // Half a level is added, so that rounding of the quotient does not matter.
  const front = floor(both.add(0.5).div(SIDE_LEVELS)).toVar();
  const ofTwo = vec2(front, both.sub(front.mul(SIDE_LEVELS))).div(SIDE_LEVELS - 1);
  return select(w.lessThanEqual(0), vec2(w.negate()), select(w.greaterThanEqual(1), vec2(0), ofTwo));
}

/** Counterpart of shaders/chunks/occlusion.glsl: 0 where a surface sees the whole sky, 1 where it sees none of it. */

/** The baked ambient occlusion; where both sides are drawn, that of the front and of the back. */
const vOcclusion: Value = /* @__PURE__ */ tsl.varyingProperty('float', 'vOcclusion');
const vOcclusions: Value = /* @__PURE__ */ tsl.varyingProperty('vec2', 'vOcclusions');

/** Counterpart of shaders/chunks/emitOcclusion.glsl. Instances stand in different places, so occlusion is not baked for them. */
export function emitOcclusion(builder: NodeBuilder): void {
  const isPlaced = ['isInstancedMesh', 'isBatchedMesh'].some((kind) => kind in (builder.object as object));
  const ofSides = isPlaced ? vec2(0) : occlusionOfSides(hatchNormal(builder).w).toVar();
  const { side } = builder.material;
  if (side === DoubleSide) vOcclusions.assign(ofSides);
  else vOcclusion.assign(side === BackSide ? ofSides.y : ofSides.x);
}

/** Counterpart of shaders/chunks/occlude.glsl: the light that ambient occlusion takes. */

const occlusion = /* @__PURE__ */ hatchingUniform('occlusion', 'float');
const hollowStrength = /* @__PURE__ */ hatchingUniform('hollowStrength', 'float');

const openOcclusion = /* @__PURE__ */ hatchingUniform('openOcclusion', 'float');

/** The baked occlusion of the side that is seen, relative to that of the open parts. */
const occluded = (): Value =>
  Fn(({ material }) => {
    const baked = material.side === DoubleSide ? select(frontFacing, vOcclusions.x, vOcclusions.y) : vOcclusion;
    return max(baked.sub(openOcclusion), 0).div(openOcclusion.oneMinus());
  })();

/** The share of ambient light that is left. */
export const openToSky = (): Value => occlusion.mul(occluded()).oneMinus();

/** The share of directed light that is left: little less than all, except where most of the sky is hidden. */
export const openToLights = (): Value =>
  occlusion
    .mul(occluded())
    .mul(smoothstep(0, CAVITY, occluded()))
    .oneMinus();

/** The darkness of deep hollows, which light does not lessen. */
export const hollowness = (): Value => hollowStrength.mul(occlusion).mul(smoothstep(HOLLOW[0], HOLLOW[1], occluded()));
