/** The ink of outlines at a fragment: visible or hidden, by pen or by a dry medium, with an unsteady hand. */
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { lineCoverage, normalDistribution, pixelFromBelow } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { toothField } from '../chunks/dryMedia.js';
import { outlineFadingAt } from '../chunks/fading.js';
import {
  accents,
  alongLine,
  halfWidthAs,
  isCutAway,
  isSeen,
  lineWeightAt,
  outlineWidth,
  type Spine,
} from './hierarchy.js';
import { radius } from './points.js';
import { hasSceneDepth } from './sceneDepth.js';
import {
  vAnchorEnd,
  vAnchorStart,
  vContour,
  vEnd,
  vEnds,
  vHalfWidths,
  vLineWeights,
  vOrigin,
  vOvershoots,
  vStart,
  vTolerance,
} from './varyings.js';

const { abs, bool, clamp, Discard, distance, dot, float, floor, Fn, If, length, max, min, mix, pow, select } = tsl;
const { sin, smoothstep, vec2, vec3, vec4 } = tsl;
const { ACROSS_BEND, ACROSS_BENT, DASH, FAINT, FINE_PHASE, GAP, HIDDEN_WEIGHT, STRAY_ACROSS } = OUTLINE_CONSTANTS;
const { STRAY_FINELY, STRAY_SHARES, STRAY_UP, UP_BEND, UP_BENT, UP_PHASE, WHOLE_FROM } = OUTLINE_CONSTANTS;

/** The choices that the program of outlines depends on, named as the GLSL defines. */
export interface OutlineDefines {
  /** Whether hidden outlines are drawn, instead of visible ones. */
  readonly HIDDEN: boolean;
  readonly PAPER_GRAIN: boolean;
  readonly WOBBLE: boolean;
}

/** Counterpart of shaders/outlines/wobble.glsl: the unsteadiness of a hand, a slow screen-space offset that is fixed to the object. */

export const wobble: Value = /* @__PURE__ */ hatchingUniform('wobble', 'float');

const wave = (p: Value, direction: readonly [number, number, number]): Value => dot(p, vec3(...direction));

/** The pressure of the hand along the outline, from −1 to 1, in waves of about half the radius. */
function pressureWave(anchor: Value): Value {
  const p = anchor.div(radius).toVar();
  return sin(dot(p, vec3(-5.3, 6.1, 7.9)).add(sin(dot(p, vec3(4.7, 3.9, -6.7))).mul(2.1)));
}

/** Sines in three directions, whose phases vary with one another, so that nothing seems to repeat. */
export function wobbleAt(anchor: Value): Value {
  const p = anchor.div(radius).toVar();
  const a = sin(wave(p, STRAY_ACROSS).add(sin(wave(p, ACROSS_BENT)).mul(ACROSS_BEND)));
  const b = sin(
    wave(p, STRAY_UP)
      .add(sin(wave(p, UP_BENT)).mul(UP_BEND))
      .add(UP_PHASE),
  );
  const c = sin(wave(p, STRAY_FINELY).add(FINE_PHASE)).mul(STRAY_SHARES[1]).toVar();
  return vec2(a.mul(STRAY_SHARES[0]).add(c), b.mul(STRAY_SHARES[0]).sub(c)).mul(wobble);
}

/** Counterpart of shaders/outlines/hidden.glsl: outlines behind a surface, thin and dashed or faint, as in technical drawings. */

const isDashed = /* @__PURE__ */ hatchingUniform('isDashed', 'float');

export const hiddenWeight = (weight: Value): Value => smoothstep(0, WHOLE_FROM, weight).mul(HIDDEN_WEIGHT);

/**
 * The share of a pixel that is drawn, by dashes and gaps. All in pixels.
 *
 * @param place along a piece that is `size` long
 * @param fromOrigin from the screen position of the object, so that dashes move with it
 */
function hiddenCoverage(place: Value, size: Value, along: Value, fromOrigin: Value, width: Value): Value {
  const coverage = float(FAINT).toVar();
  If(isDashed.greaterThan(0.5), () => {
    const gap = width.mul(GAP).toVar();
    const period = width.mul(DASH + GAP).toVar();
    const x = float(0).toVar();
    If(size.greaterThan(period.mul(2)), () => {
      // An edge begins and ends with a dash.
      const whole = size.add(gap).toVar();
      period.assign(whole.div(floor(whole.div(period).add(0.5))));
      x.assign(clamp(place, 0, size));
    }).Else(() => {
      // The pieces of a curve are shorter than dashes, so their pattern follows the screen.
      x.assign(select(abs(along.x).greaterThan(abs(along.y)), fromOrigin.x, fromOrigin.y));
    });
    const half = period.sub(gap).mul(0.5).toVar();
    const within = x.sub(period.mul(floor(x.div(period))));
    coverage.assign(clamp(half.sub(abs(within.sub(half))).add(0.5), 0, 1));
  });
  return coverage;
}

/**
 * Counterpart of shaders/outlines/dryOutline.glsl: outlines of pencil, charcoal and chalk. They are soft at their sides, vary in pressure
 * along the way, and catch on the tooth of the paper.
 */

const paperGrain = /* @__PURE__ */ hatchingUniform('paperGrain', 'float');

/** The tooth above which the sides fade from the middle on. */
const SOFT_TOOTH = 0.3;
/** The effect of tooth on outlines, which are pressed harder than hatching. */
const CAUGHT = 0.75;
/** The range of pressures over which an outline goes from none to full ink. */
const OUTLINE_SOFTNESS = 0.65;
/** The share of pressure that an unsteady hand loses along the way. */
const LIFTED = 0.5;

/**
 * The share of full ink that is left.
 *
 * @param across 0 in the middle of the outline, 1 at its side
 * @param along a wave along it, from −1 to 1
 * @param pixel of the render target, counted from the lower left
 */
export function dryInk(across: Value, along: Value, pixel: Value): Value {
  const side = min(paperGrain.div(SOFT_TOOTH), 1).mul(across).mul(across);
  const loss = paperGrain.mul(LIFTED).mul(float(0.5).sub(along.mul(0.5)));
  const pressure = side.oneMinus().mul(loss.oneMinus());
  const height = normalDistribution(toothField(pixel)).x;
  return clamp(pressure.sub(paperGrain.mul(CAUGHT).mul(height)).div(OUTLINE_SOFTNESS), 0, 1);
}

/**
 * Counterpart of shaders/outlines/outlines.frag. A piece of outline is a capsule on the screen, so that pieces join without mitres; its
 * edge fades over one pixel.
 */

const ink = /* @__PURE__ */ hatchingUniform('ink', 'color');
export const opacity: Value = /* @__PURE__ */ hatchingUniform('opacity', 'float');

/** The point on the spine that a fragment belongs to, view space. Fog depends on it. */
export const spinePosition: Value = /* @__PURE__ */ tsl.property('vec3', 'outlineSpinePosition');

/** The point on the spine nearest to a fragment. */
interface OnSpine {
  spine: Spine;
  /** Distance along the outline from its start, pixels. */
  place: Value;
  /** The pixel, with the wobble of the outline subtracted. */
  pixel: Value;
  /** The share of the way from start to end on the screen. */
  t: Value;
}

export function onSpine({ WOBBLE }: OutlineDefines): OnSpine {
  const pixel = pixelFromBelow().toVar();
  const ends = vEnds.zw.sub(vEnds.xy).toVar();
  const size = length(ends).toVar();
  const along = select(size.greaterThan(1e-4), ends.div(max(size, 1e-4)), vec2(1, 0)).toVar();
  const spine = { start: vEnds.xy, viewStart: vStart.xyz, viewEnd: vEnd.xyz, along, size, tolerance: vTolerance };
  const place = dot(pixel.sub(spine.start), along).toVar();
  if (WOBBLE) {
    const share = alongLine(clamp(place.div(max(size, 1e-4)), 0, 1).toVar(), spine);
    pixel.assign(pixel.sub(wobbleAt(mix(vAnchorStart, vAnchorEnd, share))));
    place.assign(dot(pixel.sub(spine.start), along));
  }
  const t = clamp(place, 0, size).div(max(size, 1e-4)).toVar();
  return { spine, place, pixel, t };
}

const canvasBlend = /* @__PURE__ */ hatchingUniform('canvasBlend', 'vec4');

/** An sRGB value as linear light. */
const decoded = (grey: Value): Value =>
  select(grey.lessThanEqual(0.04045), grey.div(12.92), pow(grey.add(0.055).div(1.055), 2.4));

/**
 * The opacity that gives in linear light, which WebGPURenderer blends for a canvas, the grey that `alpha` gives in sRGB, which
 * WebGLRenderer blends there.
 */
function asOnCanvas(alpha: Value): Value {
  const light = decoded(mix(canvasBlend.x, canvasBlend.y, alpha).toVar());
  return select(canvasBlend.w.equal(0), alpha, light.sub(canvasBlend.z).mul(canvasBlend.w)).toVar();
}

/** The ink with an opacity. */
export function inked(alpha: Value): Value {
  Discard(alpha.lessThan(0.002));
  // three.js multiplies by the opacity of the material.
  return vec4(ink, asOnCanvas(alpha).div(opacity));
}

/** The ink, and the share of a pixel that it covers. */
export const fragments = (defines: OutlineDefines): Value =>
  Fn((builder) => {
    const { spine, place, pixel, t } = onSpine(defines);
    const { size } = spine;
    const onOutline = clamp(place, vOvershoots.x.negate(), size.add(vOvershoots.y)).toVar();
    const away = distance(pixel, spine.start.add(onOutline.mul(spine.along))).toVar();
    spinePosition.assign(mix(vStart.xyz, vEnd.xyz, alongLine(t, spine)));
    // Per fragment, not at the ends: an edge may run across the whole sheet.
    const usual = mix(vHalfWidths.xz, vHalfWidths.yw, t);
    const halves = outlineFadingAt(spinePosition, pixelFromBelow().toVar()).mul(usual).toVar();
    const most = max(halves.x, halves.y).toVar();
    const coverage = float(0).toVar();
    If(away.lessThanEqual(max(most.mul(accents.add(1)), 0.5).add(0.5)), () => {
      const halfWidth = halves.x.toVar();
      const isDrawn = bool(true).toVar();
      if (hasSceneDepth(builder)) {
        const seen = spine.start.add(clamp(place, 0, size).mul(spine.along)).toVar();
        const isBefore = isSeen(spine, seen, builder);
        isDrawn.assign((defines.HIDDEN ? isBefore.not() : isBefore).and(isCutAway(spine, seen, builder).not()));
        If(isDrawn, () => {
          const lineWeight = mix(vLineWeights.xy, vLineWeights.zw, t).toVar();
          If(vLineWeights.x.lessThan(0), () => {
            lineWeight.assign(lineWeightAt(spine, seen, most, builder));
          });
          halfWidth.assign(halfWidthAs(lineWeight, halves, vContour));
        });
      }
      // Round ends fill the joints. Their edges lie inside, or two fading edges would add up beside each joint.
      const isAtEnd = place.notEqual(onOutline).toVar();
      If(isDrawn, () => {
        coverage.assign(lineCoverage(away, halfWidth, select(isAtEnd, float(0), float(0.5))));
        if (defines.HIDDEN) {
          coverage.mulAssign(hiddenCoverage(place, size, spine.along, pixel.sub(vOrigin), outlineWidth));
        }
        if (defines.PAPER_GRAIN) {
          const pressed = defines.WOBBLE ? pressureWave(mix(vAnchorStart, vAnchorEnd, alongLine(t, spine))) : float(1);
          // Overlapping ends are narrower, or their soft sides would add up at each joint.
          const across = away.div(max(halfWidth, 0.5)).mul(select(isAtEnd, float(1.6), float(1)));
          coverage.mulAssign(dryInk(min(across, 1).toVar(), pressed, pixelFromBelow().toVar()));
        }
      });
    });
    return inked(coverage.mul(opacity).toVar());
  })();
