import { describe, expect, test } from 'vitest';
import { defaultSettings } from '../../../../src/demo/settings/settings.js';
import { readLink, writeLink } from '../../../../src/demo/settings/shareLink.js';

describe('a link', () => {
  test('keeps layers and how they cross', () => {
    const settings = { ...defaultSettings(), strokeLayers: 'tone', crossFrom: 30, crossAngle: 90 } as const;
    expect(readLink(`#${writeLink(settings, undefined)}`).settings).toEqual(settings);
  });

  test.each([
    ['1', 'single'],
    ['2', 'lights'],
    ['tone', 'tone'],
    ['3', 'lights'],
  ])('from before there were layers by tone is understood: strokeLayers=%s is %s', (written, meant) => {
    expect(readLink(`#strokeLayers=${written}`).settings.strokeLayers).toBe(meant);
  });
});
