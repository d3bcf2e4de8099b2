/** Counterpart of shaders/outlines/piece.glsl. A GLSL struct is an object of shader variables here, which functions write to. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { type OutlinePoint, towardsEye } from './points.js';

const { bool, cross, dot, float, length, max, min, mix, normalize, select, vec3 } = tsl;

/** An end of a piece of outline. */
export interface PieceEnd {
  /** Object space. */
  position: Value;
  /** Object space, at rest. */
  anchor: Value;
  /** A vector of any length. */
  normal: Value;
  /** Weight of the outline before paper. */
  weight: Value;
  /** Weight before a surface. */
  innerWeight: Value;
  /** `bend` of OutlinePoint. */
  bend: Value;
  /** Length by which the outline overshoots the end, pixels. */
  overshoot: Value;
}

export interface Piece {
  start: PieceEnd;
  end: PieceEnd;
  /** Depth of the surface beside the piece along the line of sight, object units. */
  extent: Value;
  /** The part of that depth that may lie before a visible piece, object units. */
  ownCover: Value;
  /** The share of the piece that is a contour or a border. */
  contour: Value;
  /** Whether it lies on a surface, not on an edge. */
  isSmooth: Value;
  /** Whether it is a concave edge. */
  isValley: Value;
  /** 1 if it is seen from the front of the surface, −1 from the back. */
  side: Value;
}

const noEnd = (): PieceEnd => ({
  position: vec3(0).toVar(),
  anchor: vec3(0).toVar(),
  normal: vec3(0, 0, 1).toVar(),
  weight: float(0).toVar(),
  innerWeight: float(0).toVar(),
  bend: float(0).toVar(),
  overshoot: float(0).toVar(),
});

export const noPiece = (): Piece => ({
  start: noEnd(),
  end: noEnd(),
  extent: float(0).toVar(),
  ownCover: float(0).toVar(),
  contour: float(0).toVar(),
  isSmooth: bool(true).toVar(),
  isValley: bool(false).toVar(),
  side: float(1).toVar(),
});

export const isPiece = ({ start, end }: Piece): Value =>
  max(max(start.weight, end.weight), max(start.innerWeight, end.innerWeight)).greaterThan(0);

/** Writes the end at t ∈ [0, 1] from a to b. */
export function endBetween(end: PieceEnd, a: OutlinePoint, b: OutlinePoint, t: Value): void {
  const at = t.toVar();
  end.position.assign(mix(a.position, b.position, at));
  end.anchor.assign(mix(a.anchor, b.anchor, at));
  end.normal.assign(mix(a.normal, b.normal, at));
  end.bend.assign(mix(a.bend, b.bend, at));
}

/** 1 if the back of the surface can be seen, else 0. */
const backShown = /* @__PURE__ */ hatchingUniform('showsBack', 'float');
export const showsBack = (): Value => backShown.greaterThan(0.5);

/** Makes a piece one that is seen from the back of the surface. */
export function turnToBack({ start, end, side }: Piece): void {
  side.assign(-1);
  for (const { normal, bend } of [start, end]) {
    normal.assign(normal.negate());
    bend.assign(bend.negate());
  }
}

const innerContours = /* @__PURE__ */ hatchingUniform('innerContours', 'float');

/** Sets the weights of an end. @param ofContour weight as a contour or a border. @param whole weight as anything else */
export function weigh(end: PieceEnd, ofContour: Value, whole: Value): void {
  end.weight.assign(max(ofContour, whole));
  end.innerWeight.assign(max(innerContours.mul(ofContour), whole));
}

/**
 * Sets the depth of a piece's triangle along the line of sight. It is measured across the piece: along it, a long triangle may run away
 * from the eye.
 */
export function measureExtent(piece: Piece, a: OutlinePoint, b: OutlinePoint, c: OutlinePoint, eye: Value): void {
  const v = normalize(towardsEye(a.position, eye)).toVar();
  const along = piece.end.position.sub(piece.start.position).toVar();
  along.assign(along.div(max(length(along), 1e-20)));
  const ab = b.position.sub(a.position).toVar();
  const ac = c.position.sub(a.position).toVar();
  const across = v.sub(dot(v, along).mul(along)).toVar();
  const depthB = dot(ab, across).toVar();
  const depthC = dot(ac, across).toVar();
  piece.extent.assign(max(max(depthB, depthC), 0).sub(min(min(depthB, depthC), 0)));
  // A triangle that faces away is hidden by its neighbours, even where the smooth surface has its contour on it.
  const n = cross(ab, ac).toVar();
  const isFacing = dot(n, v)
    .mul(dot(n, piece.side.mul(a.normal.add(b.normal).add(c.normal))))
    .greaterThan(0);
  piece.ownCover.assign(select(isFacing, float(0), piece.extent));
}
