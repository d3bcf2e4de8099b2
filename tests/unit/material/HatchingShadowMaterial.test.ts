import { MaterialLoader } from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../src/material/HatchingShadowMaterial.js';

// Materials are read in the same task in which they are created.
await HatchingMaterial.preload();

describe('HatchingShadowMaterial', () => {
  test("is clear but for its shadows, as three's ShadowMaterial", () => {
    const material = new HatchingShadowMaterial();
    expect(material).toMatchObject({ transparent: true, paperOpacity: 0, type: 'HatchingShadowMaterial' });
    expect(new HatchingShadowMaterial({ transparent: false, paperOpacity: 1 })).toMatchObject({
      transparent: false,
      paperOpacity: 1,
    });
  });

  test('has a program of its own, whatever the tone model', () => {
    const { defines } = new HatchingShadowMaterial({ technique: 'engraving' });
    expect(defines.TONE_MODEL).toBe(4);
    expect(new HatchingShadowMaterial({ technique: 'engraving', toneModel: 'toon' }).defines).toEqual(defines);
    expect(new HatchingMaterial({ technique: 'engraving' }).defines.TONE_MODEL).toBe(0);
    expect(new HatchingMaterial()).not.toHaveProperty('shadowTone');
  });

  test.each([{}, { transparent: false, paperOpacity: 1, shadowTone: 0.2 }])('is restored from JSON: %j', (given) => {
    const source = new HatchingShadowMaterial({ preset: 'woodcut', ...given });
    const json = JSON.parse(JSON.stringify(source.toJSON()));
    MaterialLoader.registerMaterial('HatchingShadowMaterial', HatchingShadowMaterial);
    for (const made of [HatchingShadowMaterial.fromJSON(json), new MaterialLoader().parse(json)]) {
      expect(made).toBeInstanceOf(HatchingShadowMaterial);
      for (const name of ['transparent', 'paperOpacity', 'shadowTone', 'shadowSoftness', 'technique'] as const)
        expect((made as HatchingShadowMaterial)[name], name).toBe(source[name]);
    }
  });
});
