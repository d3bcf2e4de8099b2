/** Counterpart of shaders/outlines/contour.glsl: the contour of a smooth surface. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { endBetween, type Piece, type PieceEnd, weigh } from './piece.js';
import type { OutlinePoint } from './points.js';

const { If, bool, float, select, smoothstep, step } = tsl;

/** Weight. */
export const contours: Value = /* @__PURE__ */ hatchingUniform('contours', 'float');
/** Curvature times the bounding radius above which the outline has its full width. */
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
  // From the corner with the lone sign to the next two.
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
      for (const end of [piece.start, piece.end]) weigh(end, contours.mul(taperAt(end.bend)).toVar(), float(0));
      piece.contour.assign(1);
    },
  );
}
