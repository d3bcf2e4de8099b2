import { expect, test } from 'vitest';
import { blankIntegers } from '../../../src/webgpu/nodes/base/blankTextures.js';
import { hatchingTexture } from '../../../src/webgpu/nodes/base/textures.js';

test('textures of uniforms that are blank alike are not the same one, for which three.js 0.186 would take a single uniform', () => {
  const values = ['outlinePrimitives', 'candidates'].map((name) => {
    const { value } = hatchingTexture(name, blankIntegers) as unknown as { value: typeof blankIntegers };
    return value;
  });
  expect(new Set([...values, blankIntegers].map(({ uuid }) => uuid)).size).toBe(3);
  for (const { image, format, type, version } of values) {
    expect([image, format, type]).toEqual([blankIntegers.image, blankIntegers.format, blankIntegers.type]);
    expect(version).toBeGreaterThan(0);
  }
});
