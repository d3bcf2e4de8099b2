import { describe, expect, test } from 'vitest';
import {
  defaultSettings,
  SETTING_KEYS,
  SETTINGS,
  type SettingKey,
  type Settings,
} from '../../../../src/viewer/settings/settings.js';
import {
  choosesMap,
  hasEffect,
  isChoiceKnown,
  looksOf,
  presentUnit,
} from '../../../../src/viewer/settings/settingValues.js';
import type { Setting } from '../../../../src/viewer/settings/table/rows.js';

const used = (key: SettingKey, changes: Partial<Settings>): boolean =>
  hasEffect(key, { ...defaultSettings(), ...changes });

describe('a setting has an effect', () => {
  test.each<[SettingKey, Partial<Settings>, boolean]>([
    ['latticeSpacing', { technique: 'hatching' }, true],
    ['latticeSpacing', { technique: 'adjacency' }, false],
    ['latticeSpacing', { technique: 'adjacency', compare: 'hatching' }, true],
    // Dots beside strokes of triangles: those have a map, and the dots still no anchors.
    ['latticeSpacing', { technique: 'stipple', compare: 'adjacency' }, false],
    ['mapStyle', { technique: 'engraving' }, false],
    ['mapSize', { technique: 'engraving' }, false],
    ['mapStyle', { technique: 'engraving', compare: 'triangle' }, true],
    ['strokeTurn', { technique: 'engraving' }, false],
    ['strokeTurn', { technique: 'stipple' }, false],
    ['strokeTurn', { technique: 'triangle' }, true],
    ['strokeTurn', { direction: 'form' }, false],
    ['strokeTurn', { technique: 'triangle', direction: 'form' }, true],
    ['direction', { technique: 'hatching' }, true],
    ['direction', { technique: 'stipple' }, false],
    ['direction', { technique: 'adjacency' }, false],
    ['strokeAngle', { strokeTurn: 'towards' }, false],
    ['strokeAngle', { strokeTurn: 'angle' }, true],
    ['crossFrom', { technique: 'engraving' }, true],
    ['crossFrom', { technique: 'hatching', strokeLayers: 'lights' }, false],
    ['crossFrom', { technique: 'hatching', strokeLayers: 'tone' }, true],
    ['edge', { technique: 'hatching' }, true],
    ['edge', { technique: 'dryMedia' }, false],
    ['edge', { technique: 'adjacencyCrisp', compare: 'dryMedia' }, true],
    ['strokeWidth', { technique: 'adjacency' }, false],
    ['strokeWidth', { technique: 'adjacency', levelRule: 'depth' }, true],
    ['strokeWidth', { technique: 'engraving', levelRule: 'depth' }, false],
    ['tilesPerObjectUnit', { technique: 'hatching', screenSpaceShare: 100 }, false],
    ['tilesPerObjectUnit', { technique: 'hatching', screenSpaceShare: 99 }, true],
    ['tilesPerObjectUnit', { technique: 'hatching', screenSpaceShare: 100, compare: 'triangle' }, true],
    ['shininess', { toneModel: 'phong' }, true],
    ['shininess', {}, false],
    ['outlineWidth', { outlines: 'off' }, false],
    ['outlineWidth', {}, true],
    ['ground', { shadows: 'off' }, false],
    ['shadowStrokes', { shadows: 'on' }, true],
    ['shadowTone', { shadows: 'on', ground: 'floor' }, false],
    ['shadowFade', { shadows: 'on', ground: 'shadow' }, true],
    ['lightDistance', {}, false],
    ['lightDistance', { lightKind: 'spot' }, true],
    ['spotAngle', { lightKind: 'point' }, false],
    ['secondAzimuth', { secondLight: 'left' }, false],
    ['secondStrength', { secondLight: 'left' }, true],
    ['pictureWidth', { pictureSize: 'a4' }, false],
    ['pictureTurn', { pictureSize: 'a4' }, true],
    ['pictureTurn', { pictureSize: 'own' }, false],
    ['pictureDpi', { pictureSize: 'own' }, true],
    ['pictureDpi', { pictureSize: '2' }, false],
    ['pictureGround', { pictureLayers: 'apart' }, false],
    ['pictureMargin', { pictureSize: '2' }, false],
    ['pictureMargin', { pictureSize: 'a5' }, true],
    ['pictureMargin', { pictureSize: 'a5', pictureCrop: 'drawing' }, false],
    ['depthStrength', { technique: 'engraving' }, false],
    ['depthStrength', { technique: 'engraving', depth: 'on' }, true],
    ['depth', { technique: 'triangle' }, false],
    ['model', {}, true],
  ])('%s with %j: %s', (key, changes, expected) => {
    expect(used(key, changes)).toBe(expected);
  });

  test('each with some others at least', () => {
    const some: Partial<Settings>[] = [
      {
        depth: 'on',
        focus: 'on',
        background: 'on',
        shadows: 'on',
        secondLight: 'free',
        lightKind: 'spot',
        strokeTurn: 'angle',
        pictureSize: 'own',
      },
      { technique: 'dryMedia', toneModel: 'phong', pictureSize: 'a4' },
      { pictureSize: 'inches' },
      {
        technique: 'pen',
        toneModel: 'toon',
        shadows: 'on',
        ground: 'shadow',
        occlusion: 50,
      },
      { technique: 'adjacencyCrisp', pictureSvg: 'pen', picturePens: 'three' },
      { pictureSvg: 'pen', picturePens: 'ink' },
    ];
    const unused = SETTING_KEYS.filter((key) => !some.some((changes) => used(key, changes)));
    expect(unused).toEqual([]);
  });

  test('by settings and values that there are', () => {
    for (const key of SETTING_KEYS) {
      const { when = {} }: Setting = SETTINGS[key];
      for (const [other, values] of Object.entries(when)) {
        const setting: Setting = SETTINGS[other as SettingKey];
        expect(Object.keys('choices' in setting ? setting.choices : {}), key).toEqual(
          expect.arrayContaining([...values]),
        );
      }
    }
  });
});

test.each([
  [100, 'px'],
  [0, '/256 tile'],
  // A mean of the two has no name.
  [50, ''],
])('the distance between outlines, %d %% on the screen, has the unit %j', (screenSpaceShare, unit) => {
  const settings: Settings = { ...defaultSettings(), technique: 'engraving', screenSpaceShare };
  expect(presentUnit('lineSpacing', looksOf(settings))).toBe(unit);
  expect(presentUnit('strokeWidth', looksOf(settings))).toBe('px');
  expect(presentUnit('irregularity', looksOf(settings))).toBe('%');
});

test('settings that determine the map, or whether there is one, choose it again', () => {
  expect(SETTING_KEYS.filter(choosesMap).sort()).toEqual(
    ['technique', 'compare', 'mapStyle', 'mapSize', 'mapTones', 'mapSeed'].sort(),
  );
});

test('a direction is offered to the techniques that know it', () => {
  const offered = (technique: string) =>
    Object.keys(SETTINGS.direction.choices).filter((value) => isChoiceKnown('direction', value, [{ technique }]));
  expect(offered('hatching')).toEqual(['light', 'form', 'acrossForm', 'sheet']);
  expect(offered('engraving')).toEqual(Object.keys(SETTINGS.direction.choices).filter((value) => value !== 'sheet'));
  expect(isChoiceKnown('toneModel', 'toon', [{ technique: 'engraving' }])).toBe(true);
});
