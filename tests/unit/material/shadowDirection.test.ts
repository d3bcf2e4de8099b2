import { describe, expect, test } from 'vitest';
import { formOf, runsAway } from '../../../src/look/queries.js';
import type { HatchingMaterialParameters } from '../../../src/material/checkValues.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../src/material/HatchingShadowMaterial.js';

describe('shadows alone', () => {
  test('are light, dissolve, have soft edges and run away from the light, except with the techniques of Suarez et al.', () => {
    const valuesOf = (technique: HatchingMaterialParameters['technique']) => {
      const look = new HatchingShadowMaterial({ technique });
      return [look.shadowTone, look.shadowFade, look.shadowSoftness, look.shadowDirection];
    };
    for (const technique of ['triangle', 'adjacency'] as const)
      expect(valuesOf(technique)).toEqual([1, 0, 0, 'strokes']);
    for (const technique of ['hatching', 'engraving'] as const)
      expect(valuesOf(technique)).toEqual([0.5, 0.65, 0.12, 'away']);
  });

  test('that run away from the light are drawn in one layer by one program, whatever the other properties', () => {
    const crossed = { shadowStrokes: 'cross', strokeLayers: 'tone', direction: 'form' } as const;
    const plain = { shadowStrokes: 'tone', strokeLayers: 'single', direction: 'light' } as const;
    const [away, single] = [crossed, plain].map((look) => new HatchingShadowMaterial(look).defines);
    expect(away).toEqual(single);
    const asStrokes = new HatchingShadowMaterial({ ...crossed, shadowDirection: 'strokes' }).defines;
    expect(asStrokes).not.toEqual({ ...single, SHADOW_DIRECTION: asStrokes.SHADOW_DIRECTION });
  });

  test('that run away from the light are neither turned nor crossed', () => {
    const { uniforms } = new HatchingShadowMaterial({ strokeAngle: 0.3, crossFrom: 0.2 });
    expect(uniforms.strokeDirection.value.toArray()).toEqual([expect.closeTo(0), -1]);
    expect(uniforms.crossFrom.value).toBe(1);
    const other = new HatchingMaterial({ strokeAngle: 0.3, crossFrom: 0.2 });
    expect(other.uniforms.strokeDirection.value.toArray()).toEqual([Math.cos(0.3), Math.sin(0.3)]);
    expect(other.uniforms.crossFrom.value).toBe(0.2);
  });

  test('need no form field', () => {
    const look = { technique: 'engraving', direction: 'form' } as const;
    expect(formOf(look)).toBe(true);
    expect(formOf({ ...look, isHatchingShadowMaterial: true })).toBe(false);
    expect(runsAway({ ...look, isHatchingShadowMaterial: true, shadowDirection: 'strokes' })).toBe(false);
    expect(runsAway(look)).toBe(false);
  });
});
