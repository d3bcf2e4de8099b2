import { DataTexture, EquirectangularReflectionMapping, FloatType } from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { type KnotStage, knot } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

/** A window in a dim room. */
const room = ((): DataTexture => {
  const [width, height] = [64, 32];
  const texels = new Float32Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const isWindow = x > 14 && x < 26 && y > 18 && y < 28;
    texels.set(isWindow ? [12, 11, 9, 1] : [0.15, 0.2 + (0.3 * y) / height, 0.3, 1], 4 * i);
  }
  const texture = new DataTexture(texels, width, height);
  texture.type = FloatType;
  texture.mapping = EquirectangularReflectionMapping;
  texture.needsUpdate = true;
  return texture;
})();

/** A knot in a room, with the lamps of {@link knot} or without. */
async function inRoom(kit: Kit, parameters: HatchingMaterialParameters, hasLamps: boolean): Promise<KnotStage> {
  const stage = knot(
    await kit.hatching({ technique: 'engraving', direction: 'slant', composition: { exposure: 1 }, ...parameters }),
  );
  const { scene } = stage;
  scene.environment = room;
  scene.environmentIntensity = 0.6;
  scene.environmentRotation.set(0.2, 1, 0.1);
  if (hasLamps) stage.sun.intensity = 1;
  else scene.remove(...scene.children.filter((object) => 'isLight' in object));
  return stage;
}

/** Light of the surroundings. */
export const cases: readonly SceneCase[] = [
  { name: 'an environment alone', show: (kit) => inRoom(kit, {}, false) },
  {
    name: 'an environment beside a lamp, on faces',
    show: (kit) => inRoom(kit, { toneNormal: 'face', composition: { exposure: 1.5 } }, true),
  },
  {
    name: 'an exposure that is fitted to an environment',
    show: (kit) => inRoom(kit, { composition: { exposure: 'auto' } }, true),
  },
];
