/** Counterpart of shaders/outlines/suggestiveContour.glsl. */
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { zeroSet } from './contour.js';
import { type Piece, weigh } from './piece.js';
import { type OutlinePoint, radius, towardsEye } from './points.js';

const { If, cross, dot, float, length, max, min, normalize, smoothstep } = tsl;
const { FULL_GROWTH, FULL_LEAN, LEAST_GROWTH, LEAST_LEAN } = OUTLINE_CONSTANTS;

/** Weight. */
export const suggestiveContours: Value = /* @__PURE__ */ hatchingUniform('suggestiveContours', 'float');

export function suggestiveContour(piece: Piece, a: OutlinePoint, b: OutlinePoint, c: OutlinePoint, eye: Value): void {
  If(min(min(a.facing, b.facing), c.facing).greaterThan(0), () => {
    If(
      zeroSet([a, b, c], ({ bend }) => bend, piece.start, piece.end),
      () => {
        // The gradient of the curvature, which is linear over the triangle.
        const ab = b.position.sub(a.position).toVar();
        const ac = c.position.sub(a.position).toVar();
        const n = cross(ab, ac).toVar();
        const rise = c.bend.sub(a.bend).mul(ab).sub(b.bend.sub(a.bend).mul(ac));
        const gradient = cross(n, rise)
          .div(max(dot(n, n), 1e-30))
          .toVar();
        const normal = normalize(a.normal.add(b.normal).add(c.normal)).toVar();
        const v = normalize(towardsEye(a.position.add(b.position).add(c.position).div(3), eye)).toVar();
        const w = v.sub(dot(normal, v).mul(normal)).toVar();
        const lean = length(w).toVar();
        const growth = radius.mul(dot(gradient, w)).div(max(lean, 1e-6));
        const seen = growth.mul(smoothstep(LEAST_LEAN, FULL_LEAN, lean));
        const weight = suggestiveContours.mul(smoothstep(LEAST_GROWTH, FULL_GROWTH, seen)).toVar();
        weigh(piece.start, float(0), weight);
        weigh(piece.end, float(0), weight);
      },
    );
  });
}
