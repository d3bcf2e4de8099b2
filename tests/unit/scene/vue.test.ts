import { reactive, ref, shallowRef, toRaw } from '@vue/reactivity';
import { BoxGeometry, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { reactive as asInTheTests } from '../material/geometry/reactive.js';

/** With Vue itself; the other tests use a proxy like Vue's. */

const map = TonalArtMap.fromHatchImages({ size: 4, images: [255, 128, 0].map((v) => [new Uint8Array(16).fill(v)]) });

test('a scene in a ref is hatched and restored, by proxy or directly', async () => {
  const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
  const { geometry, material } = mesh;
  const root = ref(new Group().add(mesh));
  const state = reactive<{ hatched?: Awaited<ReturnType<typeof applyHatching>> }>({});
  state.hatched = (await applyHatching(root.value as unknown as Group, 'technical')) as never;
  expect(toRaw(mesh.material)).toBeInstanceOf(HatchingMaterial);
  const next = await (state.hatched as unknown as Awaited<ReturnType<typeof applyHatching>>).setPreset('engraving');
  expect(toRaw(mesh.material)).toBe(toRaw(next.materials[0]));
  (reactive(next) as unknown as typeof next).dispose();
  expect([toRaw(mesh.geometry), toRaw(mesh.material)]).toEqual([geometry, material]);
  expect(toRaw(mesh.geometry)).toBe(geometry);
});

test('a material in a ref takes values, keeps them, and draws with the map itself', () => {
  const held = ref(new HatchingMaterial({ technique: 'hatching' }));
  const material = held.value as unknown as HatchingMaterial;
  material.tonalArtMap = reactive({ map }).map as unknown as TonalArtMap;
  material.ink.set('#123456');
  material.strokeAngle = 0.5;
  material.toneCurve = reactive([
    [0, 0],
    [1, 1],
  ]) as unknown as [number, number][];
  const itself = toRaw(held.value) as unknown as HatchingMaterial;
  expect([itself.ink.getHexString(), itself.strokeAngle]).toEqual(['123456', 0.5]);
  expect(toRaw(itself.tonalArtMap)).toBe(map);
  expect(material.clone().strokeAngle).toBe(0.5);
  expect(HatchingMaterial.fromJSON(JSON.parse(JSON.stringify(material.toJSON()))).strokeAngle).toBe(0.5);
  expect(() => material.setValues({ side: 2 })).not.toThrow();
  shallowRef(material).value.dispose();
});

test('a geometry in a ref is prepared', async () => {
  const held = ref(new SphereGeometry(1, 8, 6));
  const prepared = await prepareHatchingGeometry(held.value as unknown as SphereGeometry, { outlines: true });
  expect(prepared.userData.hatching.triangles).toBe(80);
});

test("the proxy of the tests behaves like Vue's", () => {
  for (const wrap of [reactive, asInTheTests]) {
    const target = { inner: { value: 1 }, list: [{}], method() {}, made: new Map(), buffer: new Float32Array(1) };
    const proxy = wrap(target as object) as typeof target;
    expect(proxy).not.toBe(target);
    expect(proxy.inner).not.toBe(target.inner);
    expect(proxy.inner).toBe(proxy.inner);
    expect(proxy.list[0]).not.toBe(target.list[0]);
    expect(proxy.method).toBe(target.method);
    expect(proxy.buffer).toBe(target.buffer);
    const other = { value: 2 };
    proxy.inner = wrap(other as object) as typeof other;
    expect(target.inner).toBe(other);
  }
});
