import { HATCHING_LINE_DEFAULTS, needsMap, pixelPower } from 'three-hatching';
import { lineLook } from '../settings/lineLook.js';
import { SETTINGS, type Settings } from '../settings/settings.js';
import { isCrisp, looksOf, TONE_CURVES, techniqueOf } from '../settings/settingValues.js';
import { round } from './round.js';

/** What makes the map of the page: from the files that it saves, or drawn. */
export function mapSource(settings: Settings): string {
  if (settings.mapStyle === 'file') return "await TonalArtMap.load('map.json')";
  const map = [`style: '${settings.mapStyle}'`];
  if (settings.mapSize !== SETTINGS.mapSize.default) map.push(`size: ${settings.mapSize}`);
  if (settings.mapTones !== SETTINGS.mapTones.default) map.push(`tones: ${settings.mapTones}`);
  map.push(`seed: ${settings.mapSeed}`);
  return `await TonalArtMap.generate({ ${map.join(', ')} })`;
}

/**
 * The parameters of the material that count, as entries of an object; its map is the variable `tonalArtMap`.
 *
 * @param isScene whether it is for the materials of a loaded scene, which keep their colours and get their scale elsewhere
 */
export function materialParameters(settings: Settings, isScene: boolean): string[] {
  const rotation = { along: '0', towards: 'Math.PI / 2', angle: `(${settings.strokeAngle} / 180) * Math.PI` };
  const { technique } = settings;
  const material = [...(drawnWithMap(settings) ? ['tonalArtMap'] : []), `technique: '${techniqueOf(technique)}'`];
  if (technique === 'adjacencyCrisp') material.push('crisp: true');
  if (technique === 'anchored') {
    material.push(`screenConstancy: ${settings.screenConstancy / 100}`, `anchorSpacing: ${settings.anchorSpacing}`);
    if (settings.medium === 'stipple') material.push(`medium: 'stipple'`);
    if (settings.medium === 'dry') {
      material.push(
        `medium: 'dry'`,
        `tooth: ${settings.tooth / 100}`,
        sizeSource(settings, 'toothSize'),
        `softness: ${settings.softness / 100}`,
        `smudge: ${settings.smudge / 100}`,
      );
    }
  }
  const crossing = [`crossFrom: ${settings.crossFrom / 100}`];
  if (settings.crossAngle !== SETTINGS.crossAngle.default) {
    crossing.push(`crossAngle: (${settings.crossAngle} / 180) * Math.PI`);
  }
  if (technique === 'engraved') {
    material.push(
      `screenConstancy: ${settings.screenConstancy / 100}`,
      `lineField: '${settings.lineField}'`,
      sizeSource(settings, 'lineSpacing'),
      ...crossing,
      `handmade: ${settings.handmade / 100}`,
    );
    if (settings.carved === 'yes') material.push('carved: true');
  } else if (isCrisp(technique) || settings.levelRule === 'depth') {
    material.push(sizeSource(settings, 'strokeWidth'));
  }
  if (isCrisp(technique)) material.push(`edgePixels: ${settings.edge}`);
  if (settings.toneNormal !== 'auto') material.push(`toneNormal: '${settings.toneNormal}'`);
  if (!isScene) {
    material.push(
      `strokeScale: ${round(settings.strokeScale)}, // tiles per unit; this page scales models to a radius of 1`,
    );
  }
  if (technique !== 'engraved') {
    material.push(`strokeRotation: ${rotation[settings.strokeDirection]}`);
    if (settings.strokeLayers === 'tone') material.push(`strokeLayers: 'tone'`, ...crossing);
    // With one light there is nothing to disagree about.
    else if (settings.strokeLayers === 'lights' && settings.secondLight !== 'none')
      material.push(`strokeLayers: 'lights'`);
  }
  material.push(`toneModel: '${settings.toneModel}'`);
  const { offsetU, offsetV, creaseAngle } = settings;
  if (offsetU !== 0 || offsetV !== 0) material.push(`strokeOffset: new Vector2(${offsetU}, ${offsetV})`);
  if (creaseAngle !== SETTINGS.creaseAngle.default) material.push(`creaseAngle: (${creaseAngle} / 180) * Math.PI`);
  if (settings.toneModel === 'toon') material.push(`toneSteps: ${settings.toneSteps}`);
  if (settings.toneModel === 'phong') material.push(`shininess: ${settings.shininess}`);
  if (settings.toneCurve !== 'linear') material.push(`toneCurve: ${inSource(TONE_CURVES[settings.toneCurve])}`);
  if (settings.reflectedLight > 0) material.push(`reflectedLight: ${settings.reflectedLight / 100}`);
  if (settings.keepHighlight > 0) material.push(`keepHighlight: ${settings.keepHighlight / 100}`);
  if (settings.levelRule !== SETTINGS.levelRule.default) material.push(`levelRule: '${settings.levelRule}'`);
  if (settings.inkBlend !== SETTINGS.inkBlend.default) material.push(`inkBlend: '${settings.inkBlend}'`);
  material.push(`ink: '${settings.ink}'`, `paper: '${settings.paper}'`);
  if (!isScene) material.push(`color: '${settings.color}'`);
  else if (settings.surfaceColors === 'paper') material.push(`color: 'white'`, 'map: null', 'vertexColors: false');
  return material;
}

/** Whether the technique of the page, compared with none, is drawn with a map. */
export const drawnWithMap = (settings: Settings): boolean => looksOf(settings, settings.technique).some(needsMap);

/** A size as an entry of an object: it grows with the pixels of the canvas, as far as it is measured in them. */
function sizeSource(settings: Settings, name: 'strokeWidth' | 'lineSpacing' | 'toothSize'): string {
  const power = pixelPower({ screenConstancy: settings.screenConstancy / 100 }, name);
  const size = `${name}: ${round(settings[name])}`;
  if (power === 0) return size;
  return `${size} * renderer.getPixelRatio()${power === 1 ? '' : ` ** ${power}`}`;
}

/** The parameters of lines that are not at their defaults, and those in pixels. */
export function lineParameters(settings: Settings): string[] {
  const { lineWidth, wobble, overshoot, toothSize, ink, shadeWeights, ...weights } = lineLook(settings, 1);
  const inPixels = { lineWidth, wobble, overshoot, ...(weights.tooth > 0 && { toothSize }) };
  return [
    ...Object.entries(inPixels)
      .filter(([, value]) => value > 0)
      .map(([name, value]) => `${name}: ${round(value)} * renderer.getPixelRatio()`),
    ...Object.entries(weights)
      .filter(([name, value]) => value !== HATCHING_LINE_DEFAULTS[name as keyof typeof weights])
      .map(([name, value]) => `${name}: ${round(value)}`),
    `shadeWeights: [${shadeWeights.map(round).join(', ')}]`,
    `ink: '${ink}'`,
  ];
}

/** A value as source code. */
function inSource(value: unknown): string {
  return JSON.stringify(value).replaceAll('"', "'").replaceAll(',', ', ');
}
