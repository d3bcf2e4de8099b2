import { counts, HATCHING_LINE_DEFAULTS, type HatchingLineParameters } from 'three-hatching';
import { techniqueOf } from './materialLook.js';
import type { Settings } from './settings.js';

/**
 * A hand that strays by more than this many pixels also runs on past corners, by so many pixels more for each. A lighter one
 * does not, because creases of scans have corners everywhere, and lines would stand out from them like thorns.
 */
const LIGHT_HAND = 1;
const OVERSHOOT = 3;
/** Weight that lines lose in full light and gain in full shade, if the shade weight is 100 %. */
const LOST_IN_LIGHT = 1;
const GAINED_IN_SHADE = 0.8;

/** The parameters of lines that settings stand for. */
export type LineLook = ReturnType<typeof lineLook>;

/** What the material of lines takes, from the settings. Its sizes are in pixels of the page. */
export function lineLook(settings: Settings) {
  const shade = settings.lineShade / 100;
  const creases = settings.lineCreases / 100;
  return {
    lineWidth: settings.lineWidth,
    contours: settings.lineContours / 100,
    borders: settings.lineBorders / 100,
    creases,
    materialBorders: creases,
    suggestiveContours: settings.lineSuggestive / 100,
    shadeWeights: [1 - LOST_IN_LIGHT * shade, 1 + GAINED_IN_SHADE * shade] as const,
    wobble: settings.lineHand,
    overshoot: OVERSHOOT * Math.max(0, settings.lineHand - LIGHT_HAND),
    // Lines are drawn with what strokes are drawn with.
    tooth: counts({ technique: techniqueOf(settings.technique), medium: settings.medium }, 'tooth')
      ? settings.tooth / 100
      : 0,
    toothSize: settings.toothSize,
    ink: settings.ink,
  };
}

/** The settings that give lines these parameters. Their ink is that of the material, and creases weigh as much as borders of materials. */
export function settingsOfLines(parameters: HatchingLineParameters): Partial<Settings> {
  const all = { ...HATCHING_LINE_DEFAULTS, ...parameters };
  const percent = (weight: number): number => Math.round(100 * weight);
  const [inLight] = all.shadeWeights as readonly number[];
  return {
    lines: 'on',
    lineWidth: all.lineWidth,
    lineContours: percent(all.contours),
    lineBorders: percent(all.borders),
    lineCreases: percent(all.creases),
    lineSuggestive: percent(all.suggestiveContours),
    lineShade: percent((1 - inLight) / LOST_IN_LIGHT),
    lineHand: all.wobble,
  };
}
