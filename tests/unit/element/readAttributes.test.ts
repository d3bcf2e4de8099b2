import { readFileSync } from 'node:fs';
import { presets } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { readControls, readHand, readLight, readLookNumber, readPreset } from '../../../src/element/readAttributes.js';

describe('preset', () => {
  test.each([null, '', '  '])('is the pen for %o', (text) => expect(readPreset(text)).toBe(presets.pen));

  test.each(Object.keys(presets))('knows %s', (name) =>
    expect(readPreset(` ${name} `)).toBe(presets[name as keyof typeof presets]),
  );

  test.each(['oils', 'Pen', 'toString', '__proto__'])('lists all presets, instead of %s', (name) => {
    expect(() => readPreset(name)).toThrow(`There is no preset "${name}". There are pen, crossHatching, engraving,`);
  });
});

describe.each(['color-fill', 'color-hatching', 'exposure', 'vignette'] as const)('%s', (name) => {
  test.each([
    [null, undefined],
    ['', undefined],
    [' 0.4 ', 0.4],
    ['1', 1],
  ])('%o is %o', (text, value) => expect(readLookNumber(name, text)).toBe(value));

  test.each(['red', '-0.1', '40%', 'NaN', 'Infinity'])('%o is refused', (text) => {
    expect(() => readLookNumber(name, text)).toThrow(`The ${name} is "${text}", but must be a number`);
  });
});

test('a share is from 0 to 1; an exposure may be greater, but not 0', () => {
  for (const name of ['color-fill', 'color-hatching', 'vignette'] as const) {
    expect(readLookNumber(name, '0')).toBe(0);
    expect(() => readLookNumber(name, '1.5')).toThrow(`The ${name} is "1.5"`);
  }
  expect(readLookNumber('exposure', '1.5')).toBe(1.5);
  expect(() => readLookNumber('exposure', '0')).toThrow('must be a number above 0');
});

describe('hand', () => {
  test.each([null, '', '  '])('is none for %o', (text) => expect(readHand(text, presets.chalk)).toBeUndefined());

  test('is drawn by presets of the pen', () => {
    expect(readHand(' mine/hand.json ', presets.pen)).toBe('mine/hand.json');
    expect(() => readHand('hand.json', presets.chalk)).toThrow(
      'A hand needs a preset that draws with a pen: pen, crossHatching.',
    );
  });
});

describe('light', () => {
  test.each([
    ['30 20', 30, 20],
    ['  -120,5.5 ', -120, 5.5],
    ['720 -90', 720, -90],
  ])('%o is azimuth and elevation', (text, azimuth, elevation) =>
    expect(readLight(text)).toEqual({ azimuth, elevation }),
  );

  test.each(['left', '30', '30 20 10', '0 91', '1e999 0', '0 NaN'])('%o is refused', (text) => {
    expect(() => readLight(text)).toThrow(`The light is "${text}", but must be its azimuth and elevation`);
  });

  test.each([null, '', '  '])('is that of the model for %o', (text) => expect(readLight(text)).toBeUndefined());
});

test('controls turn the model, or the light alone', () => {
  expect([null, '', 'controls', 'orbit', 'light', ' Light '].map(readControls)).toEqual([
    'none',
    'orbit',
    'orbit',
    'orbit',
    'light',
    'light',
  ]);
});

test('the entry can be imported without a browser, and has the attributes of its guide', async () => {
  expect('HTMLElement' in globalThis).toBe(false);
  const { HatchedModelElement } = await import('three-hatching/element');
  const guide = readFileSync(new URL('../../../docs/element.md', import.meta.url), 'utf8');
  const table = guide.slice(guide.indexOf('| attribute |'), guide.indexOf('\n\nAll can be changed'));
  const listed = [...table.matchAll(/^\| `(.+?)` \|/gm)].map(([, name]) => name);
  expect(HatchedModelElement.observedAttributes).toEqual(listed);
});
