import { expect, test, vi } from 'vitest';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { FollowedMaterial } from '../../../src/react/elements.js';
import { exampleHand } from '../../../src/strokes/hands/index.js';
import { eventually } from '../patience.js';

const invalidate = vi.hoisted(() => vi.fn());
vi.mock('@react-three/fiber', () => ({ extend() {}, invalidate }));

test('a canvas that draws on demand draws again when the map is there, once, and when another is', async () => {
  const material = new FollowedMaterial();
  const draw = (): void => FollowedMaterial.prototype.onBeforeRender.call(material);
  const [first, second] = [1, 2].map((seed) => TonalArtMap.draw({ size: 64, tones: 4, seed }));
  material.tonalArtMap = first;
  draw();
  draw();
  expect(invalidate).not.toHaveBeenCalled();
  await first.ready;
  await eventually(() => expect(invalidate).toHaveBeenCalledOnce());
  draw();
  material.tonalArtMap = second;
  draw();
  await second.ready;
  await eventually(() => expect(invalidate).toHaveBeenCalledTimes(2));
});

test('a canvas that draws on demand draws again when the code that draws a hand is there', async () => {
  invalidate.mockClear();
  const material = new FollowedMaterial({ preset: 'pen' });
  const draw = (): void => FollowedMaterial.prototype.onBeforeRender.call(material);
  draw();
  await eventually(() => expect(invalidate).toHaveBeenCalledOnce());
  material.hand = exampleHand('brush');
  draw();
  draw();
  await eventually(() => expect(invalidate).toHaveBeenCalledTimes(2));
});

test('a composition that is removed again leaves that of the preset, not one that all materials share', async () => {
  // React Three Fiber marks materials of elements, and reads defaults from one that it makes itself.
  const [first, second] = ['pen', 'woodcut'].map((preset) =>
    Object.assign(new FollowedMaterial({ preset: preset as 'pen' }), { __r3f: {} }),
  );
  const { composition } = new FollowedMaterial();
  for (const material of [first, second]) {
    const { exposure, vignette } = material.composition;
    material.composition = { exposure: 2, vignette: 0.3 };
    expect(material.composition).toMatchObject({ exposure: 2, vignette: 0.3 });
    material.composition = composition;
    expect(material.composition).toMatchObject({ exposure, vignette });
  }
  expect(first.composition.exposure).toBe('fit');
  expect(first.composition).not.toBe(second.composition);
  second.composition = first.composition;
  expect(second.composition).toBe(first.composition);
  await Promise.all([first.ready, second.ready]);
});
