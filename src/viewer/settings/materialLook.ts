import { MathUtils, Vector2 } from 'three';
import {
  type HatchingBackgroundParameters,
  type HatchingCompositionOptions,
  type HatchingMaterialParameters,
  type HatchingOutlineParameters,
  type HatchingPropertyName,
  type HatchingShadowOptions,
  type HatchingTechnique,
  type PresetName,
  presets,
  type Vector2Like,
} from 'three-hatching';
import {
  counts,
  drawsLines,
  givenValue,
  HATCHING_OUTLINE_DEFAULTS,
  HATCHING_PROPERTIES,
  parametersOf,
  pixelPower,
} from 'three-hatching/facts';
import { SETTING_KEYS, SETTINGS, type SettingKey, type Settings } from './settings.js';
import { type Setting, UNITS, unitOf } from './table/rows.js';
import { outlineShadeOf, SHADE, STROKE_ANGLES, strokeTurnOf } from './table/strokeSettings.js';

const curveOf = (name: PresetName) => presets[name].material.toneCurve ?? 'linear';

/** The curves from light to printed tone, as the material takes them. */
const TONE_CURVES = {
  linear: 'linear',
  perceptual: 'perceptual',
  contrast: [
    [0, 0],
    [0.25, 0.1],
    [0.75, 0.9],
    [1, 1],
  ],
  printed: curveOf('engraving'),
  cut: curveOf('woodcut'),
  rubbed: curveOf('charcoal'),
  chalked: curveOf('chalk'),
} as const satisfies Record<Settings['toneCurve'], unknown>;

/** What the page calls a curve. */
function nameOfCurve(curve: NonNullable<HatchingMaterialParameters['toneCurve']>): Settings['toneCurve'] {
  for (const [name, known] of Object.entries(TONE_CURVES)) if (known === curve) return name as Settings['toneCurve'];
  throw new Error('nameOfCurve: the page has no name for this tone curve; give it one in TONE_CURVES.');
}

/** A setting that stands for one property of the material, possibly in another unit. */
interface PropertySetting {
  key: SettingKey;
  property: HatchingPropertyName;
}

/** All settings of this kind, in the order of the panel. */
const PROPERTY_SETTINGS: readonly PropertySetting[] = SETTING_KEYS.flatMap((key) => {
  const { property }: Setting = SETTINGS[key];
  return property ? [{ key, property }] : [];
});

/** Whether a property can be measured in screen pixels. */
const isSize = ({ property }: PropertySetting): boolean => pixelPower({ screenSpaceShare: 1 }, property) > 0;

const SIZES = PROPERTY_SETTINGS.filter(isSize);
const OTHERS = PROPERTY_SETTINGS.filter((setting) => !isSize(setting));

function toProperty(property: HatchingPropertyName, value: string | number): unknown {
  if (typeof value === 'number') return unitOf(property).toProperty(value);
  return HATCHING_PROPERTIES[property].kind === 'switch' ? value === 'yes' : value;
}

function toSetting(property: HatchingPropertyName, value: unknown): unknown {
  if (typeof value === 'number') return unitOf(property).toSetting(value);
  return typeof value === 'boolean' ? (value ? 'yes' : 'no') : value;
}

const propertiesOf = (chosen: readonly PropertySetting[], settings: Settings): Record<string, unknown> =>
  Object.fromEntries(chosen.map(({ key, property }) => [property, toProperty(property, settings[key])]));

/** The technique of the material. The settings' crisp strokes are a technique of their own; the material has a property for them. */
const techniqueOf = (technique: Settings['technique']): HatchingTechnique =>
  technique === 'adjacencyCrisp' ? 'adjacency' : technique;

/**
 * The material parameters for some settings, without sizes in pixels.
 *
 * @param technique of the settings, or the compared one
 */
export function materialLook(
  settings: Settings,
  technique: Settings['technique'] = settings.technique,
): HatchingMaterialParameters {
  const { offsetU, offsetV } = settings;
  const isFitted = settings.exposure === 'auto';
  return parametersOf({
    technique: techniqueOf(technique),
    sharpInk: technique === 'adjacencyCrisp',
    strokeAngle: angleOf(settings, technique),
    strokeOffset: new Vector2(offsetU, offsetV),
    toneCurve: TONE_CURVES[settings.toneCurve],
    ...compositionLook(settings),
    exposure: isFitted ? 'auto' : 1,
    // Fitting would otherwise cancel the light's strength.
    exposureCompensation: isFitted ? settings.lightStrength / 100 : 1,
    ...propertiesOf(OTHERS, settings),
  });
}

function angleOf({ strokeTurn, strokeAngle }: Settings, technique: Settings['technique']): number {
  // The directions of lines have names.
  if (drawsLines(techniqueOf(technique))) return 0;
  return strokeTurn === 'angle' ? MathUtils.degToRad(strokeAngle) : STROKE_ANGLES[strokeTurn];
}

/** The sizes of the material for some settings; pixels are CSS pixels. */
export const materialSizes = (settings: Settings): HatchingMaterialParameters =>
  parametersOf(propertiesOf(SIZES, settings));

/** The settings that correspond to material parameters. Absent parameters give no setting. */
export function settingsOfMaterial(parameters: HatchingMaterialParameters): Partial<Settings> {
  const { technique, strokeAngle, toneCurve, composition = {}, perTriangle = {} } = parameters;
  const { exposure } = composition;
  const { sharpInk, strokeOffset } = perTriangle;
  const given = PROPERTY_SETTINGS.filter(({ property }) => givenValue(parameters, property) !== undefined);
  return {
    ...(technique && { technique: technique === 'adjacency' && sharpInk ? 'adjacencyCrisp' : technique }),
    ...(strokeAngle !== undefined && turnOf(strokeAngle)),
    ...(strokeOffset && offsetOf(strokeOffset)),
    ...(toneCurve && { toneCurve: nameOfCurve(toneCurve) }),
    ...(exposure && { exposure: typeof exposure === 'string' ? 'auto' : 'fixed' }),
    ...Object.fromEntries(
      given.map(({ key, property }) => [key, toSetting(property, givenValue(parameters, property))]),
    ),
  };
}

function offsetOf(offset: Vector2Like): Partial<Settings> {
  const [offsetU, offsetV] = offset;
  return { offsetU, offsetV };
}

function turnOf(strokeAngle: number): Partial<Settings> {
  const strokeTurn = strokeTurnOf(strokeAngle);
  if (strokeTurn !== 'angle') return { strokeTurn };
  return { strokeTurn, strokeAngle: unitOf('strokeAngle').toSetting(strokeAngle) };
}

/** The properties of the composition that are none of the settings' own name. */
const compositionLook = ({ depth, depthStrength, focus, focusX, focusY, focusZ }: Settings) =>
  ({
    depthFade: depth === 'auto' ? 'auto' : depth === 'on' ? depthStrength / 100 : 0,
    focus: focus === 'on' ? [focusX, focusY, focusZ] : null,
  }) satisfies Partial<HatchingCompositionOptions>;

/** The parameters of the background, with spacing in CSS pixels; undefined if there is no background. */
export function backgroundLook(
  settings: Settings,
): Omit<Required<HatchingBackgroundParameters>, 'contrast'> | undefined {
  if (settings.background === 'none') return undefined;
  return {
    tone: settings.backgroundTone / 100,
    spacing: settings.backgroundSpacing,
    direction: MathUtils.degToRad(settings.backgroundDirection),
    extent: settings.backgroundExtent / 100,
    ink: settings.ink,
  };
}

/**
 * The shadow properties whose settings have the same name, in percent. On the page they belong to the ground's material and not to the
 * model's, so they are not material settings.
 */
export const SHADOW_NUMBERS = ['shadowTone', 'shadowFade', 'shadowSoftness'] as const;

type ShadowNumbers = Record<(typeof SHADOW_NUMBERS)[number], number>;

/** The properties of a ground that shows shadows alone. Reflected light would outshine a low light on it, and its shadow would vanish. */
export const groundShadowLook = (settings: Settings): ShadowNumbers & { reflectedLight: 0 } => ({
  ...(Object.fromEntries(
    SHADOW_NUMBERS.map((name) => [name, UNITS.share.toProperty(settings[name])]),
  ) as ShadowNumbers),
  reflectedLight: 0,
});

/** The settings that correspond to parameters of the ground's material. Absent parameters give no setting. */
export const settingsOfShadow = (parameters: Partial<HatchingShadowOptions> = {}): Partial<Settings> =>
  Object.fromEntries(
    SHADOW_NUMBERS.flatMap((name) => {
      const value = parameters[name];
      return value === undefined ? [] : [[name, UNITS.share.toSetting(value)]];
    }),
  );

/**
 * Outlines overshoot corners once the wobble exceeds this many pixels, by one pixel for each pixel beyond. Below it they do not, because
 * creases of scans have corners everywhere, and overshoots would look like thorns.
 */
const LIGHT_HAND = 1;
const OVERSHOOT = 3;
/** The outline parameters for some settings. */
export type OutlineLook = ReturnType<typeof outlineLook>;

/** Derives the parameters of the outline material. Sizes are in CSS pixels. */
export function outlineLook(settings: Settings) {
  const shade = settings.outlineShade / 100;
  const creases = settings.outlineCreases / 100;
  return {
    outlineWidth: settings.outlineWidth,
    weights: {
      contours: settings.outlineContours / 100,
      innerContours: settings.outlineInner / 100,
      borders: settings.outlineBorders / 100,
      creases,
      materialBorders: creases,
      intersections: creases,
      suggestiveContours: settings.outlineSuggestive / 100,
      lit: 1 - SHADE.lost * shade,
      shade: 1 + SHADE.gained * shade,
    },
    lostEdges: settings.outlineLost / 100,
    accents: settings.outlineAccents / 100,
    hidden: settings.outlineHidden,
    intersections: settings.outlineMeetings === 'on',
    wobble: settings.outlineHand,
    overshoot: OVERSHOOT * Math.max(0, settings.outlineHand - LIGHT_HAND),
    // Outlines are drawn with what strokes are drawn with.
    paperGrain: counts({ technique: techniqueOf(settings.technique) }, 'paperGrain') ? settings.paperGrain / 100 : 0,
    paperGrainSize: settings.paperGrainSize,
    ink: settings.ink,
  };
}

/** The settings that correspond to outline parameters. Ink is the material's, and creases weigh as much as borders of materials. */
export function settingsOfOutlines(parameters: HatchingOutlineParameters): Partial<Settings> {
  const all = { ...HATCHING_OUTLINE_DEFAULTS, ...parameters };
  const weights = { ...HATCHING_OUTLINE_DEFAULTS.weights, ...parameters.weights };
  const percent = (weight: number): number => Math.round(100 * weight);
  return {
    outlines: 'on',
    outlineWidth: all.outlineWidth,
    outlineContours: percent(weights.contours),
    outlineInner: percent(weights.innerContours),
    outlineBorders: percent(weights.borders),
    outlineCreases: percent(weights.creases),
    outlineSuggestive: percent(weights.suggestiveContours),
    outlineLost: percent(all.lostEdges),
    outlineAccents: percent(all.accents),
    outlineHidden: all.hidden,
    outlineShade: outlineShadeOf(weights.lit),
    outlineHand: all.wobble,
  };
}
