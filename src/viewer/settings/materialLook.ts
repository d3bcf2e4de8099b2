import { MathUtils, Vector2 } from 'three';
import type { HatchingMaterialParameters, HatchingPropertyName, HatchingTechnique, Vector2Like } from 'three-hatching';
import { type PresetName, presets } from 'three-hatching';
import { counts, HATCHING_PROPERTIES, pixelPower } from 'three-hatching/facts';
import { compositionLook } from './compositionLook.js';
import { SETTING_KEYS, SETTINGS, type SettingKey, type Settings } from './settings.js';
import type { Setting } from './table/Setting.js';
import { unitOf } from './table/units.js';

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

/** A setting that is a property of the material, in another unit perhaps. */
interface Twin {
  key: SettingKey;
  property: HatchingPropertyName;
}

/** All of them, in the order of the panel. */
const TWINS: readonly Twin[] = SETTING_KEYS.flatMap((key) => {
  const { property }: Setting = SETTINGS[key];
  return property ? [{ key, property }] : [];
});

/** Whether a property is measured in pixels of the picture, where it is sized on the screen. */
const isSize = ({ property }: Twin): boolean => pixelPower({ sizedOnScreen: 1 }, property) > 0;

const SIZES = TWINS.filter(isSize);
const OTHERS = TWINS.filter((twin) => !isSize(twin));

function toProperty(property: HatchingPropertyName, value: string | number): unknown {
  if (typeof value === 'number') return unitOf(property).toProperty(value);
  return HATCHING_PROPERTIES[property].kind === 'switch' ? value === 'yes' : value;
}

function toSetting(property: HatchingPropertyName, value: unknown): unknown {
  if (typeof value === 'number') return unitOf(property).toSetting(value);
  return typeof value === 'boolean' ? (value ? 'yes' : 'no') : value;
}

const propertiesOf = (twins: readonly Twin[], settings: Settings): HatchingMaterialParameters =>
  Object.fromEntries(twins.map(({ key, property }) => [property, toProperty(property, settings[key])]));

/** The technique of the material, which has crisp strokes as a property of their own. */
export const techniqueOf = (technique: Settings['technique']): HatchingTechnique =>
  technique === 'adjacencyCrisp' ? 'adjacency' : technique;

/**
 * What the material takes, from the settings; all but its sizes in pixels.
 *
 * @param technique that of the settings or, for the other side of a comparison, another
 */
export function materialLook(
  settings: Settings,
  technique: Settings['technique'] = settings.technique,
): HatchingMaterialParameters {
  const { offsetU, offsetV } = settings;
  const isFitted = settings.exposure === 'auto';
  return {
    technique: techniqueOf(technique),
    crisp: technique === 'adjacencyCrisp',
    strokeRotation: rotationOf(settings, technique),
    strokeOffset: new Vector2(offsetU, offsetV),
    toneCurve: TONE_CURVES[settings.toneCurve],
    ...compositionLook(settings),
    exposure: isFitted ? 'auto' : 1,
    // The strength of the light alone would change nothing.
    exposureCompensation: isFitted ? settings.lightStrength / 100 : 1,
    ...propertiesOf(OTHERS, settings),
  };
}

const ROTATIONS = { along: 0, towards: Math.PI / 2 } as const;

function rotationOf({ strokeDirection, strokeAngle }: Settings, technique: Settings['technique']): number {
  const { yieldsTo }: Setting = SETTINGS.strokeDirection;
  if (yieldsTo && counts({ technique: techniqueOf(technique) }, yieldsTo)) return 0;
  return strokeDirection === 'angle' ? MathUtils.degToRad(strokeAngle) : ROTATIONS[strokeDirection];
}

/** The sizes that the material takes, from the settings: where they are measured in pixels, in those of the page. */
export const materialSizes = (settings: Settings): HatchingMaterialParameters => propertiesOf(SIZES, settings);

/** The settings that give a material these parameters. Others stay as they are. */
export function settingsOfMaterial(parameters: HatchingMaterialParameters): Partial<Settings> {
  const { technique, crisp, strokeRotation, strokeOffset, toneCurve, exposure } = parameters;
  const given = TWINS.filter(({ property }) => parameters[property] !== undefined);
  return {
    ...(technique && { technique: technique === 'adjacency' && crisp ? 'adjacencyCrisp' : technique }),
    ...(strokeRotation !== undefined && directionOf(strokeRotation)),
    ...(strokeOffset && offsetOf(strokeOffset)),
    ...(toneCurve && { toneCurve: nameOfCurve(toneCurve) }),
    ...(exposure && { exposure: exposure === 'auto' ? exposure : 'fixed' }),
    ...Object.fromEntries(given.map(({ key, property }) => [key, toSetting(property, parameters[property])])),
  };
}

function offsetOf(offset: Vector2Like): Partial<Settings> {
  const [offsetU, offsetV] = offset;
  return { offsetU, offsetV };
}

function directionOf(strokeRotation: number): Partial<Settings> {
  for (const [strokeDirection, rotation] of Object.entries(ROTATIONS)) {
    if (rotation === strokeRotation) return { strokeDirection: strokeDirection as keyof typeof ROTATIONS };
  }
  return { strokeDirection: 'angle', strokeAngle: unitOf('strokeRotation').toSetting(strokeRotation) };
}
