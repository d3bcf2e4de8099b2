import type { HatchingOutlineParameters } from 'three-hatching';
import { counts, HATCHING_OUTLINE_DEFAULTS } from 'three-hatching/facts';
import { techniqueOf } from './materialLook.js';
import type { Settings } from './settings.js';
import { outlineShadeOf, SHADE } from './table/strokeSettings.js';

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
    contours: settings.outlineContours / 100,
    innerContours: settings.outlineInner / 100,
    borders: settings.outlineBorders / 100,
    creases,
    materialBorders: creases,
    suggestiveContours: settings.outlineSuggestive / 100,
    lostEdges: settings.outlineLost / 100,
    accents: settings.outlineAccents / 100,
    hidden: settings.outlineHidden,
    shadeWeights: [1 - SHADE.lost * shade, 1 + SHADE.gained * shade] as const,
    wobble: settings.outlineHand,
    overshoot: OVERSHOOT * Math.max(0, settings.outlineHand - LIGHT_HAND),
    // Outlines use the medium of the strokes.
    tooth: counts({ technique: techniqueOf(settings.technique), medium: settings.medium }, 'tooth')
      ? settings.tooth / 100
      : 0,
    toothSize: settings.toothSize,
    ink: settings.ink,
  };
}

/** The settings that correspond to outline parameters. Ink is the material's, and creases weigh as much as borders of materials. */
export function settingsOfOutlines(parameters: HatchingOutlineParameters): Partial<Settings> {
  const all = { ...HATCHING_OUTLINE_DEFAULTS, ...parameters };
  const percent = (weight: number): number => Math.round(100 * weight);
  return {
    outlines: 'on',
    outlineWidth: all.outlineWidth,
    outlineContours: percent(all.contours),
    outlineInner: percent(all.innerContours),
    outlineBorders: percent(all.borders),
    outlineCreases: percent(all.creases),
    outlineSuggestive: percent(all.suggestiveContours),
    outlineLost: percent(all.lostEdges),
    outlineAccents: percent(all.accents),
    outlineHidden: all.hidden,
    outlineShade: outlineShadeOf(all.shadeWeights as readonly number[]),
    outlineHand: all.wobble,
  };
}
