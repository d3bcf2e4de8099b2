/**
 * Counterpart of shaders/outlines/hiding.glsl: before the depth test each end is moved towards the eye along its ray, just far enough that
 * its own surface does not hide it. It keeps its place on the screen.
 */
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { isOrthographic } from '../base/isOrthographic.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import type { Piece, PieceEnd } from './piece.js';
import { radius } from './points.js';

const { float, length, max, min, select, sqrt, vec3 } = tsl;
const { EDGE_SLOPE, LIFT_SHARE, LOOKED_BESIDE, MOST_RISE, ROUNDING } = OUTLINE_CONSTANTS;

/** The `polygonOffsetFactor` of the surface, negated: slopes per pixel by which it is drawn nearer than it lies. */
const pull = /* @__PURE__ */ hatchingUniform('pull', 'float');

/**
 * The distance, in view units, by which an end is moved towards the eye.
 *
 * @param halfWidth of the outline, view units
 * @param pixel in view units
 * @param scale view units per object unit
 * @returns view units
 */
export function liftOf(end: PieceEnd, piece: Piece, halfWidth: Value, pixel: Value, scale: Value): Value {
  const r = radius.mul(scale).toVar();
  const half = halfWidth.toVar();
  const pulled = pull.mul(pixel).mul(4 * EDGE_SLOPE);
  const own = r.mul(LIFT_SHARE).add(piece.extent.mul(scale)).add(pulled).toVar();
  // A surface of curvature κ rises by √(2x/κ) towards the eye over the distance x beside its contour. Without this, half of the outline
  // would be hidden.
  const rise = sqrt(half.mul(2).mul(r).div(max(end.bend, 1e-3)));
  const ofSurface = own.add(half.mul(2)).add(min(rise, r.mul(MOST_RISE)));
  return select(piece.isSmooth, ofSurface, own.add(half.mul(2 * EDGE_SLOPE)));
}

/** Distance by which a surface may lie before its own outline, view units. @param pixel in view units */
export const toleranceOf = (piece: Piece, pixel: Value, scale: Value): Value =>
  radius
    .mul(ROUNDING)
    .add(piece.ownCover)
    .mul(scale)
    .add(
      pull
        .add(select(piece.isValley, float(LOOKED_BESIDE), float(0)))
        .mul(EDGE_SLOPE)
        .mul(pixel),
    );

export const lifted = (position: Value, lift: Value): Value =>
  select(
    isOrthographic(),
    position.add(vec3(0, 0, lift)),
    position.mul(float(1).sub(min(lift.div(max(length(position), 1e-20)), 0.9))),
  );
