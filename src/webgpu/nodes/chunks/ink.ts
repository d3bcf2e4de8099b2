import { normalDistribution } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { clamp, fwidth, max, min, mix, select, smoothstep, sqrt, vec4 } = tsl;

/** Counterpart of shaders/chunks/ink.glsl: turns a field of thresholds into what is printed. */

const edgePixels = /* @__PURE__ */ hatchingUniform('edgePixels', 'float');

/** Octaves of crowding at which strokes begin to turn into a flat tone, and at which they have. */
const CROWDED_FROM = 1;
const CROWDED = 2.5;

/** A field that is compared with a tone: standard normal, except for the skew of mixed levels. */
export interface HatchField {
  g: Value;
  /** The mixing of levels: 0 on a level, 1 half way between two. */
  mixing: Value;
}

/** The mix of two skewed fields is not normal. This cubic corrects h; it is fitted to generated maps. */
export function unskew(h: Value, mixing: Value): Value {
  const x = h.sub(0.42).toVar();
  return h.add(mixing.mul(h).mul(h.oneMinus()).mul(x.mul(x).mul(1.07).sub(0.14)));
}

/** The darkness of a place that becomes ink at the tone h. The mean over all h is the tone. @param width width of the edge, in h */
export function darkenedFrom(h: Value, tone: Value, width: Value): Value {
  // Near blank and near full the edge is moved: beyond [0, 1] it would lose ink.
  const nearest = min(tone, tone.oneMinus()).toVar();
  const moved = sqrt(width.mul(2).mul(nearest)).sub(width.mul(0.5)).toVar();
  const level = select(nearest.lessThan(width.mul(0.5)), select(tone.lessThan(0.5), moved, moved.oneMinus()), tone);
  return clamp(level.sub(h).div(width).add(0.5), 0, 1);
}

/** The share to which strokes have turned into a flat tone. @param crowding octaves by which strokes are finer than drawn */
export const crowdedShare = (crowding: Value): Value => smoothstep(CROWDED_FROM, CROWDED, crowding);

/** The ink of a field at a tone. Uses screen-space derivatives, so it must not be called in branches. */
export function inkAt(field: HatchField, tone: Value, crowding: Value): Value {
  const h = normalDistribution(field.g).toVar();
  const width = clamp(fwidth(field.g).mul(h.y).mul(edgePixels), 1e-7, 1).toVar();
  const ink = darkenedFrom(unskew(h.x, field.mixing), tone, width);
  // At grazing angles a pixel holds several strokes. A single sample would alias; their mean is the tone.
  return mix(ink, tone, min(edgePixels, 1).mul(crowdedShare(crowding)));
}

/** Counterpart of shaders/chunks/printedColor.glsl: ink and paper as one colour with an alpha, not premultiplied. */

const ink = /* @__PURE__ */ hatchingUniform('ink', 'color');
export const paper: Value = /* @__PURE__ */ hatchingUniform('paper', 'color');
const paperOpacity = /* @__PURE__ */ hatchingUniform('paperOpacity', 'float');

/**
 * @param ground paper, tinted by the surface colour
 * @param darkness of the hatch
 * @param isMultiplied whether strokes are tinted by the ground too
 */
export function printedColor(ground: Value, darkness: Value, isMultiplied: boolean, isOpaque: boolean): Value {
  const stroke = isMultiplied ? ground.mul(ink) : ink;
  if (isOpaque) return vec4(mix(ground, stroke, darkness), 1);
  const alpha = paperOpacity.oneMinus().mul(darkness.oneMinus()).oneMinus().toVar();
  return vec4(mix(ground.mul(paperOpacity), stroke, darkness).div(max(alpha, 1e-6)), alpha);
}
