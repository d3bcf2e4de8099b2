import { describe, expect, test } from 'vitest';
import type { CameraView } from '../../../../src/viewer/settings/CameraView.js';
import { Random } from '../../../../src/viewer/settings/Random.js';
import { defaultSettings, SETTING_KEYS, SETTINGS } from '../../../../src/viewer/settings/settings.js';
import { type ModelChoice, NO_CHOICE, readLink, writeLink } from '../../../../src/viewer/settings/shareLink.js';

describe('a link', () => {
  test('with nothing but defaults is not the first view', () => {
    const link = writeLink(defaultSettings(), undefined);
    expect(readLink(link).settings).toEqual(defaultSettings());
    expect(readLink('').settings).not.toEqual(defaultSettings());
  });

  test('keeps layers and how they cross', () => {
    const settings = { ...defaultSettings(), strokeLayers: 'tone', crossFrom: 30, crossAngle: 90 } as const;
    expect(readLink(`#${writeLink(settings, undefined)}`).settings).toEqual(settings);
  });

  test('has numbers as short as the steps of their fields, whatever the settings were computed from', () => {
    const settings = defaultSettings();
    for (const key of SETTING_KEYS) {
      const { kind, ...setting } = SETTINGS[key];
      if (kind === 'number') Object.assign(settings, { [key]: (setting.default as number) + 1 / 3 });
    }
    const link = new URLSearchParams(writeLink(settings, undefined));
    for (const text of link.values()) {
      if (!Number.isNaN(Number(text))) expect(text).toMatch(/^-?\d{1,3}(\.\d{1,3})?$/);
    }
    expect(writeLink(readLink(link.toString()).settings, undefined)).toBe(writeLink(settings, undefined));
  });

  test('restores a view to the last bit of single precision, from the fewest digits possible', () => {
    const random = new Random(22);
    for (let i = 0; i < 500; i++) {
      const numbers = Array.from({ length: 6 }, () =>
        Math.fround((random.next() - 0.5) * 10 ** (2 - 6 * random.next())),
      );
      const camera = { position: numbers.slice(0, 3), target: numbers.slice(3) } as unknown as CameraView;
      const link = writeLink(defaultSettings(), camera);
      expect(readLink(link).camera).toEqual(camera);
      const text = new URLSearchParams(link).get('camera')!;
      for (const number of text.split(','))
        expect(number.replace(/^-?[0.]*|\.|e.*$/g, '').length).toBeLessThanOrEqual(9);
    }
    const plain: CameraView = { position: [Math.fround(0.1), -2, 3.5], target: [0, 0, Math.fround(1 / 3)] };
    expect(new URLSearchParams(writeLink(defaultSettings(), plain)).get('camera')).toBe('0.1,-2,3.5,0,0,0.33333334');
    // As links had them before.
    expect(readLink('camera=1.234,0.5,-6.001,0,0.04,0').camera?.position).toEqual(
      [1.234, 0.5, -6.001].map(Math.fround),
    );
  });

  test('includes the variant and the clip of a file, as numbers counted from 1', () => {
    const choice = { variant: 0, clip: 11 };
    const link = writeLink(defaultSettings(), undefined, undefined, [], undefined, choice);
    expect(link).toContain('variant=1&clip=12');
    expect(readLink(link).choice).toEqual(choice);
    for (const other of ['', '0', '-1', '1.5', 'red', '1e3', '99999', '١']) {
      expect(readLink(`variant=${other}&clip=${other}`).choice).toEqual(NO_CHOICE);
    }
  });

  test('includes hidden parts, and the changes that are not made to a file', () => {
    const choice: ModelChoice = { ...NO_CHOICE, switched: ['orientation', 'hidden'], hidden: [0, 1, 2, 6] };
    const link = writeLink(defaultSettings(), undefined, undefined, [], undefined, choice);
    expect(new URLSearchParams(link).get('hidden')).toBe('1-3,7');
    expect(readLink(link).choice).toEqual(choice);
    expect(readLink('switched=sides,none,orientation&hidden=x').choice).toEqual({
      ...NO_CHOICE,
      switched: ['orientation', 'sides'],
    });
  });

  test('carries a model by its address, over HTTPS alone', () => {
    const address = 'https://models.test/a%20b/bust.glb?v=1&x=2';
    const link = writeLink({ ...defaultSettings(), model: 'file', inkBlend: 'multiply' }, undefined, address);
    expect(readLink(link)).toMatchObject({ address, settings: { inkBlend: 'multiply', model: 'dragon3' } });
    expect(writeLink(defaultSettings(), undefined, address)).not.toContain('https');
    for (const other of ['http://models.test/bust.glb', 'javascript:alert(1)', 'data:,x', '//models.test/x', 'cube']) {
      expect(readLink(`model=${encodeURIComponent(other)}`).address).toBeUndefined();
    }
  });

  test('names its model, also the first of all, unless that is a file of the user', () => {
    for (const model of ['dragon3', 'cube'] as const) {
      const link = writeLink({ ...defaultSettings(), model }, undefined);
      expect(readLink(link)).toMatchObject({ namesModel: true, settings: { model } });
    }
    expect(readLink('model=https%3A%2F%2Fmodels.test%2Fbust.glb').namesModel).toBe(true);
    const ofFile = writeLink({ ...defaultSettings(), model: 'file' }, undefined);
    for (const link of ['', ofFile, 'preset=engraving', 'model=file', 'model=none']) {
      expect(readLink(link).namesModel, link).toBe(false);
    }
  });

  test('drops name and password of a URL, and rejects invalid hosts', () => {
    const read = (address: string) => readLink(`model=${encodeURIComponent(address)}`).address;
    expect(read('https://trusted.test:x@evil.test:8443/a.glb')).toBe('https://evil.test:8443/a.glb');
    expect(read('https://trusted.test\\@evil.test/a.glb')).toBe('https://trusted.test/@evil.test/a.glb');
    expect(read(`https://${'a.'.repeat(126)}t/a.glb`)).toBeDefined();
    expect(read(`https://${'a.'.repeat(127)}t/a.glb`)).toBeUndefined();
  });
});

test('a hand goes along in a link that draws with it, and a link without one never asks for it', () => {
  const settings = { ...defaultSettings(), mapStyle: 'ownHand' } as const;
  const link = writeLink(settings, undefined, undefined, [], 'aZ09-_');
  expect(readLink(link)).toMatchObject({ settings: { mapStyle: 'ownHand' }, handText: 'aZ09-_' });
  expect(writeLink(settings, undefined)).not.toContain('ownHand');
  expect(writeLink(defaultSettings(), undefined, undefined, [], 'aZ09-_')).not.toContain('hand=');
  expect(readLink('mapStyle=ownHand')).toMatchObject({ settings: { mapStyle: 'hatching' }, handText: undefined });
  expect(readLink('mapStyle=ruled&hand=abc').handText).toBeUndefined();
});
