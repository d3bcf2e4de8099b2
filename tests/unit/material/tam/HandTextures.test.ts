import { Material } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import type { HatchingMaterialProperties } from '../../../../src/material/HatchingMaterialProperties.js';
import { HandTextures } from '../../../../src/material/tam/HandTextures.js';
import type { Hand } from '../../../../src/strokes/hand/Hand.js';
import { exampleHand } from '../../../../src/strokes/hands/exampleHand.js';

const hand = exampleHand('brush');
const dots: Hand = { ...hand, strokes: [{ points: [1, 1, 1.1, 1], widths: [1, 1] }] };

const materialWith = (chosen: Hand): HatchingMaterialProperties =>
  Object.assign(new Material(), { hand: chosen }) as unknown as HatchingMaterialProperties;

afterEach(() => vi.restoreAllMocks());

test.each([
  ['the hand before it stays', hand],
  ['there was none: it draws the strokes of the pen', null],
])('a material that gets a hand with a fault says so, and %s', (_what, before) => {
  const error = vi.spyOn(console, 'error').mockImplementation(() => {});
  const textures = new HandTextures();
  const material = materialWith(hand);
  const drawn = before && textures.use(material, before);
  material.hand = dots;
  expect(textures.use(material, dots)).toBeUndefined();
  expect(material.hand).toBe(before);
  expect(error.mock.calls).toEqual([[expect.stringMatching(/all strokes are dots.*\. The .*\.$/)]]);
  expect(error.mock.calls[0][0]).toContain(before ? 'The hand before it stays' : 'the technique "pen"');
  if (drawn) expect(textures.use(material, hand)).toBe(drawn);
});

test('materials share the texture of a hand, which is freed with the last of them', () => {
  const textures = new HandTextures();
  const materials = [materialWith(hand), materialWith(hand)];
  const drawn = materials.map((material) => textures.use(material, hand)!);
  expect(drawn[1].texture).toBe(drawn[0].texture);
  const freed = vi.fn();
  drawn[0].texture.addEventListener('dispose', freed);
  materials[0].dispose();
  expect(freed).not.toHaveBeenCalled();
  materials[1].dispose();
  expect(freed).toHaveBeenCalledOnce();
});
