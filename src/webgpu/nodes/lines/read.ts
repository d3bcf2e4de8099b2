/** The families of lines at a fragment, from a field in space or from the form. */
import type { Light } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { FIELD_CONSTANTS, FORM_CONSTANTS, HAND_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { SCREEN_CONSTANTS } from '../../../look/constants/patternConstants.js';
import type { HatchingTechnique } from '../../../look/hatchingProperties.js';
import { isInFullShadow, type ReceivedShadow } from '../base/lights.js';
import { type Input, tsl, type Value } from '../base/values.js';
import { readViewToAnchor } from '../chunks/anchor.js';
import { followsForm } from '../chunks/lightOrientation.js';
import { centreOfScreen, type ScreenMap, screenGradient, viewUnitsPerPixel } from '../chunks/screenGradient.js';
import type { CastShadows } from '../chunks/strokeShadows.js';
import { objectToField } from './emit.js';
import {
  across,
  type DirectionChoices,
  fieldAt,
  fieldLight,
  firstField,
  isByVertex,
  vField,
  vFieldLight,
  vFieldNormal,
  vFieldPoint,
  vForm,
  vFormCrossing,
} from './fields.js';
import { handPoint, handPressure, irregularity, slowWaves } from './hand.js';

const {
  abs,
  cross,
  dFdx,
  dFdy,
  dot,
  float,
  If,
  length,
  max,
  min,
  mix,
  normalize,
  positionView,
  select,
  smoothstep,
  sqrt,
  vec2,
} = tsl;
const { vec3, vec4 } = tsl;
const { BARE_SLOPE, SIDE_FADE, SPARSEST_SLOPE } = FIELD_CONSTANTS;
const { COARSEST_OCTAVES, WIDTH_WAVE } = FORM_CONSTANTS;

/** Lines that are level sets of one function. */
export interface Family {
  value: Value;
  /** Its change from one pixel to the next, on the smooth surface. */
  perPixel: Value;
  /** Its change from one pixel to the next on the flat triangle. */
  trianglePerPixel: Value;
  /** Its change along the surface, per tile, by which lines are spaced on the object. */
  rise: Value;
  /** Its gradient, of any length; lines lie across it. */
  gradient: Value;
  /** The octave of the widest spacing of its lines. */
  coarsest: Input;
  /** Whether line numbers change across the seams of a bake. */
  isOfForm: boolean;
}

/** The shadows at a fragment, as far as lines depend on them. */
export interface LinesInShadow {
  lights: readonly Light[];
  receivedShadows: readonly ReceivedShadow[];
  /** The shadows at whose edges strokes end; undefined where edges cut strokes. */
  castShadows: CastShadows | undefined;
  /** The share of the shadows' tone that is left where shadows alone are drawn; null elsewhere. */
  shadowLeft: Value | null;
}

/** The cosine and the sine of the angle at which a family crosses the first; of a negative one, which leans back, the sine is negative. */
export type Lean = readonly [cosine: Value, sine: Value];

/** The parameters of engraving at a fragment: the functions whose level sets are lines, and their derivatives on the screen. */
export interface HatchingParameters extends LinesInShadow {
  onScreen: ScreenMap;
  /** What builds the shader. */
  builder: NodeBuilder;
  /** Pressure of the hand. */
  pressure: Value;
  /** The share to which the first family has lines here. */
  firstShare: Value;
  /** The share of the crossing tone that family B takes. */
  shareB: Value;
  firstFamily(): Family;
  /**
   * A family that crosses the first.
   *
   * @param isB the side towards which it leans
   * @param lean cosine and sine of the angle at which it crosses the first
   */
  crossingFamily(isB: boolean, lean: Lean): Family;
}

/** Counterpart of shaders/techniques/lines/read.glsl, from here and at the end: the parameters of lines at this fragment. */

/**
 * The Jacobian of the map from pixels to positions on a surface, in the field; limited at grazing angles. It is turned by a right angle.
 *
 * @param normal of any length
 */
function surfaceOnScreen(builder: NodeBuilder, normal: Value): ScreenMap {
  const viewToAnchor = readViewToAnchor(builder);
  const right = objectToField.mul(viewToAnchor.mul(vec3(1, 0, 0))).toVar();
  const up = objectToField.mul(viewToAnchor.mul(vec3(0, 1, 0))).toVar();
  const centre = centreOfScreen();
  const ray = objectToField.mul(viewToAnchor.mul(vec3(centre, 1))).toVar();
  const along = vec2(dot(normal, right), dot(normal, up)).toVar();
  const facing = dot(normal, ray).toVar();
  const straight = facing.sub(dot(centre, along));
  const least = length(vec3(along, straight)).mul(SCREEN_CONSTANTS.LEAST_FACING);
  const scale = viewUnitsPerPixel()
    .div(max(max(abs(facing), least), 1e-20))
    .toVar();
  return [
    ray.mul(along.y).sub(up.mul(facing)).mul(scale).toVar(),
    right.mul(facing).sub(ray.mul(along.x)).mul(scale).toVar(),
  ];
}

const smoothOnScreen = (builder: NodeBuilder): ScreenMap => surfaceOnScreen(builder, vFieldNormal);

/** The flat triangle is mapped by its normal, since differences of positions are inexact where triangles are smaller than pixels. */
const triangleOnScreen = (builder: NodeBuilder): ScreenMap =>
  surfaceOnScreen(builder, cross(dFdx(vFieldPoint), dFdy(vFieldPoint)).toVar());

/** Counterpart of shaders/techniques/lines/fieldAtFragment.glsl: the field at this fragment. */

/**
 * The light of the field, from the lights that arrive; where none does, a direction across it. It is constant where the same lights arrive.
 */
function arrivingLight(
  builder: NodeBuilder,
  lights: readonly Light[],
  receivedShadows: readonly ReceivedShadow[],
): Value {
  const shadowed = receivedShadows.flatMap(({ isShadowed }) => isShadowed ?? []);
  if (shadowed.length === 0) return vFieldLight;
  const isDark = isInFullShadow(lights, receivedShadows);
  const light = vFieldLight.toVar();
  if (isDark) light.assign(select(isDark, vec4(across(vFieldLight.xyz), 0), vFieldLight));
  if (isDark && shadowed.length === 1) return light;
  const isAny = shadowed.reduce((any, one) => any.or(one));
  If(isDark ? isAny.and(isDark.not()) : isAny, () => {
    const viewToField = objectToField.mul(readViewToAnchor(builder)).toVar();
    light.assign(fieldLight(viewToField, positionView, lights, { receivedShadows, fromOrigin: vFieldPoint }));
  });
  return light;
}

const fieldAtFragment = (
  builder: NodeBuilder,
  choices: DirectionChoices,
  lights: readonly Light[],
  receivedShadows: readonly ReceivedShadow[],
): Value =>
  (isByVertex(choices) ? vField : firstField(arrivingLight(builder, lights, receivedShadows).toVar(), choices)).toVar();

/** Counterpart of shaders/techniques/lines/readCut.glsl: lines that are level sets of a field in space. */

export function readCutLines(
  builder: NodeBuilder,
  choices: DirectionChoices,
  shadows: LinesInShadow,
): HatchingParameters {
  const { lights, receivedShadows } = shadows;
  const field = fieldAtFragment(builder, choices, lights, receivedShadows);
  const place = vFieldPoint.toVar();
  const normal = normalize(vFieldNormal).toVar();
  const waves = slowWaves(place.mul(HAND_CONSTANTS.HAND_WAVES)).toVar();
  const point = handPoint(place, waves).toVar();
  const onScreen = smoothOnScreen(builder);
  const triangle = triangleOnScreen(builder);
  const { value, gradient } = fieldAt(field, point);
  const along = dot(normal, gradient).toVar();
  const slope = sqrt(max(along.mul(along).oneMinus(), 1e-12)).toVar();
  const firstShare = smoothstep(BARE_SLOPE[0], BARE_SLOPE[1], slope).toVar();
  const sideB = across(field.xyz).toVar();
  const sideC = cross(field.xyz, sideB).toVar();
  const b = dot(normal, sideC).toVar();
  const c = dot(normal, sideB).toVar();
  const between = b
    .mul(b)
    .sub(c.mul(c))
    .div(max(slope.mul(slope), 1e-4));
  const shareB = mix(1, smoothstep(-SIDE_FADE, SIDE_FADE, between), firstShare).toVar();
  const valueOnScreen = screenGradient(gradient, onScreen).toVar();
  return {
    onScreen,
    builder,
    ...shadows,
    pressure: handPressure(waves).toVar(),
    firstShare,
    shareB,
    firstFamily: () => ({
      value,
      perPixel: length(valueOnScreen),
      trianglePerPixel: length(screenGradient(gradient, triangle)),
      rise: min(slope.div(SPARSEST_SLOPE), 1),
      gradient,
      coarsest: FIELD_CONSTANTS.ANY_OCTAVE,
      isOfForm: false,
    }),
    crossingFamily(isB, [cosine, sine]) {
      const side = isB ? sideB : sideC;
      const leaning = gradient.mul(cosine).add(side.mul(sine)).toVar();
      return {
        value: cosine.mul(value).add(sine.mul(dot(point, side))),
        perPixel: length(valueOnScreen.mul(cosine).add(screenGradient(side, onScreen).mul(sine))),
        trianglePerPixel: length(screenGradient(leaning, triangle)),
        rise: float(1),
        gradient: leaning,
        coarsest: FIELD_CONSTANTS.ANY_OCTAVE,
        isOfForm: false,
      };
    },
  };
}

/** Counterpart of shaders/techniques/lines/readForm.glsl: lines that follow the form, level sets of two baked functions. */

const formValueAt = (form: Value, stray: Value): Value =>
  form.w.add(dot(form.xyz, vFieldPoint.mul(0.5).add(stray))).toVar();

/** @param isAcross whether the first family runs across the form */
export function readFormLines(
  builder: NodeBuilder,
  { isAcross, technique }: { isAcross: boolean; technique: HatchingTechnique },
  shadows: LinesInShadow,
): HatchingParameters {
  const { lights, receivedShadows } = shadows;
  const first = vForm.toVar();
  const crossing = vFormCrossing.toVar();
  const [along, across] = isAcross ? [...COARSEST_OCTAVES].reverse() : COARSEST_OCTAVES;
  const coarsest = vec2(along, across).toVar();
  const isDark = isInFullShadow(lights, receivedShadows);
  if (isDark) {
    // The families change places where no light arrives.
    If(isDark, () => {
      first.assign(vFormCrossing);
      crossing.assign(vForm);
      coarsest.assign(vec2(across, along));
    });
  }
  const waves = slowWaves(vFieldPoint.mul(HAND_CONSTANTS.HAND_WAVES)).toVar();
  const stray = handPoint(vec3(0), waves).toVar();
  // Strokes and cuts have variations of their own.
  const differs = technique === 'pen' || technique === 'woodcut';
  const ofHand = handPressure(waves);
  const pressure = differs ? ofHand : ofHand.add(irregularity.mul(WIDTH_WAVE).mul(waves.z));
  const values = [formValueAt(first, stray), formValueAt(crossing, stray)];
  const onScreen = smoothOnScreen(builder);
  const triangle = triangleOnScreen(builder);
  const valueOnScreen = screenGradient(first.xyz, onScreen).toVar();
  const crossingOnScreen = screenGradient(crossing.xyz, onScreen).toVar();
  return {
    onScreen,
    builder,
    ...shadows,
    pressure: pressure.toVar(),
    firstShare: float(1),
    shareB: float(1),
    firstFamily: () => ({
      value: values[0],
      perPixel: length(valueOnScreen),
      trianglePerPixel: length(screenGradient(first.xyz, triangle)),
      rise: length(first.xyz),
      gradient: first.xyz,
      coarsest: coarsest.x,
      isOfForm: true,
    }),
    // The other family crosses at the angle of the bake. The difference of the two functions is whole across seams too, and its lines lean
    // the other way.
    crossingFamily(_isB, [, sine]) {
      const isOther = sine.lessThan(0).toVar();
      const gradient = select(isOther, first.xyz.sub(crossing.xyz), crossing.xyz).toVar();
      return {
        value: select(isOther, values[0].sub(values[1]), values[1]).toVar(),
        perPixel: length(select(isOther, valueOnScreen.sub(crossingOnScreen), crossingOnScreen)),
        trianglePerPixel: length(screenGradient(gradient, triangle)),
        rise: length(crossing.xyz),
        gradient,
        coarsest: select(isOther, min(coarsest.x, coarsest.y), coarsest.y).toVar(),
        isOfForm: true,
      };
    },
  };
}

/**
 * The parameters of lines at this fragment.
 *
 * @param choices of the field that lines are level sets of
 */
export const read = (
  builder: NodeBuilder,
  choices: DirectionChoices,
  technique: HatchingTechnique,
  shadows: LinesInShadow,
): HatchingParameters =>
  followsForm(choices.direction)
    ? readFormLines(builder, { isAcross: choices.direction === 'acrossForm', technique }, shadows)
    : readCutLines(builder, choices, shadows);
