import { BoxGeometry, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, TorusGeometry } from 'three';
import { expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { geometryPlans, type PlannedMesh } from '../../../src/scene/geometryPlans.js';

const following = { technique: 'engraved', lineField: 'form' } as const;
const ring = () => new Mesh(new TorusGeometry(1, 0.4, 8, 16), new MeshStandardMaterial());

const planOf = (mesh: Mesh, material: HatchingMaterial, options: ApplyHatchingOptions = {}) => {
  mesh.updateMatrixWorld();
  const planned: PlannedMesh = { mesh, geometry: mesh.geometry, oldMaterial: mesh.material, material };
  return geometryPlans([planned], options).get(mesh.geometry)!;
};

test('a geometry is baked with a form field where its material follows the form, and only there', async () => {
  const scene = new Group().add(ring(), ring());
  const [first, second] = scene.children as Mesh[];
  await applyHatching(scene, { material: (_, mesh) => (mesh === first ? following : { technique: 'engraved' }) });
  expect([first, second].map((mesh) => mesh.geometry.hasAttribute('formValue'))).toEqual([true, false]);
  expect((scene.children as Mesh[]).map(({ geometry }) => geometry.userData.hatching.lineField)).toEqual([
    'form',
    'light',
  ]);
});

test('a geometry that two meshes share has a form field if one of them follows the form', async () => {
  const [first, second] = [ring(), ring()];
  second.geometry = first.geometry;
  const material = (_: unknown, mesh: Mesh) => (mesh === second ? following : { technique: 'engraved' as const });
  await applyHatching(new Group().add(first, second), { material });
  expect(first.geometry).toBe(second.geometry);
  expect(first.geometry.hasAttribute('formValue')).toBe(true);
});

test('lines cross at the angle of the material, and run across the up of the world', () => {
  const mesh = ring();
  mesh.rotation.z = Math.PI / 2;
  mesh.scale.setScalar(2);
  const material = new HatchingMaterial({ ...following, crossAngle: 1.2 });
  expect(planOf(mesh, material).form).toEqual({
    auto: false,
    crossAngle: 1.2,
    up: [expect.closeTo(2), expect.closeTo(0), expect.closeTo(0)],
  });
});

test('with auto, a shape that has a form is baked with it, and one of flat faces without', async () => {
  const scene = new Group().add(ring(), new Mesh(new BoxGeometry(1, 1, 1, 4, 4, 4), new MeshStandardMaterial()));
  await applyHatching(scene, { material: { technique: 'engraved', lineField: 'auto' } });
  expect((scene.children as Mesh[]).map(({ geometry }) => geometry.hasAttribute('formValue'))).toEqual([true, false]);
});

test('strokes that follow the form ask for a field too', async () => {
  const scene = new Group().add(ring(), ring());
  const [first, second] = scene.children as Mesh[];
  await applyHatching(scene, { material: (_, mesh) => (mesh === first ? { strokeField: 'form' } : {}) });
  expect([first, second].map((mesh) => mesh.geometry.hasAttribute('formSlope'))).toEqual([true, false]);
  expect(planOf(ring(), new HatchingMaterial({ strokeField: 'form', lineField: 'auto' })).form).toMatchObject({
    auto: false,
  });
});

test('the preset engraving leaves it to the shape, and banknote follows the form of all', () => {
  const plan = (preset: 'engraving' | 'banknote') => planOf(ring(), new HatchingMaterial({ preset })).form;
  expect(plan('engraving')).toMatchObject({ auto: true, crossAngle: Math.PI / 3 });
  expect(plan('banknote')).toMatchObject({ auto: false, crossAngle: Math.PI / 3 });
});

test('options override both, and may ask for a field or refuse it', () => {
  const material = new HatchingMaterial({ ...following, crossAngle: 1.2 });
  const form = { up: [0, 0, 1], crossAngle: 0.5, reach: 0.2 } as const;
  expect(planOf(ring(), material, { form }).form).toMatchObject(form);
  expect(planOf(ring(), material, { form: false }).form).toBe(false);
  const plain = new HatchingMaterial({ technique: 'engraved' });
  expect(planOf(ring(), plain).form).toBe(false);
  expect(planOf(ring(), plain, { form: true }).form).toEqual({ auto: false, up: [0, 1, 0] });
  expect(planOf(new Mesh(ring().geometry, new MeshBasicMaterial()), plain).form).toBe(false);
});
