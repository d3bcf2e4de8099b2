import { BoxGeometry, MaterialLoader, Mesh, MeshBasicMaterial, ObjectLoader, type SphereGeometry } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';

/** The statements of the table in docs/support.md about JSON. */

afterEach(() => vi.restoreAllMocks());

const loaded = (mesh: Mesh) =>
  new ObjectLoader().parse(JSON.parse(JSON.stringify(mesh.toJSON()))) as Mesh<SphereGeometry, HatchingMaterial>;

test.each(['corner', 'indexed'] as const)(
  'a mesh of the layout %s comes back, and is drawn as it is',
  async (layout) => {
    MaterialLoader.registerMaterial('HatchingMaterial', HatchingMaterial as never);
    const geometry = await prepareHatchingGeometry(new BoxGeometry(), { layout });
    const mesh = new Mesh(geometry, new HatchingMaterial({ technique: 'engraving', lineSpacing: 7, ink: '#123456' }));
    const { geometry: back, material } = loaded(mesh);
    expect([material.technique, material.lineSpacing, material.ink.getHexString()]).toEqual(['engraving', 7, '123456']);
    expect(Object.keys(back.attributes)).toEqual(Object.keys(geometry.attributes));
    for (const [name, { array, normalized }] of Object.entries(geometry.attributes)) {
      expect([name, back.attributes[name].array, back.attributes[name].normalized]).toEqual([name, array, normalized]);
    }
    expect(back.userData.hatching).toEqual(geometry.userData.hatching);
  },
);

test('the layout pull is restored as its source', async () => {
  const geometry = await prepareHatchingGeometry(new BoxGeometry(), { layout: 'pull' });
  const { geometry: back } = loaded(new Mesh(geometry, new MeshBasicMaterial()));
  expect(back.attributes.position.count).toBe(36);
});
