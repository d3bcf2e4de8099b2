import {
  Bone,
  BoxGeometry,
  type BufferGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  TorusGeometry,
  Uint16BufferAttribute,
} from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { geometryPlans, type PlannedMesh } from '../../../src/scene/geometryPlans.js';

const following = { technique: 'engraving', direction: 'form' } as const;
const ring = () => new Mesh(new TorusGeometry(1, 0.4, 8, 16), new MeshStandardMaterial());

const planOf = (mesh: Mesh, material: HatchingMaterial, options: ApplyHatchingOptions = {}) => {
  mesh.updateMatrixWorld();
  const planned: PlannedMesh = { mesh, geometry: mesh.geometry, oldMaterial: mesh.material, material };
  return geometryPlans([planned], options).get(mesh.geometry)!;
};

test('a geometry is baked with a form field only if its material follows the form', async () => {
  const scene = new Group().add(ring(), ring());
  const [first, second] = scene.children as Mesh[];
  await applyHatching(scene, { material: (_, mesh) => (mesh === first ? following : { technique: 'engraving' }) });
  expect([first, second].map((mesh) => mesh.geometry.hasAttribute('formValue'))).toEqual([true, false]);
  expect((scene.children as Mesh[]).map(({ geometry }) => geometry.userData.hatching.direction)).toEqual([
    'form',
    'light',
  ]);
});

test('a geometry that two meshes share has a form field if one of them follows the form', async () => {
  const [first, second] = [ring(), ring()];
  second.geometry = first.geometry;
  const material = (_: unknown, mesh: Mesh) => (mesh === second ? following : { technique: 'engraving' as const });
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
  await applyHatching(scene, { material: { technique: 'engraving', direction: 'auto' } });
  expect((scene.children as Mesh[]).map(({ geometry }) => geometry.hasAttribute('formValue'))).toEqual([true, false]);
});

test('strokes that follow the form need a field too', async () => {
  const scene = new Group().add(ring(), ring());
  const [first, second] = scene.children as Mesh[];
  await applyHatching(scene, { material: (_, mesh) => (mesh === first ? { direction: 'form' } : {}) });
  expect([first, second].map((mesh) => mesh.geometry.hasAttribute('formSlope'))).toEqual([true, false]);
  expect(planOf(ring(), new HatchingMaterial({ direction: 'form' })).form).toMatchObject({
    auto: false,
  });
});

test('the preset engraving follows the form of suitable shapes, and banknote of all', () => {
  const plan = (preset: 'engraving' | 'banknote') => planOf(ring(), new HatchingMaterial({ preset })).form;
  expect(plan('engraving')).toMatchObject({ auto: true, crossAngle: Math.PI / 3 });
  expect(plan('banknote')).toMatchObject({ auto: false, crossAngle: Math.PI / 3 });
});

test('options override both, and may request a field or refuse it', () => {
  const material = new HatchingMaterial({ ...following, crossAngle: 1.2 });
  const form = { up: [0, 0, 1], crossAngle: 0.5, reach: 0.2 } as const;
  expect(planOf(ring(), material, { form }).form).toMatchObject(form);
  expect(planOf(ring(), material, { form: false }).form).toBe(false);
  const plain = new HatchingMaterial({ technique: 'engraving' });
  expect(planOf(ring(), plain).form).toBe(false);
  expect(planOf(ring(), plain, { form: true }).form).toEqual({ auto: false, up: [0, 1, 0] });
  expect(planOf(new Mesh(ring().geometry, new MeshBasicMaterial()), plain).form).toBe(false);
});

describe('meshes whose borders meet', () => {
  const material = new MeshStandardMaterial();
  /** The upper or lower half of a slanted egg shape. */
  const half = (isUpper: boolean): BufferGeometry => {
    const geometry = new SphereGeometry(1, 24, 12, 0, 2 * Math.PI, isUpper ? 0 : Math.PI / 2, Math.PI / 2);
    const { position } = geometry.scale(1, isUpper ? 1.6 : 0.7, 1).attributes;
    for (let i = 0; i < position.count; i++) position.setX(i, position.getX(i) + 0.4 * position.getY(i) ** 2);
    return geometry;
  };
  const formed = (mesh: Mesh) => mesh.geometry.hasAttribute('formValue');

  /** For each vertex of the first mesh's seam its φ, and that of the second mesh at the same place, once per copy of the vertex. */
  const alongSeam = (first: Mesh, second: Mesh): [number, number[]][] => {
    const places = ({ geometry }: Mesh) => {
      const { position, formValue } = geometry.attributes;
      return Array.from({ length: position.count }, (_, i) => i)
        .filter((i) => Math.abs(position.getY(i)) < 1e-6)
        .map((i) => ({ x: position.getX(i), z: position.getZ(i), value: formValue.getX(i) }));
    };
    const others = places(second);
    return places(first).map(({ x, z, value }) => [
      value,
      others.filter((other) => Math.hypot(other.x - x, other.z - z) < 1e-5).map((other) => other.value),
    ]);
  };

  /** Whether lines continue: φ′ = ±φ + j, where j is a multiple of 4. */
  const runsOn = (a: number, b: number): boolean =>
    [b - a, b + a].some((jump) => Math.abs(jump / 4 - Math.round(jump / 4)) < 1e-3);

  const shareOfSeam = (first: Mesh, second: Mesh): number => {
    const seam = alongSeam(first, second);
    expect(seam.length).toBeGreaterThan(23);
    return seam.filter(([value, others]) => others.some((other) => runsOn(value, other))).length / seam.length;
  };

  test('share one field: lines continue from one to the other', async () => {
    const [upper, lower] = [new Mesh(half(true), material), new Mesh(half(false), material)];
    await applyHatching(new Group().add(upper, lower), { material: following });
    expect(shareOfSeam(upper, lower)).toBe(1);
  });

  test('so do skins of one skeleton at rest, wherever their bones are', async () => {
    const [upper, lower] = [true, false].map((isUpper) => {
      const geometry = half(isUpper);
      const { count } = geometry.attributes.position;
      geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
      const weights = Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0));
      geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
      return new SkinnedMesh(geometry, material);
    });
    const bone = new Bone();
    const skeleton = new Skeleton([bone]);
    // In glTF the node of a skinned mesh does not count.
    lower.position.set(5, 0, 0);
    for (const mesh of [upper, lower]) mesh.bind(skeleton, new Matrix4());
    bone.position.set(0, 7, 0);
    await applyHatching(new Group().add(bone, upper, lower), { material: following });
    expect(shareOfSeam(upper, lower)).toBe(1);
  });

  test('but not those of instances, of geometries that meshes share, of other angles, or apart', async () => {
    const instanced = new InstancedMesh(half(false), material, 1);
    instanced.setMatrixAt(0, new Matrix4());
    const twice = half(false);
    const away = new Mesh(half(false), material);
    away.position.y = -0.5;
    const crossed = new Mesh(half(false), material.clone());
    for (const [lower, ...others] of [
      [instanced],
      [new Mesh(twice, material), new Mesh(twice, material)],
      [away],
      [crossed],
    ]) {
      const upper = new Mesh(half(true), material);
      const crossAngle = (mesh: Mesh) => (mesh === crossed ? 1.2 : 1);
      await applyHatching(new Group().add(upper, lower, ...others), {
        material: (_, mesh) => ({ ...following, crossAngle: crossAngle(mesh) }),
      });
      expect([upper, lower].every(formed)).toBe(true);
      expect(shareOfSeam(upper, lower)).toBeLessThan(0.5);
    }
  });

  test.each<[string, (geometry: BufferGeometry) => void]>([
    ['position', ({ attributes }) => attributes.position.setX(30, Number.NaN)],
    ['index', ({ index }) => index!.setX(30, 60_000)],
  ])('one with a faulty %s is skipped, and the other is baked by itself', async (_, spoil) => {
    const [upper, lower] = [new Mesh(half(true), material), new Mesh(half(false), material)];
    spoil(lower.geometry);
    const progress: number[] = [];
    const hatched = applyHatching(new Group().add(upper, lower), {
      material: following,
      onProgress: (value) => progress.push(value),
    });
    expect((await hatched).skipped.map(({ mesh }) => mesh)).toEqual([lower]);
    expect(formed(upper)).toBe(true);
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
  });
});
