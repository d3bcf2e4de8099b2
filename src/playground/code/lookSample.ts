import { MathUtils, type Vector2 } from 'three';
import {
  type HatchingMaterialParameters,
  type HatchingPropertyName,
  type HatchingTechnique,
  type PresetName,
  presets,
} from 'three-hatching';
import {
  counts,
  defaultOf,
  HATCHING_OUTLINE_DEFAULTS,
  type HatchingLook,
  parametersOf,
  pixelPower,
} from 'three-hatching/facts';
import { SHADOWS, SUN_DISTANCE } from '../../viewer/sceneSetup/LightRig.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import { PRESET_NAMES } from '../../viewer/settings/presetLabels.js';
import { defaultSettings, type Settings } from '../../viewer/settings/settings.js';
import type { LightPlace } from '../../viewer/settings/settingValues.js';

type Values = Readonly<Record<string, unknown>>;

/** A length or an angle in code: with four decimals. */
export const round = (value: number): number => Math.round(value * 1e4) / 1e4;

/** Code that is there under a condition. */
export const when = (condition: unknown, code: string): string => (condition ? code : '');

/** A value as source code. */
function source(value: unknown): string {
  const plain = (value as Vector2 | null)?.isVector2 ? (value as Vector2).toArray() : value;
  if (plain && Object.getPrototypeOf(plain) === Object.prototype) return `{ ${entries(plain as Values).join(', ')} }`;
  const json =
    JSON.stringify(plain, (_, part) => (typeof part === 'number' ? Number(part.toPrecision(7)) : part)) ?? '';
  return json.replaceAll('"', "'").replaceAll(',', ', ');
}

/** Values as entries of an object literal. */
export const entries = (values: Values): string[] =>
  Object.entries(values).map(([name, value]) => `${name}: ${source(value)}`);

/** Properties as entries of the parameters of a material. @param preset whose material they change, if any */
function ownEntries(values: Values, preset: PresetName | false): string[] {
  const { composition, perTriangle, ...own } = parametersOf(values) as Values;
  const group = (name: string, owned: unknown, before: string): string[] =>
    owned ? [`${name}: { ${before}${entries(owned as Values).join(', ')} }`] : [];
  return [
    ...entries(own),
    ...group('composition', composition, when(preset, `...presets.${preset}.material.composition, `)),
    ...group('perTriangle', perTriangle, ''),
  ];
}

/** A value in a form in which equal ones are equal: `#000000` is 0. */
const comparable = (value: unknown): string => source(value).replace(/^'#(.*)'$/, (_, hex) => `${parseInt(hex, 16)}`);

/** The values that differ from others. */
const differing = (values: Values, base: Values): Values =>
  Object.fromEntries(Object.entries(values).filter(([name, value]) => comparable(value) !== comparable(base[name])));

/**
 * What settings say of a drawing as code draws it: in one technique, and never a debug view. A fitted exposure is kept, unless the lights
 * move with the viewer.
 */
export function codeLook(settings: Settings) {
  const look = lookOf({ ...settings, compare: 'none', debugView: 'none' });
  const { drawn, sizes, lights } = look;
  const { composition } = drawn;
  const isKept = composition?.exposure === 'auto' && !lights.isWithViewer;
  const kept: HatchingMaterialParameters = isKept ? { composition: { ...composition, exposure: 'fit' } } : {};
  return { ...look, material: { ...drawn, ...sizes, ...kept } };
}

/** Parameters of a material by the names of the properties, wherever they lie. */
const flat = ({ composition, perTriangle, ...own }: HatchingMaterialParameters): Values => ({
  ...own,
  ...composition,
  ...perTriangle,
});

/** The map that settings ask for. */
const mapOf = ({ mapStyle: style, mapSize, mapTones: tones, mapSeed: seed }: Settings): Values => ({
  style,
  size: Number(mapSize),
  tones,
  seed,
});

/** The preset from which a look differs least, and how it differs. @param isPlaced whether it is drawn in the page's own scene */
function nearestPreset(settings: Settings, isPlaced: boolean) {
  const { material, outlines, showsOutlines, needsMap } = codeLook(settings);
  const look: HatchingLook = material;
  // The model and its place in the scene are others elsewhere. Two settings have values by which nothing is set.
  const isOwn = (name: HatchingPropertyName) =>
    !(isPlaced ? /^color$|^tilesPerObjectUnit$/ : /^color$|^tilesPerObjectUnit$|^focus/).test(name) &&
    !(name === 'toneNormal' ? look[name] === 'auto' : name === 'occlusion' && look[name] === 0);
  const values = flat(material);
  const names = (Object.keys(values) as HatchingPropertyName[]).filter((name) => counts(look, name) && isOwn(name));
  const own = Object.fromEntries(names.map((name) => [name, values[name]]));
  // `scalePreset` scales sizes that are named.
  const unnamed = names.filter((name) => !isPlaced || pixelPower(look, name) === 0);
  const defaults = unnamed.map((name) => [name, defaultOf(name, look.technique as HatchingTechnique)]);
  const { weights, ...others } = outlines;
  const { paperGrain, paperGrainSize } = outlines;
  const ways = PRESET_NAMES.map((preset) => {
    const base = presets[preset];
    // Another technique would warn of what it does not use.
    const isBase = base.material.technique === look.technique;
    const lines = { ...HATCHING_OUTLINE_DEFAULTS, ...base.outlines, ...(paperGrain === 0 && { paperGrainSize }) };
    const ofLines = { ...HATCHING_OUTLINE_DEFAULTS.weights, ...base.outlines.weights };
    return {
      preset,
      isBase,
      material: differing(own, { ...Object.fromEntries(defaults), ...(isBase && flat(base.material)) }),
      outlines: showsOutlines ? differing(others, lines) : {},
      weights: showsOutlines ? differing(weights, ofLines) : {},
      map: needsMap ? differing(mapOf(settings), { ...mapOf(defaultSettings()), style: '', ...base.tonalArtMap }) : {},
    };
  });
  const size = ({ material, outlines, weights, map }: (typeof ways)[number]) =>
    [material, outlines, weights, map].flatMap((part) => Object.keys(part)).length;
  const nearest = ways.reduce((best, way) => (size(way) < size(best) ? way : best));
  // Weights of an object literal replace those of the preset.
  const named = differing(weights, HATCHING_OUTLINE_DEFAULTS.weights);
  const differs = Object.keys(nearest.weights).length > 0;
  return { ...nearest, outlines: { ...nearest.outlines, ...(differs && { weights: named }) } };
}

/** Code of a map. @param numbers of it that are not at their defaults */
function mapSource(style: Settings['mapStyle'], numbers: Values): string {
  if (style === 'file') return "await TonalArtMap.load('map.json'), // which the playground saves in a ZIP";
  const strokes = style === 'ownHand' ? "hand: await (await fetch('hand.json')).json()" : `style: '${style}'`;
  const note = when(style === 'ownHand', ' // the playground saves your own hand as hand.json');
  return `{ ${[strokes, ...entries(numbers)].join(', ')} },${note}`;
}

/**
 * Code that hatches an object as the page does: a preset, and what differs from it.
 *
 * @param root the variable of the object
 * @param share the variable that strokes shrink by in the page's own scene
 */
export function lookSample(settings: Settings, root: string, { radius = 1, share = '', isOpen = false }): string {
  const { preset, isBase, material, outlines, map } = nearestPreset(settings, share !== '');
  const { tilesPerObjectUnit = 1 } = codeLook(settings).material;
  const paper = { color: 'white', map: null, vertexColors: false };
  const colors = settings.surfaceColors === 'paper' ? paper : {};
  const own = [...ownEntries({ ...material, ...colors }, isBase && preset), ...(isOpen ? ['side: DoubleSide'] : [])];
  const block = (name: string, isNamed: boolean, values: readonly string[]): string => {
    const all = isNamed ? [`...presets.${preset}.${name}`, ...values] : values;
    return when(values.length, `\n  ${name}: {${all.map((entry) => `\n    ${entry},`).join('')}\n  },`);
  };
  const { style: _, ...numbers } = map;
  const tonalArtMap = when(entries(map).length, `\n  tonalArtMap: ${mapSource(settings.mapStyle, numbers)}`);
  const tint = `\nfor (const { color } of hatched.materials) color.multiply(new Color('${settings.color}'));`;
  return `const look = {
  ...presets.${preset},${block('material', isBase, own)}${block('outlines', true, entries(outlines))}${tonalArtMap}
};
const hatched = await applyHatching(${root}, {
  preset: ${share ? `scalePreset(look, ${share})` : 'look'},${when(settings.outlines === 'off', '\n  outlines: false,')}
  tilesPerWorldUnit: ${Number((tilesPerObjectUnit / radius).toPrecision(3))}, // tiles of strokes per unit of the world
});${when(settings.color !== '#ffffff', tint)}${when(settings.occlusion, `\nawait bakeOcclusion(${root});`)}`;
}

/** Code that lights an object of this radius in the middle of the scene. */
export function lightSample(settings: Settings, root: string, radius = 1): string {
  const { kind, place, intensity, spotAngle, spotPenumbra, second, castsShadows } = codeLook(settings).lights;
  const light = (name: string, made: string, { azimuth, elevation, distance = SUN_DISTANCE }: LightPlace) => {
    const angles = [90 - elevation, azimuth].map(MathUtils.degToRad);
    return `const ${name} = new ${made});
${name}.position.setFromSphericalCoords(${[distance * radius, ...angles].map(round).join(', ')});\n`;
  };
  const main = {
    directional: `DirectionalLight('white', ${round(intensity)}`,
    point: `PointLight('white', ${round(intensity)}, 0, 0`,
    spot: `SpotLight('white', ${round(intensity)}, 0, ${round(spotAngle)}, ${spotPenumbra}, 0`,
  }[kind];
  const { mapSize, softness } = SHADOWS;
  const [reach, near, far, normalBias] = [SHADOWS.reach, SHADOWS.near, SHADOWS.far, SHADOWS.normalBias].map(
    (length) => length * radius,
  );
  const casting = `
renderer.shadowMap.enabled = true;
for (const one of lights.children) {
  one.castShadow = true;
  const { shadow } = one;
  Object.assign(shadow, { ${entries({ normalBias, radius: softness }).join(', ')} });
  Object.assign(shadow.camera, { ${entries({ near, far, left: -reach, right: reach, bottom: -reach, top: reach }).join(', ')} });
  shadow.mapSize.setScalar(${mapSize});
}
${root}.traverse((object) => {
  if (object.isMesh) object.castShadow = object.receiveShadow = true;
});`;
  const more = second ? light('second', `DirectionalLight('white', ${round(second.intensity)}`, second.place) : '';
  return `${light('light', main, place)}${more}const lights = new Group().add(light${when(second, ', second')});
scene.add(lights);${when(castsShadows, casting)}`;
}
