import { type BufferGeometry, Group, Mesh, MeshStandardMaterial, TorusGeometry } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import { noteFormAngle } from '../../../src/material/geometry/formAngles.js';
import { isFormExpected } from '../../../src/material/geometry/formGeometry.js';
import { lineContrast } from '../../../src/material/geometry/lineFades.js';
import { outlineDataOf } from '../../../src/material/geometry/OutlineData.js';
import type * as options from '../../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { disposeHatchingWorkers } from '../../../src/worker/runTask.js';

// The threshold of large geometries is some hundred triangles here.
vi.mock('../../../src/material/geometry/PrepareHatchingGeometryOptions.js', async (original) => ({
  ...(await original<typeof options>()),
  MANY_TRIANGLES: 400,
}));

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const following = { technique: 'engraving', direction: 'form' } as const;
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
  expect(isFormed(second)).toBe(true);
});

test('a small mesh that touches a large one follows the form together with it', async () => {
  const [first, second] = [
    new Mesh(new TorusGeometry(1, 0.4, 16, 32, Math.PI), new MeshStandardMaterial()),
    new Mesh(new TorusGeometry(1, 0.4, 16, 8, Math.PI), new MeshStandardMaterial()),
  ];
  second.rotation.z = Math.PI;
  const hatched = await applyHatching(new Group().add(first, second), { material: following });
  expect([first, second].map(isFormed)).toEqual([false, false]);
  expect(await hatched.formReady).toEqual([first, second]);
  // They touch: each has its share of one field, whose lines are equally far apart.
  const longest = [first, second].map(({ geometry }) => (geometry as BufferGeometry).attributes.formSlope.getW(0));
  expect(longest[0]).toBe(longest[1]);
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
  const hatched = await applyHatching(new Group().add(large()), { material: { technique: 'engraving' } });
  expect(await hatched.formReady).toEqual([]);
});

test('lines around the light fade out, those along the form fade in, and each frame of it is asked for', async () => {
  vi.stubGlobal('matchMedia', () => ({ matches: false }));
  // Only the clock of the fade is stopped; the bake continues.
  vi.useFakeTimers({ toFake: ['setTimeout', 'performance'] });
  const mesh = large();
  const seen: { isFormed: boolean; contrast: number }[] = [];
  const invalidate = () => void seen.push({ isFormed: isFormed(mesh), contrast: lineContrast(mesh.geometry) });
  const hatched = await applyHatching(new Group().add(mesh), { material: following, invalidate });
  let isReady = false;
  void hatched.formReady.then(() => {
    isReady = true;
  });
  while (!isReady) await vi.advanceTimersByTimeAsync(16);
  const contrasts = (formed: boolean) => seen.filter((one) => one.isFormed === formed).map(({ contrast }) => contrast);
  for (const [formed, order] of [
    [false, -1],
    [true, 1],
  ] as const) {
    expect(contrasts(formed)).toEqual(contrasts(formed).toSorted((a, b) => order * (a - b)));
    expect(contrasts(formed).length).toBeGreaterThan(10);
  }
  expect(contrasts(false)[0]).toBe(1);
  expect(contrasts(true).at(-1)).toBe(1);
});

test('the progress of what comes later is told, up to 1', async () => {
  const progress: number[] = [];
  const onFormProgress = (share: number) => void progress.push(share);
  const hatched = await applyHatching(new Group().add(large()), { material: following, onFormProgress });
  await hatched.formReady;
  expect(progress.at(-1)).toBe(1);
  expect(progress).toEqual(progress.toSorted((a, b) => a - b));
});

test('a signal that is aborted later stops the bake, and lines go by the light', async () => {
  const stopping = new AbortController();
  const mesh = large();
  const hatched = await applyHatching(new Group().add(mesh), { material: following, signal: stopping.signal });
  stopping.abort();
  expect(await hatched.formReady).toEqual([]);
  expect(isFormed(mesh)).toBe(false);
});

/** The calls of a frame. */
const draw = (mesh: Mesh): void => noteFormAngle(mesh.geometry, mesh.material as unknown as HatchingMaterial);

/** The values of φ, or of φ₂, by position. */
function valuesOf({ attributes: { position, formValue } }: BufferGeometry, family: 0 | 1): Map<string, Set<number>> {
  const values = new Map<string, Set<number>>();
  for (let vertex = 0; vertex < position.count; vertex++) {
    const place = [position.getX(vertex), position.getY(vertex), position.getZ(vertex)].join();
    values.set(place, (values.get(place) ?? new Set()).add(formValue.getComponent(vertex, family)));
  }
  return values;
}

test.each([
  ['small', small],
  ['large', large],
])('lines of a %s mesh cross at a new angle as soon as they are baked at it', async (_, make) => {
  const mesh = make();
  const invalidate = vi.fn();
  const hatched = await applyHatching(new Group().add(mesh), { material: following, invalidate });
  await hatched.formReady;
  const before = mesh.geometry as BufferGeometry;
  invalidate.mockClear();
  for (const angle of [1.2, 1.3, 1.4]) {
    hatched.materials[0].crossAngle = angle;
    draw(mesh);
    expect(mesh.geometry).toBe(before);
  }
  expect(await hatched.formReady).toEqual([mesh]);
  expect(invalidate).toHaveBeenCalled();
  const after = mesh.geometry as BufferGeometry;
  expect(valuesOf(after, 0)).toEqual(valuesOf(before, 0));
  const other = make();
  await (await applyHatching(new Group().add(other), { material: { ...following, crossAngle: 1.4 } })).formReady;
  expect(after.attributes.formValue.array).toEqual((other.geometry as BufferGeometry).attributes.formValue.array);
  draw(mesh);
  await hatched.formReady;
  expect(mesh.geometry).toBe(after);
});

test('lines that run on from mesh to mesh do so at the new angle', async () => {
  const meshes = [0, 1].map((half) => {
    const mesh = new Mesh(new TorusGeometry(1, 0.4, 8, 8, Math.PI), new MeshStandardMaterial());
    mesh.rotation.z = half * Math.PI;
    return mesh;
  });
  const scene = new Group().add(...meshes);
  const joint = async (crossAngle: number) => {
    const hatched = await applyHatching(scene, { material: { ...following, crossAngle } });
    return { hatched, values: meshes.map(({ geometry }) => (geometry as BufferGeometry).attributes.formValue.array) };
  };
  const { hatched: first, values: wanted } = await joint(1.4);
  first.dispose();
  const { hatched, values } = await joint(1.1);
  expect(values).not.toEqual(wanted);
  for (const material of hatched.materials) material.crossAngle = 1.4;
  for (const mesh of meshes) draw(mesh);
  expect(await hatched.formReady).toEqual(meshes);
  expect(meshes.map(({ geometry }) => (geometry as BufferGeometry).attributes.formValue.array)).toEqual(wanted);
});

test('an option that says the angle holds, whatever the material says', async () => {
  const mesh = small();
  const hatched = await applyHatching(new Group().add(mesh), { material: following, form: { crossAngle: 1 } });
  const { geometry } = mesh;
  hatched.materials[0].crossAngle = 1.2;
  draw(mesh);
  expect(await hatched.formReady).toEqual([]);
  expect(mesh.geometry).toBe(geometry);
});

test('if the workers are disposed of meanwhile, lines go by the light, and the console says it in one sentence', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const mesh = large();
  const hatched = await applyHatching(new Group().add(mesh), {
    material: following,
    onFormProgress: () => disposeHatchingWorkers(),
  });
  expect(await hatched.formReady).toEqual([]);
  expect(isFormed(mesh)).toBe(false);
  expect(warn).toHaveBeenCalledOnce();
  expect(warn.mock.calls[0].join()).toContain('lines go by the light');
  warn.mockRestore();
});
