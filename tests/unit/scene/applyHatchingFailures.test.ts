import {
  BoxGeometry,
  BufferGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Object3D,
  PlaneGeometry,
  SphereGeometry,
} from 'three';
import { describe, expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { reactive } from '../material/geometry/reactive.js';
import { hatched, looksOf, tonalArtMap } from './hatchedScenes.js';

function brokenMesh(): Mesh {
  const mesh = new Mesh(new PlaneGeometry(), new MeshBasicMaterial());
  mesh.name = 'torn';
  mesh.geometry.attributes.position.array[0] = Number.NaN;
  return mesh;
}

describe('errors', () => {
  test.each([
    [
      { layot: 'pull' },
      'unknown option "layot". The known ones are tonalArtMap, material, tilesPerWorldUnit, detail, filter, onGeometry, onFormProgress, invalidate, preset, shadow, renderer, camera, adjacency, ',
    ],
    [null, 'the options are null. Pass an object'],
    [{ signal: 'now' }, 'signal is now, but must be an AbortSignal'],
  ])('options %o are refused, and the scene can be hatched', async (options, message) => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    await expect(applyHatching(mesh, options as never)).rejects.toThrow(`applyHatching: ${message}`);
    await applyHatching(mesh, { tonalArtMap, weldTolerance: 0 });
    hatched(mesh);
  });

  test('what is hatched, or being hatched, by another call is left to it', async () => {
    const warnings = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    mesh.name = 'crate';
    const root = new Group().add(mesh);
    const first = applyHatching(mesh, { tonalArtMap });
    const { skipped, materials } = await applyHatching(root, { tonalArtMap });
    const reason = 'The Mesh "crate" at Group/crate is hatched already, or is being hatched.';
    expect([skipped, materials]).toEqual([[{ mesh, reason }], []]);
    expect(warnings.mock.calls).toEqual([
      [
        `applyHatching: nothing is left to hatch. ${reason} Call update() or setPreset() of the result of the first call, or dispose() of it before.`,
      ],
    ]);
    const during = (await first).materials[0];
    expect((await applyHatching(root, { tonalArtMap })).materials).toEqual([]);
    expect(mesh.material).toBe(during);
    warnings.mockRestore();
  });

  test("a scene that is mounted, unmounted and mounted again in one tick, as in React's StrictMode, is hatched", async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const original = mesh.material;
    const mount = () => {
      const controller = new AbortController();
      const scene = applyHatching(mesh, { tonalArtMap, signal: controller.signal });
      return { scene, unmount: () => controller.abort(new Error('unmounted')) };
    };
    const first = mount();
    first.unmount();
    const second = mount();
    await expect(first.scene).rejects.toThrow('unmounted');
    const scene = await second.scene;
    expect(hatched(mesh)).toBe(scene.materials[0]);
    // An abort after the end changes nothing.
    second.unmount();
    expect(hatched(mesh)).toBe(scene.materials[0]);
    scene.dispose();
    expect(mesh.material).toBe(original);
  });

  test('a mesh and its proxy, as by ref of Vue, are one mesh', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const scene = await applyHatching(reactive(mesh), { tonalArtMap });
    hatched(mesh);
    expect(scene.materialOf(mesh) === (mesh.material as unknown)).toBe(true);
    vi.spyOn(console, 'warn').mockImplementationOnce(() => {});
    expect((await applyHatching(mesh, { tonalArtMap })).materials).toEqual([]);
    scene.dispose();
    (await applyHatching(mesh, { tonalArtMap })).dispose();
  });

  test('a broken mesh stays as it is and is named; the others are hatched', async () => {
    const torn = brokenMesh();
    const bare = new Mesh(new BufferGeometry(), torn.material);
    const sound = new Mesh(new BoxGeometry(), torn.material);
    const root = new Group().add(torn, bare, sound);
    const [geometry, material] = [torn.geometry, torn.material];
    const { skipped, materials } = await applyHatching(root, { tonalArtMap });
    expect(materials).toEqual([sound.material]);
    hatched(sound);
    expect([torn.geometry, torn.material, bare.material]).toEqual([geometry, material, material]);
    expect(skipped.map(({ mesh }) => mesh)).toEqual([torn, bare]);
    expect(skipped.map(({ error }) => error?.message)).toEqual([
      expect.stringContaining('must be finite'),
      expect.stringContaining('has no attribute "position"'),
    ]);
  });

  test('a mesh that is changed during the call keeps the change', async () => {
    const [changed, kept] = [1, 2].map(() => new Mesh(new BoxGeometry(), new MeshBasicMaterial())) as unknown as [
      Mesh,
      Mesh,
    ];
    const replacement = new MeshStandardMaterial();
    const onProgress = () => {
      changed.material = replacement;
    };
    const { skipped } = await applyHatching(new Group().add(changed, kept), { tonalArtMap, onProgress });
    expect(changed.material).toBe(replacement);
    expect(skipped.map(({ mesh }) => mesh)).toEqual([changed]);
    expect(skipped[0].error?.message).toContain('while it was being baked');
    hatched(kept);
  });

  /** Every way to fail half-way: the scene is unchanged, new objects are freed, and it can be hatched afterwards. */
  const failures: [how: string, options: (abort: AbortController) => ApplyHatchingOptions, says: RegExp][] = [
    [
      'aborted',
      (abort) => ({ signal: abort.signal, onProgress: (value) => value > 0.55 && abort.abort(new Error('enough')) }),
      /enough/,
    ],
    [
      'its listener throws',
      () => {
        let told = 0;
        return {
          // Only once: a later draw must not hide the failure.
          onProgress: (value) => {
            if (value > 0.55 && told++ === 0) throw new TypeError('listener');
          },
        };
      },
      /listener/,
    ],
    ['a wrong parameter', () => ({ material: { technique: 'magic' as 'hatching' } }), /"magic" is not known/],
    ['a wrong option', () => ({ creaseAngle: 90 }), /creaseAngle is 90/],
  ];
  test.each(failures)('%s: the scene is unchanged', async (_how, optionsOf, says) => {
    const meshes = [1, 2, 3].map((n) => new Mesh(new SphereGeometry(n, 32, 16), new MeshStandardMaterial()));
    const root = new Group().add(...meshes);
    const before = looksOf(root);
    const disposed = vi.spyOn(HatchingMaterial.prototype, 'dispose');
    const freed = vi.spyOn(BufferGeometry.prototype, 'dispose');
    await expect(applyHatching(root, { tonalArtMap, ...optionsOf(new AbortController()) })).rejects.toThrow(says);
    const [materials, geometries] = [disposed.mock.calls.length, freed.mock.calls.length];
    vi.restoreAllMocks();
    for (const [i, part] of looksOf(root).entries()) expect(part).toBe(before[i]);
    if (says.test('enough listener')) {
      expect(materials).toBe(3);
      expect(geometries).toBeGreaterThan(0);
    }
    (await applyHatching(root, { tonalArtMap })).restore();
  });

  const misuses: [what: string, options: unknown, says: RegExp][] = [
    ['null', null, /^applyHatching: the options are null\. Pass an object/],
    ['a map in its place', 5, /^applyHatching: the options are 5/],
    [
      'a signal that is none',
      { signal: new AbortController() },
      /^applyHatching: signal is .*, but must be an AbortSignal/,
    ],
    ['a word for a signal', { signal: 'stop' }, /^applyHatching: signal is .*, but must be an AbortSignal/],
    ['a listener that is none', { onProgress: true }, /^applyHatching: onProgress is true, but must be a function/],
    [
      'a worker for its maker',
      { createWorker: {} },
      /^applyHatching: createWorker is an object .*, but must be a function/,
    ],
    ['a filter that is none', { filter: 'crate' }, /^applyHatching: filter must be a function/],
    ['a detail without an address', { detail: true }, /^applyHatching: detail must be an object whose simplifier/],
    [
      'a detail with an empty address',
      { detail: { simplifier: '' } },
      /^applyHatching: detail must be an object whose simplifier/,
    ],
    ['a material of null', { material: null }, /^applyHatching: material must be an object/],
    [
      'a size that is no number',
      { tilesPerWorldUnit: Number.NaN },
      /^applyHatching: tilesPerWorldUnit is NaN, but must be a positive/,
    ],
    ['a camera without a renderer', { camera: new Object3D() }, /^applyHatching: renderer must be a WebGLRenderer/],
    ['a renderer that is none', { renderer: {}, camera: new Object3D() }, /^applyHatching: renderer must be/],
    ['a map that is none', { tonalArtMap: 5 }, /tonalArtMap: 5 is no TonalArtMap/],
  ];
  test.each(misuses)('wrong options throw at once, and claim nothing: %s', async (_what, options, says) => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const error = await applyHatching(mesh, options as object).catch((reason) => reason);
    expect(error.message).toMatch(says);
    expect([TypeError, RangeError]).toContain(error.constructor);
    (await applyHatching(mesh, { tonalArtMap })).dispose();
  });

  test('a scene of broken meshes only rejects with the fault, and a value that is no scene with the remedy', async () => {
    await expect(applyHatching(brokenMesh(), { tonalArtMap })).rejects.toThrow(/must be finite/);
    await expect(applyHatching({ scene: new Group() } as unknown as Group)).rejects.toThrow(/pass gltf\.scene/);
    expect((await applyHatching(new Group())).materials).toEqual([]);
  });
});
