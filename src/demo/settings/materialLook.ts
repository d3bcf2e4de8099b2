import { MathUtils, Vector2 } from 'three';
import { HATCHING_DEFAULTS, type HatchingMaterialParameters, scaledSizes } from 'three-hatching';
import type { Settings } from './settings.js';
import { TONE_CURVES, techniqueOf } from './settingValues.js';

/** A property of the material that one setting stands for, in another unit perhaps. */
interface Twin<Key extends keyof Settings> {
  property: keyof HatchingMaterialParameters;
  toProperty(setting: Settings[Key]): unknown;
  toSetting(property: never): unknown;
}

type NumberKey = { [Key in keyof Settings]: Settings[Key] extends number ? Key : never }[keyof Settings];

const same = (property: keyof HatchingMaterialParameters): Twin<never> => ({
  property,
  toProperty: (setting) => setting,
  toSetting: (value) => value,
});

const percent = (property: keyof HatchingMaterialParameters): Twin<NumberKey> => ({
  property,
  toProperty: (setting) => setting / 100,
  toSetting: (value) => rounded(100 * value),
});

const degrees = (property: keyof HatchingMaterialParameters): Twin<NumberKey> => ({
  property,
  toProperty: MathUtils.degToRad,
  toSetting: (value) => rounded(MathUtils.radToDeg(value)),
});

/** So that 0.55 is 55 %, and not 55.00000000000001. */
const rounded = (value: number): number => Number(value.toFixed(6));

/** Settings that are one property of the material each. */
const TWINS = {
  screenConstancy: percent('screenConstancy'),
  strokeScale: same('strokeScale'),
  anchorSpacing: same('anchorSpacing'),
  lineField: same('lineField'),
  strokeLayers: same('strokeLayers'),
  crossFrom: percent('crossFrom'),
  crossAngle: degrees('crossAngle'),
  handmade: percent('handmade'),
  carved: {
    property: 'carved',
    toProperty: (setting: Settings['carved']) => setting === 'yes',
    toSetting: (value: boolean) => (value ? 'yes' : 'no'),
  },
  edge: same('edgePixels'),
  medium: same('medium'),
  tooth: percent('tooth'),
  softness: percent('softness'),
  smudge: percent('smudge'),
  levelRule: same('levelRule'),
  occlusion: percent('occlusion'),
  shadowStrokes: same('shadowStrokes'),
  toneModel: same('toneModel'),
  toneNormal: same('toneNormal'),
  toneSteps: same('toneSteps'),
  shininess: same('shininess'),
  reflectedLight: percent('reflectedLight'),
  keepHighlight: percent('keepHighlight'),
  creaseAngle: degrees('creaseAngle'),
  ink: same('ink'),
  inkBlend: same('inkBlend'),
  paper: same('paper'),
  color: same('color'),
  debugView: same('debugView'),
} as const satisfies Partial<{ [Key in keyof Settings]: Twin<Key> }>;

/** Those among them that are measured in pixels of the picture. */
const SIZES = {
  strokeWidth: same('strokeWidth'),
  lineSpacing: same('lineSpacing'),
  toothSize: same('toothSize'),
} as const;

const entriesOf = Object.entries as <Of extends object>(of: Of) => [keyof Of & keyof Settings, Twin<never>][];

const ROTATIONS = { along: 0, towards: Math.PI / 2 } as const;

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
  return {
    technique: techniqueOf(technique),
    crisp: technique === 'adjacencyCrisp',
    strokeRotation: rotationOf(settings, technique),
    strokeOffset: new Vector2(offsetU, offsetV),
    toneCurve: TONE_CURVES[settings.toneCurve],
    ...Object.fromEntries(
      entriesOf(TWINS).map(([key, { property, toProperty }]) => [property, toProperty(settings[key] as never)]),
    ),
  };
}

function rotationOf({ strokeDirection, strokeAngle }: Settings, technique: Settings['technique']): number {
  // The page asks what cuts the lines instead.
  if (technique === 'engraved') return 0;
  return strokeDirection === 'angle' ? MathUtils.degToRad(strokeAngle) : ROTATIONS[strokeDirection];
}

/**
 * The sizes that the material takes: those that are measured in pixels of the picture go with it.
 *
 * @param pixelRatio pixels of the picture per CSS pixel
 * @param share of the resolution that the picture is shown in, where it is drawn in a lower one for a moment
 */
export function materialSizes(
  { screenConstancy, strokeWidth, lineSpacing, toothSize }: Settings,
  pixelRatio: number,
  share = 1,
) {
  const sizes = { strokeWidth, lineSpacing, toothSize };
  const { finestSpacing } = HATCHING_DEFAULTS;
  return {
    ...sizes,
    ...scaledSizes({ ...sizes, screenConstancy: screenConstancy / 100 }, pixelRatio),
    ...scaledSizes({ finestSpacing }, share),
  };
}

/** The settings that give a material these parameters. Others stay as they are. */
export function settingsOfMaterial(parameters: HatchingMaterialParameters): Partial<Settings> {
  const { technique, crisp, strokeRotation, strokeOffset, toneCurve } = parameters;
  const given = entriesOf({ ...TWINS, ...SIZES }).filter(([, { property }]) => parameters[property] !== undefined);
  return {
    ...(technique && { technique: technique === 'adjacency' && crisp ? 'adjacencyCrisp' : technique }),
    ...(strokeRotation !== undefined && directionOf(strokeRotation)),
    ...(strokeOffset && { offsetU: strokeOffset.x, offsetV: strokeOffset.y }),
    ...(toneCurve && { toneCurve: nameOf(toneCurve) }),
    ...Object.fromEntries(
      given.map(([key, { property, toSetting }]) => [key, toSetting(parameters[property] as never)]),
    ),
  };
}

function directionOf(strokeRotation: number): Partial<Settings> {
  for (const [strokeDirection, rotation] of Object.entries(ROTATIONS)) {
    if (rotation === strokeRotation) return { strokeDirection: strokeDirection as keyof typeof ROTATIONS };
  }
  return { strokeDirection: 'angle', strokeAngle: rounded(MathUtils.radToDeg(strokeRotation)) };
}

function nameOf(curve: NonNullable<HatchingMaterialParameters['toneCurve']>): Settings['toneCurve'] {
  for (const [name, known] of Object.entries(TONE_CURVES)) if (known === curve) return name as Settings['toneCurve'];
  throw new Error('materialLook: the page has no name for this tone curve; give it one in TONE_CURVES.');
}
