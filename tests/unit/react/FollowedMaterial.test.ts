import { expect, test, vi } from 'vitest';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { FollowedMaterial } from '../../../src/react/elements.js';
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
