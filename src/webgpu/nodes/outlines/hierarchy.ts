/**
 * The twin of shaders/outlines/hierarchy.glsl: which outlines are seen, and how much they weigh by what lies behind them. A piece of outline
 * is judged at its spine, so that it is seen over its whole width or not at all.
 */
import type { NodeBuilder } from 'three/webgpu';
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { isOrthographic } from '../base/isOrthographic.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { depthAt, isInView, NOWHERE, viewHeightAt, viewport } from './sceneDepth.js';

const { Break, If, Loop, abs, bool, clamp, dot, float, floor, int, max, min, mix, select, smoothstep, vec2 } = tsl;
const { ACCENT_REACH, BEGINS_AS_PAPER, BESIDE, BEYOND, CUT_SLOPE, FULL_JUMP, IS_PAPER, LEAST_JUMP } = OUTLINE_CONSTANTS;

/** Pixels. */
export const outlineWidth: Value = /* @__PURE__ */ hatchingUniform('outlineWidth', 'float');
/** How much heavier an outline becomes where it passes before another. */
export const accents: Value = /* @__PURE__ */ hatchingUniform('accents', 'float');
/** Whether surfaces that lie nearer do not hide it. */
const isDrawnBefore = /* @__PURE__ */ hatchingUniform('isDrawnBefore', 'float');
/** Whether parts of its surface are not drawn. */
const isCutOut = /* @__PURE__ */ hatchingUniform('isCutOut', 'float');

/** Pieces that are no longer than this are judged at their ends, for fragments to share, and others in each fragment, pixels. */
export const SHORT = 16;

export interface Spine {
  /** Pixels, and the two ends in view space. */
  start: Value;
  viewStart: Value;
  viewEnd: Value;
  /** Unit. */
  along: Value;
  /** Pixels. */
  size: Value;
  /** How far the surface may lie before its own outline, view units. */
  tolerance: Value;
}

/**
 * Of a place between the ends on the screen the place between them in space: of an outline that runs away from the eye, the nearer half takes
 * more of the screen.
 */
export const alongLine = (t: Value, { viewStart, viewEnd }: Pick<Spine, 'viewStart' | 'viewEnd'>): Value =>
  select(isOrthographic(), t, t.mul(viewStart.z).div(mix(viewEnd.z, viewStart.z, t)));

function spineDepth(spine: Spine, pixel: Value): Value {
  // A little further than the ends: so far from them, texels may lie.
  const t = clamp(dot(pixel.sub(spine.start), spine.along).div(max(spine.size, 1e-3)), -0.25, 1.25).toVar();
  return mix(spine.viewStart.z.negate(), spine.viewEnd.z.negate(), alongLine(t, spine));
}

/** How far behind the outline that surface lies which is seen in a pixel. */
function gapAt(spine: Spine, pixel: Value, builder: NodeBuilder): Value {
  const texel = floor(pixel).add(0.5).toVar();
  return min(depthAt(texel, builder).sub(spineDepth(spine, texel)), NOWHERE).toVar();
}

export function isSeen(spine: Spine, place: Value, builder: NodeBuilder): Value {
  const beside = vec2(spine.along.y.negate(), spine.along.x).mul(BESIDE).toVar();
  const seen = bool(true).toVar();
  const isTested = isDrawnBefore.lessThan(0.5);
  If(isTested.and(isInView(place.add(beside))).and(isInView(place.sub(beside))), () => {
    const gap = max(gapAt(spine, place.add(beside), builder), gapAt(spine, place.sub(beside), builder));
    seen.assign(gap.greaterThanEqual(spine.tolerance.negate()));
  });
  return seen;
}

/** Whether the surface is not there, on neither side of a place: both show what lies behind it. */
export function isCutAway(spine: Spine, place: Value, builder: NodeBuilder): Value {
  const beside = vec2(spine.along.y.negate(), spine.along.x).mul(BESIDE).toVar();
  const cutAway = bool(false).toVar();
  If(isCutOut.greaterThan(0.5), () => {
    const pixel = viewHeightAt(spineDepth(spine, place)).div(viewport.w);
    const gap = min(gapAt(spine, place.add(beside), builder), gapAt(spine, place.sub(beside), builder));
    cutAway.assign(gap.greaterThan(spine.tolerance.add(pixel.mul(CUT_SLOPE))));
  });
  return cutAway;
}

/** Whether what lies so far behind, as a share of the height of the view, is as good as paper. */
const paperness = (gap: Value): Value => smoothstep(BEGINS_AS_PAPER, IS_PAPER, gap);

/**
 * The standing of an outline at a place on its spine: the share of paper in what lies behind it, and of an accent.
 *
 * @param halfWidth the most
 */
export function standingAt(spine: Spine, place: Value, halfWidth: Value, builder: NodeBuilder): Value {
  const height = viewHeightAt(spineDepth(spine, place)).toVar();
  const beside = vec2(spine.along.y.negate(), spine.along.x).mul(halfWidth.add(BEYOND)).toVar();
  const left = gapAt(spine, place.add(beside), builder);
  const right = gapAt(spine, place.sub(beside), builder);
  const outside = place.add(select(left.greaterThan(right), beside, beside.negate())).toVar();
  const here = min(max(left, right).div(height), 1).toVar();

  // Along the outline: the weight changes gradually where what lies behind it does, and an accent grows towards that place.
  const paper = paperness(here).toVar();
  const sum = float(1).toVar();
  const accent = float(0).toVar();
  const stride = outlineWidth.mul(ACCENT_REACH / ACCENT_STEPS).toVar();
  for (const side of [-1, 1]) {
    const last = here.toVar();
    Loop({ start: int(1), end: int(ACCENT_STEPS), type: 'int', condition: '<=' }, ({ i }) => {
      const step = float(i).toVar();
      const there = outside.add(step.mul(side).mul(stride).mul(spine.along)).toVar();
      const gap = min(gapAt(spine, there, builder).div(height), 1).toVar();
      If(min(gap, last).lessThan(LEAST_JUMP).or(isInView(there).not()), () => {
        Break();
      });
      const nearness = float(1).sub(step.sub(0.5).div(ACCENT_STEPS)).toVar();
      accent.assign(max(accent, nearness.mul(smoothstep(LEAST_JUMP, FULL_JUMP, abs(gap.sub(last))))));
      paper.addAssign(nearness.mul(paperness(gap)));
      sum.addAssign(nearness);
      last.assign(gap);
    });
  }
  return vec2(paper.div(sum), accent);
}

/** Half the width at a place. @param halves before the paper, and before a surface. @param contour the share of an outline that is one */
export const halfWidthAs = (standing: Value, halves: Value, contour: Value): Value =>
  mix(halves.y, halves.x, standing.x).mul(contour.mul(accents).mul(standing.y).add(1));
