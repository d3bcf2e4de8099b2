import { expect, test } from 'vitest';
import {
  lightOf,
  MAX_VIEWS,
  plainName,
  readView,
  type SavedView,
  writeView,
} from '../../../../src/viewer/settings/CameraView.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { readLink, writeLink } from '../../../../src/viewer/settings/shareLink.js';

const settings = { ...defaultSettings(), lightKind: 'spot', lightAzimuth: -12.5, secondLight: 'free' } as const;
const near: SavedView = {
  name: 'From_the left, low & near',
  camera: { position: [1.25, -0.5, 2.0000001 / 3], target: [0, 0.125, 0] },
  light: lightOf(settings),
};
const whole: SavedView = { name: 'Ganz, 全体', camera: undefined, light: lightOf(defaultSettings()) };

test('views come back from a link, in their order, with camera, light and name', () => {
  const link = writeLink(settings, undefined, undefined, [near, whole]);
  expect(readLink(`#${link}`).views).toEqual([near, whole]);
  expect(readLink('#model=cube').views).toEqual([]);
});

test('invalid views of a link are left out', () => {
  const good = writeView(near);
  const bad = [
    '',
    '_',
    good.replace('1.25', 'NaN'),
    good.replace('1.25', '1e9'),
    good.replace('1.25', ''),
    good.replace('spot', 'laser'),
    good.replace('-12.5', 'left'),
    good.slice(0, good.indexOf('From')),
    'framed',
    '__proto__',
  ];
  for (const text of bad) expect(readView(text), text).toBeUndefined();
  const link = new URLSearchParams([good, ...bad].map((text) => ['view', text])).toString();
  expect(readLink(link).views).toEqual([near]);
  // A light that is out of range is put where the controls end.
  expect(readView(good.replace('-12.5', '-7000'))?.light.lightAzimuth).toBe(-180);
});

test('no more views are read than there are keys for', () => {
  const link = writeLink(settings, undefined, undefined, Array(40).fill(near));
  expect(readLink(link).views).toHaveLength(MAX_VIEWS);
  expect(MAX_VIEWS).toBe(9);
});

test('a name is one short line without characters that reorder text', () => {
  expect(plainName('  a\n\tb\u202Emoc.elpmaxe\u2066 ')).toBe('a b moc.elpmaxe');
  expect([...plainName('😀'.repeat(200))]).toHaveLength(40);
  expect(plainName('\u202E\u0000 ')).toBe('');
});

test('a view keeps where both lights are', () => {
  const lit = { ...settings, secondAzimuth: 35, secondElevation: 20 };
  const view = readView(writeView({ ...near, light: lightOf(lit) }));
  expect(view?.light).toMatchObject({ lightKind: 'spot', lightAzimuth: -12.5, secondAzimuth: 35, secondElevation: 20 });
});
