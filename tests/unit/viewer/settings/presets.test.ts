import { describe, expect, test } from 'vitest';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from '../../../../src/look/hatchingProperties.js';
import { counts } from '../../../../src/look/measuredFacts.js';
import { givenValue } from '../../../../src/look/queries.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { OUTLINE_NUMBER_NAMES, OUTLINE_WEIGHT_NAMES } from '../../../../src/material/outlines/outlineProperties.js';
import { presets } from '../../../../src/scene/presets.js';
import { materialSizesIn, parameterSetter } from '../../../../src/viewer/drawing/materials.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { outlineLook } from '../../../../src/viewer/settings/materialLook.js';
import { PRESET_NAMES } from '../../../../src/viewer/settings/presetLabels.js';
import { firstView, presetLook, presetOf, wholeLook } from '../../../../src/viewer/settings/presets.js';
import {
  acceptSetting,
  defaultSettings,
  SETTING_KEYS,
  SETTINGS,
  type SettingKey,
  type Settings,
} from '../../../../src/viewer/settings/settings.js';
import { readLink, writeLink } from '../../../../src/viewer/settings/shareLink.js';
import type { Setting } from '../../../../src/viewer/settings/table/rows.js';

const settingsOf = (name: (typeof PRESET_NAMES)[number]): Settings => ({ ...defaultSettings(), ...presetLook(name) });

test('sizes go with a picture and a small sheet as far as they are measured on them', () => {
  const settings = { ...defaultSettings(), strokeWidth: 2, lineSpacing: 4, strokeLength: 40, paperGrainSize: 3 };
  const sizesAt = (screenSpaceShare: number, ...of: [number, number?]) =>
    materialSizesIn(lookOf({ ...settings, screenSpaceShare }), ...of);
  expect(sizesAt(100, 1, 4)).toEqual({
    strokeWidth: 8,
    lineSpacing: 16,
    strokeLength: 160,
    paperGrainSize: 12,
    minLineSpacing: 12,
  });
  expect(sizesAt(50, 1, 4)).toEqual({
    strokeWidth: 8,
    lineSpacing: 8,
    strokeLength: 80,
    paperGrainSize: 12,
    minLineSpacing: 12,
  });
  expect(sizesAt(0, 1, 4)).toEqual({
    strokeWidth: 8,
    lineSpacing: 4,
    strokeLength: 40,
    paperGrainSize: 12,
    minLineSpacing: 12,
  });
  expect(sizesAt(100, 0.5)).toEqual({
    strokeWidth: 1,
    lineSpacing: 2,
    strokeLength: 20,
    paperGrainSize: 1.5,
    minLineSpacing: 3,
  });
});

describe('the presets of the page', () => {
  test('are those of the library, in its order', () => {
    expect(PRESET_NAMES).toEqual(Object.keys(presets));
  });

  test.each(PRESET_NAMES)('%s gives the material and the outlines of the library', (name) => {
    const settings = settingsOf(name);
    const expected = new HatchingMaterial(presets[name].material);
    const made = new HatchingMaterial();
    parameterSetter(lookOf(settings).drawn)(made);
    Object.assign(made, materialSizesIn(lookOf(settings), 1));
    for (const property of Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[]) {
      // The size of strokes on the object follows from the size of the model.
      if (property === 'tilesPerObjectUnit' || property === 'tonalArtMap') continue;
      // Belongs to the light of the page, which bakes it only when asked.
      if (property === 'occlusion') continue;
      // The page draws one model in a light that is dragged: its exposure follows.
      if (property === 'exposure') continue;
      if (!counts(expected, property)) continue;
      const [got, want] = [made, expected].map((material) => givenValue(material, property));
      if (typeof want === 'number') expect(got, property).toBeCloseTo(want, 6);
      else expect(got, property).toEqual(want);
    }
    expect(settings.mapStyle).toBe(presets[name].tonalArtMap?.style ?? defaultSettings().mapStyle);

    const outlines = new HatchingOutlineMaterial(presets[name].outlines);
    const drawn = new HatchingOutlineMaterial(outlineLook(settings));
    for (const number of OUTLINE_NUMBER_NAMES) expect(drawn[number], number).toBeCloseTo(outlines[number], 6);
    for (const name of OUTLINE_WEIGHT_NAMES) expect(drawn.weights[name], name).toBeCloseTo(outlines.weights[name], 6);
    expect(drawn.ink.equals(outlines.ink)).toBe(true);
    expect(settings.outlines).toBe('on');
  });

  test.each(PRESET_NAMES)('%s is recognised, survives a link, and fits the controls', (name) => {
    const settings = settingsOf(name);
    expect(presetOf(settings)).toBe(name);
    expect(readLink(writeLink(settings, undefined)).settings).toEqual(settings);
    for (const key of SETTING_KEYS) expect(acceptSetting(key, settings[key]), key).toBe(settings[key]);
    expect(presetOf({ ...settings, outlineWidth: settings.outlineWidth + 1 })).toBeUndefined();
  });

  test('engraving chooses the field of lines by the shape, and links that ask for it follow the light', () => {
    expect(settingsOf('engraving').direction).toBe('auto');
    expect(readLink('preset=engraving').settings.direction).toBe('auto');
    expect(readLink('preset=engraving&direction=light').settings.direction).toBe('light');
    // Links of the page spell out what is not at its default, which was and is the light.
    expect(readLink('technique=engraving&lineSpacing=4.5&irregularity=40').settings.direction).toBe('light');
  });

  test('reset the previous look, and keep the model, the position of the light and the camera', () => {
    const before = {
      ...defaultSettings(),
      model: 'bunny',
      lightAzimuth: 12,
      shadows: 'on',
      offsetU: 0.5,
      crossAngle: 20,
      blendAngle: 30,
    };
    const after = { ...before, ...presetLook('stipple') };
    expect(after).toMatchObject({
      model: 'bunny',
      lightAzimuth: 12,
      shadows: 'on',
      offsetU: 0,
      crossAngle: 60,
      blendAngle: 90,
    });
  });
});

describe('the button of a preset', () => {
  test('gives the same picture whatever was chosen before, but for the model, the lights, the renderer and the export', () => {
    const others: Partial<Settings> = Object.fromEntries(SETTING_KEYS.map((key) => [key, otherValue(key)] as const));
    for (const name of PRESET_NAMES) {
      const fresh = { ...defaultSettings(), ...wholeLook(name) };
      const later = { ...defaultSettings(), ...others, ...wholeLook(name) };
      const kept = SETTING_KEYS.filter((key) => fresh[key] !== later[key]);
      expect(kept).toEqual(
        SETTING_KEYS.filter(
          (key) =>
            /^(model|compare|renderer|surfaceColors|upAxis|lightKind|lightAzimuth|lightElevation|lightFollows|lightDistance)$/.test(
              key,
            ) || /^(spot|second|picture|video|focus)/.test(key),
        ),
      );
      expect(presetOf(later)).toBe(name);
    }
  });
});

/** A value that is not the default. */
function otherValue(key: SettingKey): string | number {
  const setting: Setting = SETTINGS[key];
  if (setting.kind === 'number') return setting.default === setting.max ? setting.min : setting.max;
  if (setting.kind === 'color') return '#123456';
  return Object.keys(setting.choices).find((choice) => choice !== setting.default)!;
}

describe('the first view', () => {
  test('is an engraving with shadows of its own, for a page without a link', () => {
    expect(presetOf(firstView())).toBe('engraving');
    expect(firstView()).toEqual({ ...defaultSettings(), ...wholeLook('engraving') });
    expect(firstView().shadows).toBe('on');
    for (const hash of ['', '#']) expect(readLink(hash).settings).toEqual(firstView());
  });

  test('is not mistaken for a link with defaults, nor for one that names a model alone', () => {
    const link = writeLink(defaultSettings(), undefined);
    expect(readLink(link).settings).toEqual(defaultSettings());
    expect(readLink('#model=bunny').settings).toEqual({ ...defaultSettings(), model: 'bunny' });
  });
});
