/** Counterpart of shaders/outlines/shade.glsl: outlines are heavier away from the light, and lost between lit surface and paper. */
import type { Light } from 'three';
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { meanLight } from '../base/lights.js';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import type { Piece, PieceEnd } from './piece.js';
import { type InstancePlace, normalOfInstance, placeOfInstance } from './points.js';

const { cameraViewMatrix, dot, float, length, max, mix, modelNormalMatrix, modelViewMatrix, normalize, select } = tsl;
const { smoothstep, vec3, vec4 } = tsl;
const { INSIDE, LIT, LOST_RANGE, LOST_TAPER, LOST_WEIGHT, SHADED } = OUTLINE_CONSTANTS;

export const shadeWeights: Value = /* @__PURE__ */ hatchingUniform('shadeWeights', 'vec2');
const lostEdges = /* @__PURE__ */ hatchingUniform('lostEdges', 'float');

/** Transforms a position to view space. */
export const objectToView = (position: Value, place: InstancePlace): Value =>
  modelViewMatrix.mul(vec4(placeOfInstance(position, place), 1)).xyz;

// three.js' modelNormalMatrix transforms to world space.
const normalInView = (normal: Value, place: InstancePlace): Value =>
  normalize(cameraViewMatrix.mul(vec4(modelNormalMatrix.mul(normalOfInstance(normal, place)), 0)).xyz);

/**
 * Multiplies the weights of an end by the effect of the light.
 *
 * @param light unit, or 0 if no light has a direction
 * @param sight the direction to the eye. Both in view space.
 */
function shadeEnd(end: PieceEnd, contour: Value, light: Value, sight: Value, place: InstancePlace): void {
  const normal = normalInView(end.normal, place).toVar();
  const share = smoothstep(LIT, SHADED, float(0.5).sub(dot(normal, light).mul(0.5)));
  const weight = mix(shadeWeights.x, shadeWeights.y, share).toVar();
  const inside = dot(normalize(normal.add(sight.mul(INSIDE))), light);
  const from = lostEdges.mul(LOST_RANGE).oneMinus().toVar();
  const to = from.add(lostEdges.mul(LOST_TAPER[1]).add(LOST_TAPER[0]));
  const lost = lostEdges.mul(LOST_WEIGHT[1]).add(LOST_WEIGHT[0]);
  end.innerWeight.mulAssign(weight);
  end.weight.mulAssign(
    weight.mul(
      contour
        .mul(lost)
        .mul(smoothstep(from, to, inside))
        .oneMinus(),
    ),
  );
}

/** @param lights of the scene */
export function shade({ start, end, contour }: Piece, place: InstancePlace, lights: readonly Light[]): void {
  const middle = objectToView(start.position.add(end.position).mul(0.5), place).toVar();
  const light = meanLight(middle, lights).toVar();
  light.assign(light.div(max(length(light), 1e-20)));
  const sight = select(isOrthographic(), vec3(0, 0, 1), normalize(middle.negate())).toVar();
  shadeEnd(start, contour, light, sight, place);
  shadeEnd(end, contour, light, sight, place);
}
