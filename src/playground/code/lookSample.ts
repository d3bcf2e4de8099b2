import { Color, type ColorRepresentation } from 'three';
import type { HatchingMaterialParameters, HatchingPropertyName, HatchingTechnique } from 'three-hatching';
import {
  counts,
  defaultOf,
  followsForm,
  formOf,
  HATCHING_DEFAULTS,
  HATCHING_OUTLINE_DEFAULTS,
  HATCHING_PROPERTIES,
  needsAdjacency,
  needsMap,
  pixelPower,
} from 'three-hatching/facts';
import { compositionLook } from '../../viewer/settings/compositionLook.js';
import { countsFor } from '../../viewer/settings/effects.js';
import { isSize, materialLook, TWINS, type Twin } from '../../viewer/settings/materialLook.js';
import { outlineLook } from '../../viewer/settings/outlineLook.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import type { Setting } from '../../viewer/settings/table/Setting.js';
import { unitOf } from '../../viewer/settings/table/units.js';
import { TONE_CURVES } from '../../viewer/settings/toneCurves.js';
import { round } from './round.js';

/** Code that makes the map of the page: it loads the files that the page saves, or draws the map. */
export function mapSource(settings: Settings): string {
  if (settings.mapStyle === 'file') return "await TonalArtMap.load('map.json')";
  const isOwnHand = settings.mapStyle === 'ownHand';
  const map = [isOwnHand ? "hand: await (await fetch('hand.json')).json()" : `style: '${settings.mapStyle}'`];
  if (settings.mapSize !== SETTINGS.mapSize.default) map.push(`size: ${settings.mapSize}`);
  if (settings.mapTones !== SETTINGS.mapTones.default) map.push(`tones: ${settings.mapTones}`);
  map.push(`seed: ${settings.mapSeed}`);
  return `await TonalArtMap.generate({ ${map.join(', ')} })`;
}

/**
 * The parameters of the material that have an effect and are not at their defaults, as entries of an object; its map is the variable
 * `tonalArtMap`.
 *
 * @param isScene whether it is for the materials of a loaded scene, which keep their colours and get their scale elsewhere
 * @param factor the variable that multiplies sizes on the screen, if there is one
 */
export function materialParameters(settings: Settings, isScene: boolean, factor?: string): string[] {
  const look = materialLook(settings);
  const parameters = needsMap(look) ? ['tonalArtMap'] : [];
  if (look.technique !== HATCHING_DEFAULTS.technique) parameters.push(`technique: '${look.technique}'`);
  if (look.crisp) parameters.push('crisp: true');
  const rotation = { along: '0', towards: 'Math.PI / 2', angle: inRadians(settings.strokeAngle) };
  if (countsFor(look, 'strokeDirection')) parameters.push(`strokeRotation: ${rotation[settings.strokeDirection]}`);
  if (shiftsStrokes(settings)) parameters.push(`strokeOffset: new Vector2(${settings.offsetU}, ${settings.offsetV})`);
  if (!isDefault(look, 'toneCurve')) parameters.push(`toneCurve: ${inSource(TONE_CURVES[settings.toneCurve])}`);
  for (const property of ['exposure', 'exposureCompensation'] as const) {
    if (counts(look, property) && !isDefault(look, property))
      parameters.push(`${property}: ${inSource(look[property])}`);
  }
  for (const twin of TWINS) {
    const { key, property } = twin;
    const { owner }: Setting = SETTINGS[key];
    if (OF_THE_MODEL.includes(property) || owner !== 'hand' || !counts(look, property)) continue;
    // With one light, strokes for each light are one layer.
    if (property === 'strokeLayers' && settings.strokeLayers === 'lights' && settings.secondLight === 'none') {
      if (!isDefault({ ...look, strokeLayers: 'single' }, property)) parameters.push("strokeLayers: 'single'");
      continue;
    }
    if (isSize(twin)) parameters.push(sizeSource(settings, twin, factor));
    else if (!isDefault(look, property)) parameters.push(`${property}: ${valueSource(settings, twin)}`);
  }
  if (!isScene) {
    parameters.push(
      `color: '${settings.color}'`,
      `tilesPerUnit: ${round(settings.tilesPerUnit)}, // tiles per unit; this page scales models to a radius of 1`,
    );
  } else if (settings.surfaceColors === 'paper') parameters.push(`color: 'white'`, 'map: null', 'vertexColors: false');
  return parameters;
}

/**
 * The parameters of composition that are not at their defaults, which presets leave alone.
 *
 * @param isPlaced whether the scene of the code lies where that of the page does, so that a focus is where it is there
 */
export function compositionParameters(settings: Settings, isPlaced = false): string[] {
  const look = materialLook(settings);
  const twins = TWINS.filter(({ key }) => SETTINGS[key].group === 'Composition');
  const own = Object.entries(compositionLook(settings)) as [HatchingPropertyName, unknown][];
  const entries = [
    ...own.map(([name, value]) => [name, inSource(value)] as const),
    ...twins.map((twin) => [twin.property, valueSource(settings, twin)] as const),
  ];
  return entries
    .filter(([name]) => counts(look, name) && !isDefault(look, name) && (isPlaced || !name.startsWith('focus')))
    .map(([name, source]) => `${name}: ${source}`);
}

/** Whether the technique of a look has the value of a property by itself. Colours are compared as colours. */
function isDefault(look: HatchingMaterialParameters, property: HatchingPropertyName): boolean {
  const fallback = defaultOf(property, look.technique as HatchingTechnique);
  const value = look[property];
  const isColor = HATCHING_PROPERTIES[property].kind === 'color';
  return isColor
    ? new Color(value as ColorRepresentation).getHex() === fallback
    : value === fallback || (property === 'toneNormal' && value === 'auto');
}

/** Properties that materials of a loaded scene take from the scene. */
const OF_THE_MODEL: readonly HatchingPropertyName[] = ['tilesPerUnit', 'color'];

/** Whether the parameters name a vector. */
export const shiftsStrokes = (settings: Settings): boolean =>
  countsFor(materialLook(settings), 'offsetU') && (settings.offsetU !== 0 || settings.offsetV !== 0);

/** The options of `prepareHatchingGeometry` for the look, as a second argument with its comma; none if it needs none. */
export function prepareArgument(settings: Settings, outlines = false): string {
  const options = [
    ...(needsAdjacency(materialLook(settings)) ? ['adjacency: true'] : []),
    ...(outlines ? ['outlines: true'] : []),
    ...formOption(settings),
  ];
  return options.length > 0 ? `, { ${options.join(', ')} }` : '';
}

function formOption(settings: Settings): string[] {
  const look = materialLook(settings);
  if (!followsForm(look)) return [];
  // Strokes cross by turning, lines as they were baked.
  if (!counts(look, 'lineField')) return ['form: true'];
  const auto = formOf(look) === 'auto' ? 'auto: true, ' : '';
  return [`form: { ${auto}crossAngle: ${inRadians(settings.crossAngle)} }`];
}

/** Whether the technique of the page, compared with none, is drawn with a map. */
export const drawnWithMap = (settings: Settings): boolean => needsMap(materialLook(settings));

function valueSource(settings: Settings, { key, property }: Twin): string {
  const value = settings[key];
  if (typeof value === 'string') return inSource(materialLook(settings)[property]);
  return { '%': `${value / 100}`, '°': inRadians(value) }[unitOf(property).name] ?? `${round(value)}`;
}

const inRadians = (degrees: number): string => `(${degrees} / 180) * Math.PI`;

/** A size as an entry of an object. As far as it is measured in pixels, it is multiplied by the factor. */
function sizeSource(settings: Settings, { key, property }: Twin, factor: string | undefined): string {
  const power = pixelPower(materialLook(settings), property);
  const size = `${property}: ${round(settings[key] as number)}`;
  if (factor === undefined || power === 0) return size;
  return `${size} * ${factor}${power === 1 ? '' : ` ** ${power}`}`;
}

/** The parameters of outlines that are not at their defaults, and all that are measured in pixels. @param factor as above */
export function outlineParameters(settings: Settings, factor?: string): string[] {
  const { outlineWidth, wobble, overshoot, toothSize, ink, shadeWeights, hidden, ...weights } = outlineLook(settings);
  const inPixels = { outlineWidth, wobble, overshoot, ...(weights.tooth > 0 && { toothSize }) };
  return [
    ...Object.entries(inPixels)
      .filter(([, value]) => value > 0)
      .map(([name, value]) => `${name}: ${round(value)}${factor ? ` * ${factor}` : ''}`),
    ...Object.entries(weights)
      .filter(([name, value]) => value !== HATCHING_OUTLINE_DEFAULTS[name as keyof typeof weights])
      .map(([name, value]) => `${name}: ${round(value)}`),
    ...(hidden === HATCHING_OUTLINE_DEFAULTS.hidden ? [] : [`hidden: '${hidden}'`]),
    `shadeWeights: [${shadeWeights.map(round).join(', ')}]`,
    `ink: '${ink}'`,
  ];
}

/** A value as source code. */
function inSource(value: unknown): string {
  return JSON.stringify(value).replaceAll('"', "'").replaceAll(',', ', ');
}
