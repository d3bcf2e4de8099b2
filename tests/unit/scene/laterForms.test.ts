import { type BufferGeometry, Group, Mesh, MeshStandardMaterial, TorusGeometry } from 'three';
import { expect, test, vi } from 'vitest';
import { isFormExpected } from '../../../src/geometry/formGeometry.js';
import { outlineDataOf } from '../../../src/geometry/OutlineData.js';
import type * as preparing from '../../../src/geometry/prepareHatchingGeometry.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';

// What counts as large is some hundred triangles here.
vi.mock('../../../src/geometry/prepareHatchingGeometry.js', async (original) => ({
  ...(await original<typeof preparing>()),
  MANY_TRIANGLES: 400,
}));

const following = { technique: 'engraved', lineField: 'form' } as const;
const small = () => new Mesh(new TorusGeometry(1, 0.4, 8, 16), new MeshStandardMaterial());
const large = () => new Mesh(new TorusGeometry(1, 0.4, 16, 32), new MeshStandardMaterial());
const isFormed = ({ geometry }: Mesh<BufferGeometry>): boolean => geometry.hasAttribute('formValue');

test('a large mesh is drawn by the light until its field is there, with its outlines, and a small one follows the form at once', async () => {
  const [first, second, sharing] = [small(), large(), large()];
  sharing.geometry = second.geometry;
  const hatched = await applyHatching(new Group().add(first, second, sharing), { material: following, outlines: true });
  expect([first, second, sharing].map(isFormed)).toEqual([true, false, false]);
  expect(isFormExpected(second.geometry), 'no mistake').toBe(true);
  const freed = vi.fn();
  second.geometry.addEventListener('dispose', freed);
  expect(await hatched.formReady).toEqual([second, sharing]);
  expect([first, second, sharing].map(isFormed)).toEqual([true, true, true]);
  expect(second.geometry).toBe(sharing.geometry);
  expect(outlineDataOf(second.geometry)).toBeDefined();
  expect(freed).toHaveBeenCalledOnce();
  hatched.follow();
  expect(isFormed(second)).toBe(true);
});

test('restore() puts the former geometry back after the change, and stops the bake before it', async () => {
  const mesh = large();
  const { geometry } = mesh;
  const scene = new Group().add(mesh);
  const hatched = await applyHatching(scene, { material: following });
  await hatched.formReady;
  const freed = vi.fn();
  (mesh.geometry as BufferGeometry).addEventListener('dispose', freed);
  hatched.dispose();
  expect(mesh.geometry).toBe(geometry);
  expect(freed).toHaveBeenCalledOnce();
  const again = await applyHatching(scene, { material: following });
  again.restore();
  expect(await again.formReady).toEqual([]);
  expect(mesh.geometry).toBe(geometry);
});

test('a mesh that was given another geometry meanwhile keeps it', async () => {
  const mesh = large();
  const hatched = await applyHatching(new Group().add(mesh), { material: following });
  const other = new TorusGeometry();
  mesh.geometry = other;
  expect(await hatched.formReady).toEqual([]);
  expect(mesh.geometry).toBe(other);
});

test('hollows that were darkened meanwhile stay dark', async () => {
  const mesh = large();
  const hatched = await applyHatching(new Group().add(mesh), { material: following });
  const { hatchNormal } = (mesh.geometry as BufferGeometry).attributes;
  // As `bakeOcclusion` writes it.
  for (let vertex = 0; vertex < hatchNormal.count; vertex++) hatchNormal.setW(vertex, -vertex / hatchNormal.count);
  const cornersOf = ({ index, attributes }: BufferGeometry): number[] =>
    Array.from({ length: index!.count }, (_, corner) => attributes.hatchNormal.getW(index!.getX(corner)));
  const before = cornersOf(mesh.geometry);
  expect(await hatched.formReady).toEqual([mesh]);
  expect(cornersOf(mesh.geometry)).toEqual(before);
});

test('if the field cannot be baked, lines go by the light, and the console says why', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const mesh = large();
  const spoil = (): void => void mesh.geometry.getAttribute('position').setX(0, Number.NaN);
  const hatched = await applyHatching(new Group().add(mesh), { material: following, onGeometry: spoil });
  expect(await hatched.formReady).toEqual([]);
  expect(isFormed(mesh)).toBe(false);
  expect(warn.mock.calls.flat().join()).toContain('lines go by the light');
  warn.mockRestore();
});

test('where lines follow the light there is nothing to wait for', async () => {
  const hatched = await applyHatching(new Group().add(large()), { material: { technique: 'engraved' } });
  expect(await hatched.formReady).toEqual([]);
});
