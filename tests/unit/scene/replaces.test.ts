import { BoxGeometry, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { reactive } from '../material/geometry/reactive.js';

const scene = () => {
  const meshes = [new BoxGeometry(), new SphereGeometry(1, 8, 6)].map((one) => new Mesh(one, new MeshBasicMaterial()));
  return {
    root: new Group().add(...meshes),
    meshes,
    looks: meshes.map(({ geometry, material }) => ({ geometry, material })),
  };
};
const looksOf = (meshes: readonly Mesh[]) => meshes.map(({ geometry, material }) => ({ geometry, material }));

describe('a look that replaces another', () => {
  test("is drawn as soon as it is ready; the former one is freed, and the scene's own look can be restored", async () => {
    const { root, meshes, looks } = scene();
    const first = await applyHatching(root, 'technical');
    let freed = 0;
    for (const mesh of meshes) mesh.geometry.addEventListener('dispose', () => freed++);
    const before = looksOf(meshes);
    const ready = applyHatching(root, { preset: 'engraving', material: { ink: '#123456' }, replaces: first });
    expect(looksOf(meshes)).toEqual(before);
    const second = await ready;
    expect(freed).toBe(2);
    for (const { material, children } of meshes) {
      expect((material as unknown as HatchingMaterial).ink.getHexString()).toBe('123456');
      expect(children).toHaveLength(1);
    }
    await expect(applyHatching(root, 'technical')).rejects.toThrow('is hatched already');
    second.dispose();
    expect(looksOf(meshes)).toEqual(looks);
    (await applyHatching(root, 'technical')).dispose();
    expect(looksOf(meshes)).toEqual(looks);
  });

  test('includes changed and added meshes', async () => {
    const { root, meshes, looks } = scene();
    const first = await applyHatching(root, 'technical');
    const other = new SphereGeometry(2, 8, 6);
    meshes[0].geometry = other;
    const third = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    root.add(third);
    const second = await applyHatching(root, { preset: 'technical', replaces: first });
    expect(second.skipped).toEqual([]);
    for (const mesh of [...meshes, third]) expect(mesh.material).toBeInstanceOf(HatchingMaterial);
    expect(meshes[0].geometry).not.toBe(other);
    expect(meshes[0].geometry.boundingSphere!.radius).toBeCloseTo(2);
    second.dispose();
    expect(meshes[0].geometry).toBe(other);
    expect(looksOf(meshes.slice(1))).toEqual(looks.slice(1));
  });

  test('that fails or is aborted leaves the former one unchanged', async () => {
    const { root, meshes, looks } = scene();
    const first = await applyHatching(root, 'technical');
    const before = looksOf(meshes);
    const abort = new AbortController();
    const ready = applyHatching(root, { preset: 'pen', replaces: first, signal: abort.signal });
    abort.abort();
    await expect(ready).rejects.toThrow('abort');
    await expect(applyHatching(root, { replaces: first, creaseAngle: 90 })).rejects.toThrow('creaseAngle');
    expect(looksOf(meshes)).toEqual(before);
    await expect(applyHatching(root)).rejects.toThrow('is hatched already');
    first.dispose();
    expect(looksOf(meshes)).toEqual(looks);
  });

  test('must come from applyHatching', async () => {
    await expect(applyHatching(new Group(), { replaces: {} as never })).rejects.toThrow(
      'applyHatching: replaces must be the result of an earlier call, or left out.',
    );
  });
});

test('restore keeps what was set on a mesh since', async () => {
  const { root, meshes, looks } = scene();
  const hatched = await applyHatching(root, 'technical');
  const geometry = new SphereGeometry(2, 8, 6);
  const material = new MeshBasicMaterial();
  Object.assign(meshes[0], { geometry });
  Object.assign(meshes[1], { material });
  hatched.restore();
  expect(meshes[0].geometry).toBe(geometry);
  expect(meshes[0].material).toBe(looks[0].material);
  expect(meshes[1].geometry).toBe(looks[1].geometry);
  expect(meshes[1].material).toBe(material);
});

test('restore recognises its objects behind proxies, as in Vue', async () => {
  const { root, meshes, looks } = scene();
  const hatched = await applyHatching(root, 'technical');
  const wrapped = reactive(meshes[0]);
  // A proxy that is assigned keeps its target in Vue; other frameworks keep the proxy.
  Object.assign(meshes[0], { geometry: reactive(wrapped.geometry), material: reactive(wrapped.material) });
  hatched.restore();
  expect(looksOf(meshes)).toEqual(looks);
});
