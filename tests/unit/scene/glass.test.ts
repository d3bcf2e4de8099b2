import { BoxGeometry, type BufferGeometry, DataTexture, Group, Mesh, MeshPhysicalMaterial } from 'three';
import { expect, test } from 'vitest';
import { GLASS } from '../../../src/look/glass.js';
import type { HatchingMaterialParameters } from '../../../src/material/checkValues.js';
import type { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';

async function hatched(
  source: ConstructorParameters<typeof MeshPhysicalMaterial>[0],
  parameters: HatchingMaterialParameters = {},
): Promise<HatchingMaterial> {
  const mesh = new Mesh<BufferGeometry, MeshPhysicalMaterial>(new BoxGeometry(), new MeshPhysicalMaterial(source));
  const { materials } = await applyHatching(new Group().add(mesh), {
    tonalArtMap: null,
    material: { technique: 'engraving', toneCurve: 'perceptual', occlusion: 1, ...parameters },
  });
  return materials[0];
}

test('a material with transmission is drawn as glass, a veil of paper before what is behind, and is never dark', async () => {
  expect(await hatched({ transmission: 1 })).toMatchObject(GLASS);
  const paperOpacity = 1 - 0.75 * (1 - GLASS.paperOpacity);
  expect(await hatched({ transmission: 0.75 })).toMatchObject({ ...GLASS, paperOpacity });
  expect(await hatched({ transmission: 1 }, { paperOpacity: 0.5 })).toMatchObject({ ...GLASS, paperOpacity: 0.5 });
});

test('glass in a woodcut has no veil, which would be a grey', async () => {
  const woodcut = { technique: 'woodcut' } as const;
  expect(await hatched({ transmission: 1 }, woodcut)).toMatchObject({ ...GLASS, paperOpacity: 0 });
});

test('other materials are not, nor those with a transmissionMap', async () => {
  const opaque = { transparent: false, depthWrite: true, paperOpacity: 1, toneCurve: 'perceptual', occlusion: 1 };
  expect(await hatched({})).toMatchObject(opaque);
  expect(await hatched({ transmission: 1, transmissionMap: new DataTexture() })).toMatchObject(opaque);
});
