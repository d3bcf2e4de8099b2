import { Color } from 'three';
import { describe, expect, test } from 'vitest';
import { HATCHING_DEFAULTS, type HatchingPropertyName } from '../../../../src/look/hatchingProperties.js';
import { plainValue } from '../../../../src/look/presetParameters.js';
import { givenValue } from '../../../../src/look/queries.js';
import { HATCHING_BACKGROUND_DEFAULTS } from '../../../../src/material/backgroundProperties.js';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../../src/material/HatchingShadowMaterial.js';
import { HATCHING_OUTLINE_DEFAULTS } from '../../../../src/material/outlines/outlineProperties.js';
import { HAND_NUMBER_RANGES, type Hand, handLines } from '../../../../src/strokes/hand/Hand.js';
import { resolveMapDrawing } from '../../../../src/strokes/tamImages/hatchImageOptions.js';
import { parameterSetter } from '../../../../src/viewer/drawing/materials.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { PAGE_DEFAULTS } from '../../../../src/viewer/settings/table/pageDefaults.js';

/** The properties of material and outlines that settings of other names stand for. */
const PROPERTIES: Record<string, string> = {
  lightStrength: 'exposureCompensation',
  outlineHand: 'wobble',
  outlineMeetings: 'intersections',
};

const settings = { ...defaultSettings(), background: 'on' } as const;
const look = lookOf(settings);
/** A value in a form in which equal ones are equal. */
const comparable = (value: unknown): string =>
  JSON.stringify(
    typeof value === 'string' && value[0] === '#' ? new Color(value).getHex() : plainValue(value),
    (_, part) => (typeof part === 'number' ? Number(part.toPrecision(12)) : part),
  );
const differing = (page: Readonly<Record<string, unknown>>, library: Readonly<Record<string, unknown>>): string[] =>
  Object.keys(page).filter((name) => comparable(page[name]) !== comparable(library[name]));

/** Properties of a material of the page, and of one of the library. */
function materials(): [Record<string, unknown>, Record<string, unknown>] {
  const made = new HatchingShadowMaterial();
  parameterSetter({ ...look.drawn, ...look.sizes })(made);
  Object.assign(made, look.groundShadow);
  const library = new HatchingShadowMaterial();
  const names = Object.keys(HATCHING_DEFAULTS) as HatchingPropertyName[];
  const of = (material: HatchingMaterial) =>
    Object.fromEntries(names.map((name) => [name, givenValue(material, name)]));
  return [of(made), of(library)];
}

describe('the defaults of the page', () => {
  test('are those of the library, but for the ones in its table', () => {
    const ofMaterial = differing(...materials());
    const ofOutlines = differing(look.outlines, HATCHING_OUTLINE_DEFAULTS);
    const named = Object.keys(PAGE_DEFAULTS).map((name) => PROPERTIES[name] ?? name);
    expect([...new Set([...ofMaterial, ...ofOutlines])].sort()).toEqual(named.sort());
  });

  test('of the background are those of the library, but for the ink', () => {
    expect(differing(look.background ?? {}, HATCHING_BACKGROUND_DEFAULTS)).toEqual(['ink']);
  });

  test('of the map are those of the library', () => {
    const { mapStyle: style, mapSize, mapTones: tones, mapSeed: seed } = settings;
    expect(resolveMapDrawing()).toMatchObject({ style, size: Number(mapSize), tones, seed });
    expect(HATCHING_DEFAULTS.tonalArtMap).toBe(style);
  });
});

test('a hand is scaled to the distance and width that the library has by default', () => {
  const numbers = Object.fromEntries(
    Object.entries(HAND_NUMBER_RANGES).map(([name, { from, to }]) => [name, (from + to) / 2]),
  );
  const hand = { numbers } as unknown as Hand;
  const { lineSpacing } = HATCHING_DEFAULTS;
  const { outlineWidth } = HATCHING_OUTLINE_DEFAULTS;
  expect(handLines(hand)).toEqual(handLines(hand, { lineSpacing, outlineWidth }));
  expect(handLines(hand)).not.toEqual(handLines(hand, { lineSpacing: 2 * lineSpacing }));
});
