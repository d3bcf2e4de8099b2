/** The screen triangle of a piece of outline: its width, its depth, and its place. */
import type { NodeBuilder } from 'three/webgpu';
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { mostOutlineFading } from '../chunks/fading.js';
import { hiddenWeight, type OutlineDefines, wobble } from './fragments.js';
import { accents, isSeen, lineWeightAt, outlineWidth, SHORT, type Spine } from './hierarchy.js';
import type { Piece, PieceEnd } from './piece.js';
import { type InstancePlace, radius } from './points.js';
import { hasSceneDepth, nearDistance, projection, viewport } from './sceneDepth.js';
import { objectToView } from './shade.js';
import * as varyings from './varyings.js';

const { abs, bool, cameraProjectionMatrix, cross, distance, dot, float, If, int, length, max, min, mix, pow } = tsl;
const { select, sqrt, vec2, vec3, vec4 } = tsl;
const { CROWDED_SHARE, EDGE_SLOPE, LEAST_WIDTH, LIFT_SHARE, LOOKED_BESIDE, MOST_RISE, ROUNDING } = OUTLINE_CONSTANTS;

/**
 * Counterpart of shaders/outlines/hiding.glsl: before the depth test each end is moved towards the eye along its ray, just far enough that
 * its own surface does not hide it. It keeps its place on the screen.
 */

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
    position.mul(min(lift.div(max(length(position), 1e-20)), 0.9).oneMinus()),
  );

/** Counterpart of shaders/outlines/cover.glsl: the screen triangle that covers a piece of outline. */

const objectScale = /* @__PURE__ */ hatchingUniform('objectScale', 'float');

/** Margin for the antialiased edge, pixels. */
const FRINGE = 1;
/** A factor on the near distance: just behind the near plane. */
const BEHIND_NEAR = 1.0001;

/**
 * Half widths before paper and before a surface, pixels, without the factor of fading.
 *
 * @param spacing the distance of the lines there, pixels
 */
function halfWidthsAt({ weight, innerWeight }: PieceEnd, spacing: Value, { HIDDEN }: OutlineDefines): Value {
  const weights = HIDDEN ? vec2(hiddenWeight(max(weight, innerWeight))) : vec2(weight, innerWeight);
  const most = max(spacing.mul(CROWDED_SHARE).sub(outlineWidth.mul(LEAST_WIDTH)), 0);
  return min(weights.mul(outlineWidth), most).mul(0.5).toVar();
}

/** View units per pixel at a point. */
const unitsToPixel = (position: Value): Value =>
  select(isOrthographic(), float(1), max(position.z.negate(), nearDistance))
    .mul(2)
    .div(abs(projection(1, 1)).mul(viewport.w));

const toClip = (position: Value): Value => cameraProjectionMatrix.mul(vec4(position, 1));

function pixelOf(clip: Value): Value {
  const c = clip.toVar();
  return viewport.xy.add(c.xy.mul(0.5).div(c.w).add(0.5).mul(viewport.zw));
}

/** The screen position of an object's origin. */
function originOf(place: InstancePlace): Value {
  const origin = toClip(objectToView(vec3(0), place)).toVar();
  origin.w.assign(max(origin.w, 1e-3));
  return pixelOf(origin);
}

/** Clips an end to the near plane, along the piece. */
function cutAt(z: Value, place: Value, cut: PieceEnd, otherPlace: Value, other: PieceEnd): void {
  const t = z.sub(place.z).div(otherPlace.z.sub(place.z)).toVar();
  place.assign(mix(place, otherPlace, t));
  for (const name of ['weight', 'innerWeight', 'anchor'] as const) cut[name].assign(mix(cut[name], other[name], t));
  cut.overshoot.assign(0);
}

const larger = (two: Value): Value => max(two.x, two.y);

const scaleOf = ([x, y, z]: InstancePlace): Value => objectScale.mul(pow(abs(dot(x, cross(y, z))), 1 / 3)).toVar();

/**
 * Writes the position and the varyings of one corner of the triangle.
 *
 * @param spacing the distance of the lines there, object units
 * @param clipPosition output
 */
export function coverPiece(
  piece: Piece,
  spacing: Value,
  corner: Value,
  place: InstancePlace,
  clipPosition: Value,
  defines: OutlineDefines,
  builder: NodeBuilder,
): void {
  const scale = scaleOf(place);
  const { start: from, end: to } = piece;
  if (defines.HIDDEN) {
    from.overshoot.assign(0);
    to.overshoot.assign(0);
  }
  const start = objectToView(from.position, place).toVar();
  const end = objectToView(to.position, place).toVar();

  // Points before the near plane cannot be projected.
  const near = nearDistance.mul(-BEHIND_NEAR).toVar();
  const isDrawn = isOrthographic().or(min(start.z, end.z).lessThanEqual(near)).toVar();
  If(isOrthographic().not().and(isDrawn), () => {
    If(start.z.greaterThan(near), () => {
      cutAt(near, start, from, end, to);
    }).Else(() => {
      If(end.z.greaterThan(near), () => {
        cutAt(near, end, to, start, from);
      });
    });
  });

  If(isDrawn, () => {
    const pixelAtStart = unitsToPixel(start).toVar();
    const pixelAtEnd = unitsToPixel(end).toVar();
    const halfStart = halfWidthsAt(from, spacing.mul(scale).div(pixelAtStart), defines);
    const halfEnd = halfWidthsAt(to, spacing.mul(scale).div(pixelAtEnd), defines);
    const halves = vec2(larger(halfStart), larger(halfEnd)).mul(accents.mul(piece.contour).add(1)).toVar();
    const liftedEnd = (place: Value, end: PieceEnd, half: Value, pixel: Value): Value =>
      lifted(place, liftOf(end, piece, half.mul(pixel), pixel, scale).toVar()).toVar();
    const nearStart = liftedEnd(start, from, halves.x, pixelAtStart);
    const nearEnd = liftedEnd(end, to, halves.y, pixelAtEnd);
    const clipStart = toClip(nearStart).toVar();
    const clipEnd = toClip(nearEnd).toVar();
    const a = pixelOf(toClip(start)).toVar();
    const b = pixelOf(toClip(end)).toVar();
    const depthA = clipStart.z.div(clipStart.w).toVar();
    const depthB = clipEnd.z.div(clipEnd.w).toVar();

    const size = distance(a, b).toVar();
    const along = select(size.greaterThan(1e-4), b.sub(a).div(max(size, 1e-4)), vec2(1, 0)).toVar();
    const slope = depthB.sub(depthA).div(max(size, FRINGE)).toVar();
    const middle = a.add(b).mul(0.5).toVar();
    const tolerance = toleranceOf(piece, max(pixelAtStart, pixelAtEnd), scale).toVar();
    const whole = vec4(1, 0, 1, 0);
    const weights = (defines.HIDDEN ? whole : select(piece.contour.greaterThan(0), vec4(-1), whole)).toVar();

    if (hasSceneDepth(builder)) {
      If(size.lessThan(SHORT), () => {
        const spine: Spine = { start: a, viewStart: start, viewEnd: end, along, size, tolerance };
        // Wholly hidden pieces are skipped; for hidden outlines, wholly visible ones.
        const drawn = bool(false).toVar();
        for (const one of [a, middle, b]) {
          const seen = isSeen(spine, one, builder);
          drawn.assign(drawn.or(defines.HIDDEN ? seen.not() : seen));
        }
        isDrawn.assign(drawn);
        If(drawn.and(weights.x.lessThan(0)), () => {
          const atStart = lineWeightAt(spine, a, larger(halfStart), builder).toVar();
          const atEnd = lineWeightAt(spine, b, larger(halfEnd), builder).toVar();
          weights.assign(vec4(atStart, atEnd));
        });
      });
    }

    If(isDrawn, () => {
      varyings.vEnds.assign(vec4(a, b));
      varyings.vHalfWidths.assign(vec4(halfStart.x, halfEnd.x, halfStart.y, halfEnd.y));
      varyings.vStart.assign(vec4(start, nearStart.z.negate()));
      varyings.vEnd.assign(vec4(end, nearEnd.z.negate()));
      varyings.vOvershoots.assign(vec2(from.overshoot, to.overshoot));
      varyings.vContour.assign(piece.contour);
      varyings.vTolerance.assign(tolerance);
      varyings.vLineWeights.assign(weights);
      if (defines.HIDDEN) varyings.vOrigin.assign(originOf(place));
      const reach = max(mostOutlineFading().mul(larger(halves)), 0.5)
        .add(FRINGE)
        .toVar();
      if (defines.WOBBLE) {
        reach.addAssign(wobble);
        varyings.vAnchorStart.assign(from.anchor);
        varyings.vAnchorEnd.assign(to.anchor);
      }
      // A right triangle around the bounding rectangle of the capsule: its right angle lies at a corner, and its legs are twice the sides.
      const reachAlong = size.mul(0.5).add(reach).add(max(from.overshoot, to.overshoot)).toVar();
      const x = select(corner.equal(int(1)), reachAlong.mul(3), reachAlong.negate()).toVar();
      const y = select(corner.equal(int(2)), reach.mul(3), reach.negate()).toVar();
      const pixel = middle.add(along.mul(x)).add(vec2(along.y.negate(), along.x).mul(y)).toVar();
      const onView = pixel.sub(viewport.xy).mul(2).div(viewport.zw).sub(1);
      clipPosition.assign(vec4(onView, depthA.add(depthB).mul(0.5).add(slope.mul(x)), 1));
    });
  });
}
