import { hiddenWeight } from '../../look/hiddenOutlines.js';
import { combined, cross, dot, mix, type Vec3, vectorAt } from '../../look/vectors.js';
import { asPhase } from '../../mesh/phases.js';
import { contourAlong, depthAcross, looksAway, suggestiveShare, taperAt } from '../shading/outlines.js';
import type { FeatureEdge, OutlineLook, OutlineMesh, OutlinePiece, PieceEnd } from './OutlineMesh.js';

/**
 * Finds all pieces of outlines on a mesh, before light and visibility. Yields its progress.
 *
 * @param withHidden whether to include creases whose sides both face away, which are always hidden
 */
export function* outlinePieces(
  mesh: OutlineMesh,
  look: OutlineLook,
  withHidden = false,
): Generator<number, OutlinePiece[], void> {
  const finder = new PieceFinder(mesh, look, withHidden);
  yield* asPhase(finder.readPoints(), 0, 0.5);
  const pieces: OutlinePiece[] = [];
  const add = (piece: OutlinePiece | null) => {
    if (piece && Math.max(weightOf(piece.start), weightOf(piece.end)) > 0) pieces.push(piece);
  };
  const count = mesh.triangles.length / 3;
  for (let t = 0; t < count && Math.max(look.contours, look.suggestiveContours) > 0; t++) {
    if (t % 2048 === 2047) yield 0.5 + (0.5 * t) / count;
    add(finder.contour(t) ?? finder.suggestiveContour(t));
  }
  for (const [i, edge] of mesh.edges.entries()) {
    if (i % 2048 === 2047) yield 1;
    add(finder.featureEdge(edge));
  }
  return pieces;
}

const weightOf = ({ weight, innerWeight }: PieceEnd): number => Math.max(weight, innerWeight);

class PieceFinder {
  /** n·v of each point, and its curvature along the line of sight times the radius. */
  private readonly facing: Float64Array;
  private readonly bend: Float64Array;

  constructor(
    private readonly mesh: OutlineMesh,
    private readonly look: OutlineLook,
    private readonly withHidden: boolean,
  ) {
    this.facing = new Float64Array(mesh.positions.length / 3);
    this.bend = new Float64Array(mesh.positions.length / 3);
  }

  *readPoints(): Generator<number, void, void> {
    const count = this.facing.length;
    for (let p = 0; p < count; p++) {
      if (p % 2048 === 2047) yield p / count;
      const n = this.normalOf(p);
      const v = this.toEye(this.positionOf(p));
      const facing = dot(n, v);
      const w = combined(1, v, -facing, n);
      const square = dot(w, w);
      this.facing[p] = facing;
      this.bend[p] = square > 0 ? dot(w, this.curved(p, w)) / square : 0;
    }
  }

  private readonly positionOf = (p: number): Vec3 => vectorAt(this.mesh.positions, 3 * p);

  private readonly normalOf = (p: number): Vec3 => vectorAt(this.mesh.normals, 3 * p);

  private readonly seenFrom = (side: number, p: number): Vec3 => combined(side, this.normalOf(p), 0, NONE);

  private curved(p: number, [x, y, z]: Vec3): Vec3 {
    const k = this.mesh.curvatures;
    const o = 6 * p;
    return [
      k[o] * x + k[o + 1] * y + k[o + 2] * z,
      k[o + 1] * x + k[o + 3] * y + k[o + 4] * z,
      k[o + 2] * x + k[o + 4] * y + k[o + 5] * z,
    ];
  }

  private toEye(position: Vec3): Vec3 {
    const [x, y, z, w] = this.mesh.eye;
    return combined(1, [x, y, z], -w, position);
  }

  /** The end at a share of the way from a to b. */
  private endBetween(a: number, b: number, share: number): PieceEnd {
    const { placeOf, anchors } = this.mesh;
    const key = share === 0 ? `v${placeOf[a]}` : share === 1 ? `v${placeOf[b]}` : pairKey(a, b);
    return {
      position: combined(1 - share, this.positionOf(a), share, this.positionOf(b)),
      anchor: combined(1 - share, vectorAt(anchors, 3 * a), share, vectorAt(anchors, 3 * b)),
      normal: combined(1 - share, this.normalOf(a), share, this.normalOf(b)),
      bend: mix(this.bend[a], this.bend[b], share),
      weight: 0,
      innerWeight: 0,
      left: 1,
      overshoot: 0,
      key,
    };
  }

  private weigh(end: PieceEnd, ofContour: number, whole: number): void {
    end.weight = Math.max(ofContour, whole);
    end.innerWeight = Math.max(this.look.innerContours * ofContour, whole);
  }

  private readonly cornersOf = (triangle: number): Vec3 => vectorAt(this.mesh.triangles, 3 * triangle);

  /** The places on the edges of a triangle where values of its points are 0; null if they have one sign. */
  private zeroSet(triangle: number, values: Float64Array): readonly [PieceEnd, PieceEnd] | null {
    const [a, b, c] = this.cornersOf(triangle);
    const [isA, isB, isC] = [values[a] >= 0, values[b] >= 0, values[c] >= 0];
    if (isA === isB && isB === isC) return null;
    const [alone, one, two] = isB === isC ? [a, b, c] : isA === isC ? [b, c, a] : [c, a, b];
    const zero = (other: number): PieceEnd => {
      const end = this.endBetween(alone, other, values[alone] / (values[alone] - values[other]));
      // Also where it passes through a point: it continues over the edge by a piece of length 0.
      return { ...end, key: pairKey(alone, other) };
    };
    return [zero(one), zero(two)];
  }

  /** @param side 1 if it is seen from the front of the surface, −1 from the back */
  private smoothPiece(
    triangle: number,
    ends: readonly [PieceEnd, PieceEnd],
    contour: number,
    side: number,
  ): OutlinePiece {
    const [start, end] = ends;
    const [a, b, c] = this.cornersOf(triangle);
    const corners = [this.positionOf(a), this.positionOf(b), this.positionOf(c)] as const;
    const normals = [this.seenFrom(side, a), this.seenFrom(side, b), this.seenFrom(side, c)] as const;
    const toEye = this.toEye(corners[0]);
    const extent = depthAcross(corners, start.position, end.position, toEye);
    const ownCover = looksAway(corners, normals, toEye) ? extent : 0;
    const spacing = this.mesh.spacings[triangle];
    return { start, end, isSmooth: true, contour, extent, ownCover, isValley: false, spacing };
  }

  /** The zero set of n·v, linear over a triangle. */
  contour(triangle: number): OutlinePiece | null {
    const { facing, look } = this;
    const ends = this.zeroSet(triangle, facing);
    if (!ends) return null;
    // The back has its contours where the front bends towards the eye.
    const side = look.showsBack && ends[0].bend + ends[1].bend < 0 ? -1 : 1;
    turnTo(side, ends);
    for (const end of ends) this.weigh(end, look.contours * taperAt(end.bend, look.taper), 0);
    return this.smoothPiece(triangle, ends, 1, side);
  }

  /** The zero set of the curvature along the line of sight, where the triangle or its back faces the eye. */
  suggestiveContour(triangle: number): OutlinePiece | null {
    const { suggestiveContours, showsBack } = this.look;
    const corners = this.cornersOf(triangle);
    const isBehind = showsBack && corners.every((p) => this.facing[p] < 0);
    if (suggestiveContours === 0 || (!isBehind && corners.some((p) => this.facing[p] <= 0))) return null;
    const ends = this.zeroSet(triangle, this.bend);
    if (!ends) return null;
    const side = isBehind ? -1 : 1;
    turnTo(side, ends);
    const [a, b, c] = corners.map((p) => ({
      position: this.positionOf(p),
      normal: this.seenFrom(side, p),
      bend: side * this.bend[p],
    }));
    const sum = combined(1, combined(1, a.position, 1, b.position), 1, c.position);
    const toEye = this.toEye(combined(1 / 3, sum, 0, sum));
    const weight = suggestiveContours * suggestiveShare([a, b, c], toEye, this.mesh.radius);
    for (const end of ends) {
      this.weigh(end, 0, weight);
      // A contour that crosses the same edge is not joined to it.
      end.key = `s${end.key}`;
    }
    return this.smoothPiece(triangle, ends, 0, side);
  }

  featureEdge(edge: FeatureEdge): OutlinePiece | null {
    const { facing, look } = this;
    const { leftStart, leftEnd, rightStart, rightEnd, isBorder, isIntersection } = edge;
    // With contrary windings the normals of the right side point inwards.
    const sign = edge.isContrary ? -1 : 1;
    const left = [facing[leftStart], facing[leftEnd]] as const;
    const right = [sign * facing[rightStart], sign * facing[rightEnd]] as const;
    const isBehind = Math.max(...left, ...right) <= 0;
    // What lies on a surface is invisible if both sides face away, unless the back shows. Lines where surfaces meet show from behind.
    if (!isIntersection && !this.withHidden && !look.showsBack && isBehind) return null;
    const ofSurface = Math.max(edge.isCrease ? look.creases : 0, edge.isMaterialBorder ? look.materialBorders : 0);
    const whole = isIntersection ? look.intersections : ofSurface;
    const isContour = [left[0] * right[0] < 0, left[1] * right[1] < 0].map((isOne) => isOne && !isIntersection);
    const turn = cross(this.normalOf(leftStart), this.seenFrom(sign, rightStart));
    const along = combined(1, this.positionOf(leftEnd), -1, this.positionOf(leftStart));
    const isConcave = dot(turn, along) < 0;
    const normals = [
      this.seenNormal(leftStart, rightStart, sign, isConcave),
      this.seenNormal(leftEnd, rightEnd, sign, isConcave),
    ] as const;
    let part: readonly [number, number] | null = [0, 1];
    let contour = isBorder ? 1 : 0.5 * (Number(isContour[0]) + Number(isContour[1]));
    if (isIntersection && whole === 0) return null;
    if (!isBorder && whole === 0) {
      part = contourAlong(left, right);
      contour = 1;
    }
    if (!part) return null;
    const ends = part.map((share) => this.endOnEdge(edge, share, left)) as [PieceEnd, PieceEnd];
    if (isBorder || whole > 0) {
      if (edge.isCornerAtStart) ends[0].overshoot = look.overshoot;
      if (edge.isCornerAtEnd) ends[1].overshoot = look.overshoot;
    }
    for (const [i, end] of ends.entries()) {
      end.normal = normals[i];
      if (isBorder) this.weigh(end, look.borders, 0);
      else if (whole > 0) this.weigh(end, isContour[i] ? look.contours : 0, whole);
      else this.weigh(end, look.contours, 0);
    }
    // What is a ridge in front is a valley at the back, and the other way round.
    const isTurned = look.showsBack && (isBehind || (isConcave && contourAlong(left, right) !== null));
    const isValley = !isBorder && isConcave !== isTurned;
    const { spacing } = edge;
    return { start: ends[0], end: ends[1], isSmooth: false, contour, extent: 0, ownCover: 0, isValley, spacing };
  }

  private endOnEdge(
    { leftStart, leftEnd, rightStart, rightEnd }: FeatureEdge,
    share: number,
    left: readonly [number, number],
  ): PieceEnd {
    const end = this.endBetween(leftStart, leftEnd, share);
    if (share === 0 || share === 1) return end;
    // If the contour ends within the edge, it continues through the triangle of the side that turns away there.
    const isLeft = Math.abs(share - left[0] / (left[0] - left[1])) < 1e-9;
    return { ...end, key: isLeft ? pairKey(leftStart, leftEnd) : pairKey(rightStart, rightEnd) };
  }

  /**
   * The normal of the visible side, towards the eye. Where one side faces the eye and the other does not, the back of the other hides it
   * at a concave edge.
   */
  private seenNormal(left: number, right: number, sign: number, isConcave: boolean): Vec3 {
    const [n, m] = [this.normalOf(left), this.seenFrom(sign, right)];
    const [isLeft, isRight] = [this.facing[left] > 0, sign * this.facing[right] > 0];
    if (isLeft === isRight) return isLeft ? combined(1, n, 1, m) : combined(-1, n, -1, m);
    const isFront = !(this.look.showsBack && isConcave);
    return combined(isFront ? 1 : -1, isLeft === isFront ? n : m, 0, NONE);
  }
}

const NONE: Vec3 = [0, 0, 0];

/** Turns the ends of a smooth piece to the side of the surface that is seen: 1 for the front, −1 for the back. */
function turnTo(side: number, ends: readonly PieceEnd[]): void {
  for (const end of ends) {
    end.normal = combined(side, end.normal, 0, NONE);
    end.bend *= side;
  }
}

const pairKey = (a: number, b: number): string => (a < b ? `${a}_${b}` : `${b}_${a}`);

/** The look of hidden outlines: all of one weight, whatever the light and what lies behind them. */
export const hiddenLook = (look: OutlineLook): OutlineLook => ({
  ...look,
  innerContours: 1,
  shadeWeights: [1, 1],
  lostEdges: 0,
});

/** Sets the weights of pieces to those of hidden outlines. */
export function weighHidden(pieces: readonly OutlinePiece[]): void {
  for (const { start, end } of pieces) {
    for (const side of [start, end])
      side.weight = side.innerWeight = hiddenWeight(Math.max(side.weight, side.innerWeight));
  }
}
