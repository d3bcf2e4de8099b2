import {
  BatchedMesh,
  BoxGeometry,
  type BufferGeometry,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  RawShaderMaterial,
  ShaderMaterial,
  SphereGeometry,
  WebGLRenderTarget,
} from 'three';
import { expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';

const options = { tonalArtMap: null, material: { technique: 'hatching' } } as const;

class MirrorMaterial extends MeshStandardMaterial {
  override onBeforeCompile(): void {}
}

const withHook = (): Material => Object.assign(new MeshBasicMaterial(), { onBeforeCompile: () => {} });
const withTarget = (): Material => new MeshBasicMaterial({ map: new WebGLRenderTarget(4, 4).texture });
/** A material derived as in troika's text: its prototype is the original material. */
const derived = (): Material => Object.create(new MeshBasicMaterial(), { onBeforeCompile: { value: () => {} } });

const kept: [what: string, make: () => Material, why: string][] = [
  ['a shader of its own', () => new ShaderMaterial(), 'its material has a shader of its own'],
  ['a raw shader', () => new RawShaderMaterial(), 'its material has a shader of its own'],
  ['a hook', withHook, 'its material changes its shader in onBeforeCompile'],
  ['a hook of its class', () => new MirrorMaterial(), 'its material changes its shader in onBeforeCompile'],
  ['a hook over another material', derived, 'its material changes its shader in onBeforeCompile'],
  ['a render target', withTarget, 'its material shows a render target'],
];

const crate = (): Mesh<BufferGeometry, Material> =>
  Object.assign(new Mesh<BufferGeometry, Material>(new BoxGeometry(), new MeshStandardMaterial()), { name: 'crate' });

test.each(kept)('a mesh whose material has %s is left alone, and listed with the reason', async (_what, make, why) => {
  const helper = Object.assign(new Mesh(new PlaneGeometry(), make()), { name: 'helper' });
  const [geometry, material] = [helper.geometry, helper.material];
  const hatched = await applyHatching(new Group().add(crate(), helper), options);
  expect([helper.geometry, helper.material]).toEqual([geometry, material]);
  expect(hatched.materials).toHaveLength(1);
  expect(hatched.skipped).toEqual([
    { mesh: helper, reason: `The Mesh "helper" at Group/helper is left alone: ${why}.` },
  ]);
});

test('userData.hatching false leaves a mesh and its descendants alone, and true hatches them whatever the material', async () => {
  const [inside, wanted, other] = [crate(), crate(), crate()];
  wanted.material = new ShaderMaterial();
  wanted.userData.hatching = true;
  const kept = new Group().add(inside, wanted);
  kept.userData.hatching = false;
  const { skipped } = await applyHatching(new Group().add(kept, other), options);
  expect(skipped.map(({ mesh, reason }) => [mesh, reason])).toEqual([
    [inside, 'The Mesh "crate" at Group/Group[0]/crate is left alone: userData.hatching is false, here or above.'],
  ]);
  expect(inside.material).toBeInstanceOf(MeshStandardMaterial);
  for (const mesh of [wanted, other]) expect(mesh.material).toBeInstanceOf(HatchingMaterial);
});

test('among several materials those with their own shader stay', async () => {
  const glow = new ShaderMaterial();
  const mesh = new Mesh(new BoxGeometry(), [new MeshBasicMaterial(), glow]);
  const { skipped, materials } = await applyHatching(mesh, options);
  expect([mesh.material, skipped]).toEqual([[materials[0], glow], []]);
});

test('a scene in which every mesh is left alone gives an empty result and one sentence, with the reasons', async () => {
  const warnings = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const helpers = Array.from({ length: 5 }, () => new Mesh(new PlaneGeometry(), new ShaderMaterial()));
  const { materials, skipped } = await applyHatching(new Group().add(...helpers), options);
  expect([materials, skipped.map(({ mesh }) => mesh)]).toEqual([[], helpers]);
  expect(warnings.mock.calls).toEqual([
    [
      expect.stringMatching(
        /^applyHatching: nothing is left to hatch\. The Mesh at Group\/Mesh\[0\] is left alone: its material has a shader of its own\. .* So are 2 more meshes\. Set userData\.hatching to true/,
      ),
    ],
  ]);
  warnings.mockRestore();
});

test('another call hatches added meshes, with strokes of the same size', async () => {
  const first = new Mesh<BufferGeometry, Material>(new SphereGeometry(4, 8, 6), new MeshBasicMaterial());
  const root = new Group().add(first);
  const before = await applyHatching(root, options);
  const { material } = first;
  const added = crate();
  root.add(added);
  const after = await applyHatching(root, options);
  expect(first.material).toBe(material);
  expect(after.materials).toEqual([added.material]);
  expect(after.materials[0].tilesPerObjectUnit).toBeCloseTo(before.materials[0].tilesPerObjectUnit);
  expect(after.skipped).toEqual([
    { mesh: first, reason: 'The Mesh at Group/Mesh[0] is hatched already, or is being hatched.' },
  ]);
  after.dispose();
  expect([first.material, added.material.type]).toEqual([material, 'MeshStandardMaterial']);
});

test('values out of range that three.js accepts are clamped, with one warning', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const odd = () =>
    new Mesh(
      new BoxGeometry(),
      new MeshStandardMaterial({ name: 'lamp', emissiveIntensity: -1, aoMapIntensity: Number.NaN }),
    );
  const { materials } = await applyHatching(new Group().add(odd(), odd()), options);
  expect(materials.map(({ emissiveIntensity, aoMapIntensity }) => [emissiveIntensity, aoMapIntensity])).toEqual([
    [0, 1],
    [0, 1],
  ]);
  expect(warn.mock.calls).toEqual([
    ['applyHatching: aoMapIntensity is NaN on the MeshStandardMaterial "lamp", and is hatched as 1.'],
    ['applyHatching: emissiveIntensity is -1 on the MeshStandardMaterial "lamp", and is hatched as 0.'],
  ]);
  warn.mockRestore();
});

test('a batch causes one warning that it has no outlines', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  for (let i = 0; i < 2; i++) {
    const batch = new BatchedMesh(1, 24, 36, new MeshBasicMaterial());
    batch.name = 'bricks';
    batch.addInstance(batch.addGeometry(new BoxGeometry()));
    const { skipped, outlines } = await applyHatching(batch, { ...options, outlines: true });
    expect(outlines).toEqual([]);
    expect(skipped).toEqual([
      { mesh: batch, reason: 'The BatchedMesh "bricks" is hatched without outlines: a BatchedMesh has none.' },
    ]);
  }
  expect(warn.mock.calls).toEqual([
    [expect.stringContaining('the BatchedMesh "bricks" is hatched without outlines, since a BatchedMesh has none.')],
  ]);
  warn.mockRestore();
});
