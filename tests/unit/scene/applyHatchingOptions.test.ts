import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
} from 'three';
import { describe, expect, test, vi } from 'vitest';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { disposals, hatched, tonalArtMap } from './hatchedScenes.js';

describe('options', () => {
  test('parameters override what is copied; a function is called once for every new material', async () => {
    const [a, b] = [new MeshBasicMaterial({ color: 'red' }), new MeshBasicMaterial({ color: 'green' })];
    const box = new BoxGeometry();
    const meshes = [new Mesh(box, a), new Mesh(box, b), new Mesh(box, a)];
    const material = vi.fn((source: Material) => ({
      ink: 'navy',
      side: DoubleSide,
      ...(source === a ? { color: 'white' } : {}),
    }));
    await applyHatching(new Group().add(...meshes), { tonalArtMap, material });
    expect(material.mock.calls).toEqual([
      [a, meshes[0]],
      [b, meshes[1]],
    ]);
    expect(hatched(meshes[0]).color.getHexString()).toBe('ffffff');
    expect(hatched(meshes[1]).color.getHexString()).toBe(new Color('green').getHexString());
    expect(hatched(meshes[1]).ink.equals(new Color('navy'))).toBe(true);
    expect(hatched(meshes[1]).side).toBe(DoubleSide);
  });

  test('strokes have one size in the world: three tiles over the radius of the whole', async () => {
    const paint = new MeshBasicMaterial();
    const [small, large, alike] = [0.5, 2, 0.5].map((scale) => {
      const mesh = new Mesh(new SphereGeometry(1, 64, 32), paint);
      mesh.scale.set(-scale, scale, scale);
      return mesh;
    }) as unknown as [Mesh, Mesh, Mesh];
    alike.rotation.set(1, 2, 3);
    const instanced = new InstancedMesh(new SphereGeometry(1), paint, 2);
    for (const i of [0, 1]) instanced.setMatrixAt(i, new Matrix4().makeScale(0.25, 0.25, 0.25));
    const root = new Group().add(small, new Group().add(large), alike, instanced);
    root.scale.setScalar(10);
    const scene = await applyHatching(root, { tonalArtMap });
    const perWorldUnit = 3 / 20;
    expect(hatched(small).tilesPerObjectUnit).toBeCloseTo(perWorldUnit * 5, 6);
    expect(hatched(large).tilesPerObjectUnit).toBeCloseTo(perWorldUnit * 20, 6);
    expect(hatched(instanced).tilesPerObjectUnit).toBeCloseTo(perWorldUnit * 2.5, 6);
    expect(alike.material).toBe(small.material);
    expect(scene.materials).toHaveLength(3);
    scene.dispose();
    await applyHatching(root, {
      tonalArtMap,
      tilesPerWorldUnit: 2,
      material: (_, mesh) => (mesh === large ? { tilesPerObjectUnit: 7 } : {}),
    });
    expect(hatched(small).tilesPerObjectUnit).toBeCloseTo(10, 6);
    expect(hatched(large).tilesPerObjectUnit).toBe(7);
  });

  test('the size of a skinned mesh is that of its bones, wherever its node stands', async () => {
    const geometry = new SphereGeometry(1, 64, 32);
    const count = geometry.attributes.position.count;
    geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(4 * count), 4));
    geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array(4 * count).fill(0.25), 4));
    const skinned = new SkinnedMesh(geometry, new MeshBasicMaterial());
    const bone = new Bone();
    bone.scale.setScalar(4);
    const root = new Group().add(bone, skinned);
    skinned.bind(new Skeleton([bone], [new Matrix4()]), new Matrix4());
    skinned.scale.setScalar(100);
    await applyHatching(root, { tonalArtMap, tilesPerWorldUnit: 1 });
    expect(hatched(skinned).tilesPerObjectUnit).toBeCloseTo(4, 6);
  });

  test('a filter leaves meshes out, and crease angle and progress reach the bake', async () => {
    const meshes = [1, 2, 3].map((n) => new Mesh(new BoxGeometry(n), new MeshBasicMaterial()));
    const progress: number[] = [];
    const { materials } = await applyHatching(new Group().add(...meshes), {
      tonalArtMap,
      filter: (mesh) => mesh !== meshes[1],
      onProgress: (value) => progress.push(value),
    });
    expect(materials).toHaveLength(2);
    expect(meshes[1].material).toBeInstanceOf(MeshBasicMaterial);
    expect(progress.at(-1)).toBe(1);
    expect([...progress].sort((a, b) => a - b)).toEqual(progress);
  });

  test('without a map the shared map of the style is used, and never freed', async () => {
    const [mesh, other] = [1, 2].map(() => new Mesh(new BoxGeometry(), new MeshBasicMaterial()));
    const progress: number[] = [];
    const scene = await applyHatching(mesh, { onProgress: (value) => progress.push(value) });
    const map = hatched(mesh).tonalArtMap;
    expect(map).toBe(TonalArtMap.shared());
    expect((map as TonalArtMap).isReady).toBe(true);
    expect([...progress].sort((a, b) => a - b)).toEqual(progress);
    expect(progress.at(-1)).toBe(1);
    await applyHatching(other);
    expect(hatched(other).tonalArtMap).toBe(map);
    const gone = disposals();
    gone.watch([TonalArtMap.shared().texture]);
    scene.dispose();
    expect(gone.count).toBe(0);
  });

  test('every style that materials name has its shared map', async () => {
    const names = ['dashes', 'hatching'] as const;
    const meshes = names.map((name) => new Mesh(new BoxGeometry(), new MeshBasicMaterial({ name })));
    await applyHatching(new Group().add(...meshes), {
      material: ({ name }) => ({ tonalArtMap: name as (typeof names)[number] }),
    });
    expect(meshes.map((mesh) => hatched(mesh).tonalArtMap)).toEqual(names.map((name) => TonalArtMap.shared(name)));
  });

  test('a map that is generated for one scene is freed with it', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const scene = await applyHatching(mesh, { tonalArtMap: { size: 64, tones: 4 } });
    const map = hatched(mesh).tonalArtMap as TonalArtMap;
    expect(map.tones).toBe(4);
    const gone = disposals();
    gone.watch([map.texture]);
    scene.dispose();
    expect(gone.count).toBe(1);
  });

  test('no map is generated if none is needed', async () => {
    const shared = vi.spyOn(TonalArtMap, 'shared');
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    await applyHatching(mesh, { tonalArtMap: null });
    expect(hatched(mesh).tonalArtMap).toBe(null);
    expect(shared).not.toHaveBeenCalled();
    vi.restoreAllMocks();
  });

  test.each<[ApplyHatchingOptions, boolean]>([
    [{ preset: 'engraving', material: { technique: 'hatching' } }, true],
    [{ preset: 'stipple', material: { technique: 'hatching' } }, true],
    [{ preset: 'stipple', material: () => ({ technique: 'dryMedia' }) }, true],
    [{ preset: 'engraving' }, false],
    [{ preset: 'pencil', material: { technique: 'engraving' } }, false],
    [{ material: { technique: 'adjacency' } }, true],
    [{ material: { technique: 'stipple' } }, false],
    [{ preset: 'engraving', material: { technique: 'hatching' }, tonalArtMap: null }, false],
  ])('a map is made where the look is drawn with one, and only there: %j', async (options, isDrawn) => {
    const drawn = TonalArtMap.fromHatchImages({ size: 1, images: [[new Uint8Array([255])], [new Uint8Array(1)]] });
    const shared = vi.spyOn(TonalArtMap, 'shared').mockReturnValue(drawn);
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const hatched = await applyHatching(new Mesh(new BoxGeometry(), new MeshBasicMaterial()), options);
    expect(hatched.materials.map(({ tonalArtMap }) => tonalArtMap)).toEqual([
      // The name of a style is stored for later if no technique uses it.
      isDrawn ? drawn : options.tonalArtMap === null ? null : options.preset === 'pencil' ? 'pencil' : 'hatching',
    ]);
    expect(shared).toHaveBeenCalledTimes(Number(isDrawn));
    hatched.dispose();
    shared.mockRestore();
  });

  test('a function is called for a map only if a material needs one, which is not freed', async () => {
    const given = TonalArtMap.fromHatchImages({ size: 1, images: [[new Uint8Array([255])], [new Uint8Array(1)]] });
    const freed = vi.spyOn(given, 'dispose');
    const tonalArtMap = vi.fn(async () => given);
    const root = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    (await applyHatching(root, { preset: 'engraving', tonalArtMap })).dispose();
    expect(tonalArtMap).not.toHaveBeenCalled();
    const hatched = await applyHatching(root, { preset: 'pencil', tonalArtMap });
    expect(hatched.materials[0].tonalArtMap).toBe(given);
    hatched.dispose();
    expect(freed).not.toHaveBeenCalled();
    await expect(applyHatching(root, { tonalArtMap: async () => ({}) as TonalArtMap })).rejects.toThrow(
      'no TonalArtMap',
    );
    expect(root.material).toBeInstanceOf(MeshBasicMaterial);
  });

  test('a map that was given is not freed', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const gone = disposals();
    gone.watch([tonalArtMap.texture]);
    (await applyHatching(mesh, { tonalArtMap })).dispose();
    (await applyHatching(mesh, { material: { tonalArtMap } })).dispose();
    expect(gone.count).toBe(0);
  });
});

describe('concurrent work', () => {
  const model = () => new Mesh(new SphereGeometry(1, 32, 16), new MeshBasicMaterial());

  test('the map is drawn while geometries are prepared, and the progress is that of both', async () => {
    const order: string[] = [];
    const progress: number[] = [];
    await applyHatching(model(), {
      tonalArtMap: async () => {
        order.push('map');
        return tonalArtMap;
      },
      onGeometry: () => order.push('geometry'),
      onProgress: (value) => progress.push(value),
    });
    expect(order).toEqual(['map', 'geometry']);
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
  });

  test('if the map fails, the bake stops, and the scene is unchanged', async () => {
    const mesh = model();
    const { geometry } = mesh;
    const failing = applyHatching(mesh, { tonalArtMap: () => Promise.reject(new Error('no such map')) });
    await expect(failing).rejects.toThrow('no such map');
    expect(mesh.geometry).toBe(geometry);
    (await applyHatching(mesh, { tonalArtMap })).dispose();
  });
});
