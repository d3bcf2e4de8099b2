import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { endBetween, type Piece, type PieceEnd, showsBack, turnToBack, weigh } from './piece.js';
import { type OutlinePoint, radius, towardsEye } from './points.js';

const { bool, cross, dot, float, If, length, max, min, normalize, select, smoothstep, step } = tsl;
const { FULL_GROWTH, FULL_LEAN, LEAST_GROWTH, LEAST_LEAN } = OUTLINE_CONSTANTS;

/** Counterpart of shaders/outlines/contour.glsl: the contour of a smooth surface. */

export const contours: Value = /* @__PURE__ */ hatchingUniform('contours', 'float');
const taper = /* @__PURE__ */ hatchingUniform('taper', 'float');

/**
 * The taper of a contour: it is visible where the surface bends away from the eye, and ends in a cusp where that curvature is 0
 * (Koenderink).
 */
const taperAt = (bend: Value): Value => select(taper.greaterThan(0), smoothstep(0, taper, bend), step(0, bend));

/** The two points on the edges of a triangle at which a value is 0; false if the value has one sign. */
export function zeroSet(
  [a, b, c]: readonly [OutlinePoint, OutlinePoint, OutlinePoint],
  valueAt: (point: OutlinePoint) => Value,
  start: PieceEnd,
  end: PieceEnd,
): Value {
  const [va, vb, vc] = [valueAt(a), valueAt(b), valueAt(c)];
  const [pa, pb, pc] = [va, vb, vc].map((value) => value.greaterThanEqual(0).toVar());
  const hasPiece = bool(false).toVar();
  // The edges from the corner with the lone sign to the other two are cut.
  const cut = (one: OutlinePoint, next: OutlinePoint, last: OutlinePoint): void => {
    const value = valueAt(one);
    endBetween(start, one, next, value.div(value.sub(valueAt(next))));
    endBetween(end, one, last, value.div(value.sub(valueAt(last))));
  };
  If(pa.and(pb).and(pc).or(pa.or(pb).or(pc).not()).not(), () => {
    hasPiece.assign(true);
    If(pb.equal(pc), () => {
      cut(a, b, c);
    }).Else(() => {
      If(pa.equal(pc), () => {
        cut(b, c, a);
      }).Else(() => {
        cut(c, a, b);
      });
    });
  });
  return hasPiece;
}

export function contour(piece: Piece, a: OutlinePoint, b: OutlinePoint, c: OutlinePoint): void {
  If(
    zeroSet([a, b, c], ({ facing }) => facing, piece.start, piece.end),
    () => {
      // The back has its contours where the front bends towards the eye.
      If(showsBack().and(piece.start.bend.add(piece.end.bend).lessThan(0)), () => {
        turnToBack(piece);
      });
      for (const end of [piece.start, piece.end]) weigh(end, contours.mul(taperAt(end.bend)).toVar(), float(0));
      piece.contour.assign(1);
    },
  );
}

/** Counterpart of shaders/outlines/suggestiveContour.glsl: lines that would be contours from nearby views. */

export const suggestiveContours: Value = /* @__PURE__ */ hatchingUniform('suggestiveContours', 'float');

export function suggestiveContour(piece: Piece, a: OutlinePoint, b: OutlinePoint, c: OutlinePoint, eye: Value): void {
  const isBehind = showsBack()
    .and(max(max(a.facing, b.facing), c.facing).lessThan(0))
    .toVar();
  If(min(min(a.facing, b.facing), c.facing).greaterThan(0).or(isBehind), () => {
    If(
      zeroSet([a, b, c], ({ bend }) => bend, piece.start, piece.end),
      () => {
        If(isBehind, () => {
          turnToBack(piece);
        });
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
        const growth = piece.side.mul(radius).mul(dot(gradient, w)).div(max(lean, 1e-6));
        const seen = growth.mul(smoothstep(LEAST_LEAN, FULL_LEAN, lean));
        const weight = suggestiveContours.mul(smoothstep(LEAST_GROWTH, FULL_GROWTH, seen)).toVar();
        weigh(piece.start, float(0), weight);
        weigh(piece.end, float(0), weight);
      },
    );
  });
}
