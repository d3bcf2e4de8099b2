/** Counterpart of shaders/outlines/featureEdge.glsl: borders, creases, edges between materials, and contours along edges. */
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  INTERSECTION,
  MATERIAL_BORDER,
} from '../../../mesh/bake/outlineLayout.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { contours } from './contour.js';
import { endBetween, type Piece, showsBack, weigh } from './piece.js';
import type { OutlinePoint } from './points.js';
import { hasFlag } from './points.js';

const { If, bool, cross, dot, float, max, min, select, vec2 } = tsl;

const borders = /* @__PURE__ */ hatchingUniform('borders', 'float');
const creases = /* @__PURE__ */ hatchingUniform('creases', 'float');
const materialBorders = /* @__PURE__ */ hatchingUniform('materialBorders', 'float');
const intersections = /* @__PURE__ */ hatchingUniform('intersections', 'float');
const overshoot = /* @__PURE__ */ hatchingUniform('overshoot', 'float');

/** The part of the edge, as t from start to end, where one side faces the eye and the other does not. */
function contourAlong(left: Value, right: Value): { hasContour: Value; part: Value } {
  const startsOn = left.x.mul(right.x).lessThan(0).toVar();
  const endsOn = left.y.mul(right.y).lessThan(0).toVar();
  // The t at which a side turns away; outside [0, 1] if it never does.
  const turnOf = (side: Value): Value =>
    select(side.x.mul(side.y).lessThan(0), side.x.div(side.x.sub(side.y)), float(-1)).toVar();
  const leftTurn = turnOf(left);
  const rightTurn = turnOf(right);
  const turn = max(leftTurn, rightTurn).toVar();
  const first = min(leftTurn, rightTurn).toVar();
  const part = vec2(0, 1).toVar();
  const hasContour = bool(true).toVar();
  If(startsOn.and(endsOn).not(), () => {
    If(startsOn, () => {
      part.y.assign(turn);
    }).Else(() => {
      If(endsOn, () => {
        part.x.assign(turn);
      }).Else(() => {
        part.assign(vec2(first, turn));
        hasContour.assign(first.greaterThanEqual(0));
      });
    });
    hasContour.assign(hasContour.and(part.x.lessThan(part.y)));
  });
  return { hasContour, part };
}

/**
 * The normal of the visible side, towards the eye. Where one side faces the eye and the other does not, the back of the other hides it at
 * a concave edge.
 */
function seenNormal(left: OutlinePoint, right: OutlinePoint, sign: Value, isConcave: Value): Value {
  const isLeft = left.facing.greaterThan(0).toVar();
  const isRight = sign.mul(right.facing).greaterThan(0).toVar();
  const ofRight = sign.mul(right.normal).toVar();
  const isFront = showsBack().and(isConcave).not().toVar();
  const towards = (is: Value): Value => select(is, float(1), float(-1));
  return select(
    isLeft.equal(isRight),
    towards(isLeft).mul(left.normal.add(ofRight)),
    towards(isFront).mul(select(isLeft.equal(isFront), left.normal, ofRight)),
  );
}

/** @param isHidden whether outlines behind surfaces are drawn, which includes edges that face away */
export function featureEdge(
  piece: Piece,
  flags: Value,
  [leftStart, leftEnd, rightStart, rightEnd]: readonly [OutlinePoint, OutlinePoint, OutlinePoint, OutlinePoint],
  isHidden: boolean,
): void {
  // The normals of the right side point inwards where windings are contrary.
  const sign = select(hasFlag(flags, CONTRARY), float(-1), float(1)).toVar();
  const left = vec2(leftStart.facing, leftEnd.facing).toVar();
  const right = sign.mul(vec2(rightStart.facing, rightEnd.facing)).toVar();

  piece.isSmooth.assign(false);
  const whole = select(hasFlag(flags, CREASE), creases, float(0)).toVar();
  whole.assign(select(hasFlag(flags, MATERIAL_BORDER), max(whole, materialBorders), whole));
  const isIntersection = hasFlag(flags, INTERSECTION).toVar();
  whole.assign(select(isIntersection, intersections, whole));
  const isBorder = hasFlag(flags, BORDER).toVar();
  const isAlways = isBorder.or(isIntersection).toVar();
  const isBehind = max(max(left.x, left.y), max(right.x, right.y)).lessThanEqual(0).toVar();
  const isShown = showsBack().toVar();
  // What lies on a surface is invisible if both sides face away, unless the back shows. Lines where surfaces meet show from behind.
  const canBeSeen = isHidden ? bool(true) : isIntersection.or(isShown).or(isBehind.not());
  If(canBeSeen, () => {
    const { hasContour, part } = contourAlong(left, right);
    hasContour.assign(hasContour.and(isAlways.not()));
    const { start, end } = piece;
    If(isBorder.or(whole.greaterThan(0)), () => {
      // The whole edge is drawn, as wide as the contour where it is one.
      const one = (isContour: Value): Value => select(isContour, float(1), float(0)).toVar();
      const atStart = one(left.x.mul(right.x).lessThan(0).and(isIntersection.not()));
      const atEnd = one(left.y.mul(right.y).lessThan(0).and(isIntersection.not()));
      piece.contour.assign(select(isBorder, float(1), atStart.add(atEnd).mul(0.5)));
      endBetween(start, leftStart, leftEnd, float(0));
      endBetween(end, leftStart, leftEnd, float(1));
      const ofWhole = select(isBorder, float(0), whole).toVar();
      weigh(start, select(isBorder, borders, contours.mul(atStart)).toVar(), ofWhole);
      weigh(end, select(isBorder, borders, contours.mul(atEnd)).toVar(), ofWhole);
      start.overshoot.assign(select(hasFlag(flags, CORNER_AT_START), overshoot, float(0)));
      end.overshoot.assign(select(hasFlag(flags, CORNER_AT_END), overshoot, float(0)));
    }).Else(() => {
      If(hasContour, () => {
        endBetween(start, leftStart, leftEnd, part.x);
        endBetween(end, leftStart, leftEnd, part.y);
        piece.contour.assign(1);
        weigh(start, contours, float(0));
        weigh(end, contours, float(0));
      });
    });
    const turn = cross(leftStart.normal, sign.mul(rightStart.normal));
    const isConcave = dot(turn, leftEnd.position.sub(leftStart.position)).lessThan(0).toVar();
    start.normal.assign(seenNormal(leftStart, rightStart, sign, isConcave));
    end.normal.assign(seenNormal(leftEnd, rightEnd, sign, isConcave));
    // What is a ridge in front is a valley at the back, and the other way round.
    const isTurned = isShown.and(isBehind.or(hasContour.and(isConcave))).toVar();
    piece.isValley.assign(isBorder.not().and(isConcave.notEqual(isTurned)));
  });
}
