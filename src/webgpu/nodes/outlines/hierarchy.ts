/**
 * Counterpart of shaders/outlines/hierarchy.glsl: which outlines are visible, and their weight by what lies behind them. Tests are made at
 * the spine, so that an outline is visible over its whole width or not at all.
 */
import type { NodeBuilder } from 'three/webgpu';
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { depthAt, isInView, NOWHERE, viewHeightAt, viewport } from './sceneDepth.js';

const { Break, If, Loop, abs, bool, clamp, dot, float, floor, int, max, min, mix, select, smoothstep, vec2 } = tsl;
const { ACCENT_REACH, BEGINS_AS_PAPER, BESIDE, BEYOND, CUT_SLOPE, FULL_JUMP, IS_PAPER, LEAST_JUMP } = OUTLINE_CONSTANTS;

export const outlineWidth: Value = /* @__PURE__ */ hatchingUniform('outlineWidth', 'float');
export const accents: Value = /* @__PURE__ */ hatchingUniform('accents', 'float');
export const isDrawnBefore: Value = /* @__PURE__ */ hatchingUniform('isDrawnBefore', 'float');
const isCutOut = /* @__PURE__ */ hatchingUniform('isCutOut', 'float');

/** Longest piece, in pixels, that is tested at its ends; longer ones are tested per fragment. */
export const SHORT = 16;

export interface Spine {
  /** Start and end on the screen, pixels, and in view space. */
  start: Value;
  viewStart: Value;
  viewEnd: Value;
  /** Unit vector from start to end. */
  along: Value;
  /** Length, pixels. */
  size: Value;
  /** Distance by which a surface may lie before its own outline, view units. */
  tolerance: Value;
}

/** Perspective-correct interpolation along a line: the share in space at a share on the screen. */
export const alongLine = (t: Value, { viewStart, viewEnd }: Pick<Spine, 'viewStart' | 'viewEnd'>): Value =>
  select(isOrthographic(), t, t.mul(viewStart.z).div(mix(viewEnd.z, viewStart.z, t)));

function spineDepth(spine: Spine, pixel: Value): Value {
  // A little beyond the ends, where the texels of their pixels may lie.
  const t = clamp(dot(pixel.sub(spine.start), spine.along).div(max(spine.size, 1e-3)), -0.25, 1.25).toVar();
  return mix(spine.viewStart.z.negate(), spine.viewEnd.z.negate(), alongLine(t, spine));
}

/** The distance from the outline back to the surface that is visible in a pixel. */
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

/** Whether the outline's own surface is cut out at a point: both sides show what lies behind. */
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

/** The share to which a surface counts as paper. @param gap its distance behind the outline, as a share of the height of the view */
const paperness = (gap: Value): Value => smoothstep(BEGINS_AS_PAPER, IS_PAPER, gap);

/**
 * The share of paper in what lies behind an outline at a point, and the share of an accent.
 *
 * @param halfWidth greatest half width of the outline
 */
export function lineWeightAt(spine: Spine, place: Value, halfWidth: Value, builder: NodeBuilder): Value {
  const height = viewHeightAt(spineDepth(spine, place)).toVar();
  const beside = vec2(spine.along.y.negate(), spine.along.x).mul(halfWidth.add(BEYOND)).toVar();
  const left = gapAt(spine, place.add(beside), builder);
  const right = gapAt(spine, place.sub(beside), builder);
  const outside = place.add(select(left.greaterThan(right), beside, beside.negate())).toVar();
  const here = min(max(left, right).div(height), 1).toVar();

  // Along the outline the weight changes gradually with what lies behind it, and an accent grows towards such a change.
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
      const nearness = step.sub(0.5).div(ACCENT_STEPS).oneMinus().toVar();
      accent.assign(max(accent, nearness.mul(smoothstep(LEAST_JUMP, FULL_JUMP, abs(gap.sub(last))))));
      paper.addAssign(nearness.mul(paperness(gap)));
      sum.addAssign(nearness);
      last.assign(gap);
    });
  }
  return vec2(paper.div(sum), accent);
}

/**
 * Half the width at a point. @param halves before paper, and before a surface. @param contour share of the outline that is a contour or
 * border
 */
export const halfWidthAs = (lineWeight: Value, halves: Value, contour: Value): Value =>
  mix(halves.y, halves.x, lineWeight.x).mul(contour.mul(accents).mul(lineWeight.y).add(1));
