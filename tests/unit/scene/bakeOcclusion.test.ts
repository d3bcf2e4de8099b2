import {
  BackSide,
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  type MeshBasicMaterialParameters,
  type Object3D,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
} from 'three';
import { describe, expect, test, vi } from 'vitest';
import { bakeOcclusion, type OcclusionBake, prepareHatchingGeometry } from '../../../src/index.js';
import { isStale } from '../../../src/material/geometry/staleGeometry.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { eventually } from '../patience.js';

const FEW = { directions: 64 };

const prepared = async (geometry: BufferGeometry, layout: 'corner' | 'pull' | 'indexed' = 'indexed') =>
  new Mesh(await prepareHatchingGeometry(geometry, { layout }), new HatchingMaterial());

/** A wide plane above the origin, which occludes nearly everything below it. */
const roof = (): Mesh =>
  new Mesh(new PlaneGeometry(30, 30).rotateX(Math.PI / 2).translate(0, 0.5, 0), new MeshBasicMaterial());
const ground = (): BufferGeometry => new PlaneGeometry(1, 1, 3, 3).rotateX(-Math.PI / 2);

/** The occlusion of a drawn mesh. */
const occlusionsOf = ({ geometry }: Mesh): number[] => {
  const { hatchNormal } = geometry.attributes;
  return Array.from({ length: hatchNormal.count }, (_, i) => Math.max(-hatchNormal.getW(i), 0));
};
const darkest = (mesh: Mesh): number => Math.max(...occlusionsOf(mesh));
const lightest = (mesh: Mesh): number => Math.min(...occlusionsOf(mesh));

const sceneOf = (...meshes: Mesh[]): Group => new Group().add(...meshes);

describe('the bake', () => {
  test.each(['corner', 'pull', 'indexed'] as const)(
    'every vertex of the layout %s, and nothing else of it',
    async (layout) => {
      const mesh = await prepared(ground(), layout);
      const { geometry } = mesh;
      const { hatchNormal } = geometry.attributes;
      const before = hatchNormal.array.slice();
      const { version } = hatchNormal as BufferAttribute;
      const bake = await bakeOcclusion(sceneOf(mesh, roof()), FEW);
      expect(lightest(mesh)).toBeGreaterThan(0.9);
      expect(mesh.geometry).toBe(geometry);
      expect(geometry.attributes.hatchNormal).toBe(hatchNormal);
      expect((hatchNormal as BufferAttribute).version).toBeGreaterThan(version);
      expect(isStale(geometry)).toBe(false);
      expect([bake.meshes, bake.skipped, bake.directions]).toEqual([[mesh], [], 64]);
      bake.dispose();
      expect(hatchNormal.array).toEqual(before);
      expect(bake.meshes).toEqual([]);
      bake.dispose();
    },
  );

  test('a scene far from the origin has the same occlusion as at the origin', async () => {
    const bakedAt = async (x: number): Promise<number[]> => {
      const [lower, upper] = [await prepared(ground()), await prepared(ground().rotateX(Math.PI))];
      upper.position.y = 0.2;
      const scene = sceneOf(lower, upper);
      scene.position.set(x, x / 2, -x);
      await bakeOcclusion(scene, FEW);
      return [...occlusionsOf(lower), ...occlusionsOf(upper)];
    };
    const near = await bakedAt(0);
    expect(Math.max(...near)).toBeGreaterThan(0.3);
    (await bakedAt(2 ** 24)).forEach((value, i) => {
      expect(value).toBeCloseTo(near[i], 3);
    });
  });

  test('two meshes occlude each other, and one that is not prepared occludes too', async () => {
    const lower = await prepared(ground());
    const upper = await prepared(ground().rotateX(Math.PI).translate(0, 0.2, 0));
    await bakeOcclusion(sceneOf(lower, upper), FEW);
    expect(darkest(lower)).toBeGreaterThan(0.3);
    expect(darkest(upper)).toBeGreaterThan(0.3);
    await bakeOcclusion(sceneOf(lower), FEW);
    expect(darkest(lower)).toBe(0);
    await bakeOcclusion(sceneOf(lower, roof()), FEW);
    expect(lightest(lower)).toBeGreaterThan(0.9);
  });

  const material = (parameters: MeshBasicMaterialParameters) => (mesh: Mesh) => {
    (mesh.material as MeshBasicMaterial).setValues(parameters);
    return mesh;
  };
  const invisible = <Thing extends Object3D>(thing: Thing): Thing => Object.assign(thing, { visible: false });
  test.each<[string, (mesh: Mesh) => Object3D]>([
    ['invisible', invisible],
    ['of an invisible material', material({ visible: false })],
    ['transparent', material({ transparent: true })],
    ['below an invisible group', (mesh) => invisible(new Group()).add(mesh)],
    ['instanced', ({ geometry, material }) => new InstancedMesh(geometry, material, 1)],
  ])('a mesh that is %s hides nothing', async (_, change) => {
    const mesh = await prepared(ground());
    const bake = await bakeOcclusion(new Group().add(mesh, change(roof())), FEW);
    expect(darkest(mesh)).toBe(0);
    expect(bake.skipped).toEqual([]);
  });

  test.each([
    ['walls that face inward let light in where backs are not drawn', BackSide, 0, 0.05],
    ['walls of two sides keep it out', DoubleSide, 0.95, 1],
  ])('%s', async (_, side, least, most) => {
    const floor = await prepared(ground());
    const walls = new Mesh(new BoxGeometry(2, 2, 2).translate(0, 0.9, 0), new MeshBasicMaterial({ side }));
    await bakeOcclusion(sceneOf(floor, walls), FEW);
    expect(lightest(floor)).toBeGreaterThanOrEqual(least);
    expect(darkest(floor)).toBeLessThanOrEqual(most);
  });

  test('of the groups of a mesh, those that are see-through occlude nothing', async () => {
    const two = new PlaneGeometry(30, 30, 2, 1).rotateX(Math.PI / 2).translate(0, 0.5, 0);
    two.addGroup(0, 6, 0);
    two.addGroup(6, 6, 1);
    const half = new Mesh(two, [new MeshBasicMaterial(), new MeshBasicMaterial({ transparent: true })]);
    const [left, right] = [await prepared(ground().translate(-4, 0, 0)), await prepared(ground().translate(4, 0, 0))];
    await bakeOcclusion(sceneOf(left, right, half), FEW);
    expect(lightest(left)).toBeGreaterThan(0.8);
    expect(darkest(right)).toBeLessThan(0.1);
  });

  test('instances get none', async () => {
    const mesh = await prepared(ground());
    const instances = new InstancedMesh((await prepared(ground())).geometry, new HatchingMaterial(), 2);
    const bake = await bakeOcclusion(sceneOf(mesh, instances, roof()), FEW);
    expect(bake.meshes).toEqual([mesh]);
    expect(darkest(instances)).toBe(0);
    expect(lightest(mesh)).toBeGreaterThan(0.9);
  });

  test('a mesh that deforms is baked at rest, whatever its pose', async () => {
    const geometry = ground();
    const count = geometry.attributes.position.count;
    geometry.morphAttributes.position = [new BufferAttribute(new Float32Array(3 * count).fill(9), 3)];
    geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(4 * count), 4));
    geometry.setAttribute(
      'skinWeight',
      new BufferAttribute(
        Float32Array.from({ length: 4 * count }, (_, i) => +(i % 4 === 0)),
        4,
      ),
    );
    const mesh = new SkinnedMesh(await prepareHatchingGeometry(geometry, { adjacency: true }), new HatchingMaterial());
    const bone = new Bone();
    mesh.add(bone);
    mesh.bind(new Skeleton([bone]));
    mesh.morphTargetInfluences = [1];
    await bakeOcclusion(sceneOf(mesh, roof()), FEW);
    const atRest = occlusionsOf(mesh);
    expect(Math.min(...atRest)).toBeGreaterThan(0.9);
    mesh.morphTargetInfluences[0] = 0;
    bone.rotation.x = 1;
    expect(occlusionsOf(mesh)).toEqual(atRest);
  });

  test('meshes that share a geometry get one each, and the shared one again on dispose', async () => {
    const mesh = await prepared(ground(), 'corner');
    const { geometry } = mesh;
    const twin = new Mesh(geometry, mesh.material);
    twin.position.x = 20;
    const bake = await bakeOcclusion(sceneOf(mesh, twin, roof()), FEW);
    expect(lightest(mesh)).toBeGreaterThan(0.9);
    expect(darkest(twin)).toBe(0);
    expect(twin.geometry.attributes.position).toBe(geometry.attributes.position);
    expect(twin.geometry.userData).toBe(geometry.userData);
    const freed: string[] = [];
    geometry.addEventListener('dispose', () => freed.push('source'));
    twin.geometry.addEventListener('dispose', ({ target }) => freed.push(...Object.keys(target.attributes)));
    bake.dispose();
    expect([mesh.geometry, twin.geometry]).toEqual([geometry, geometry]);
    expect(mesh.geometry).toBe(geometry);
    expect(twin.geometry).toBe(geometry);
    expect(freed).toEqual(['hatchNormal']);
    expect(darkest(mesh)).toBe(0);
  });

  test('an older bake removes nothing of a newer one', async () => {
    const mesh = await prepared(ground());
    const older = await bakeOcclusion(sceneOf(mesh), FEW);
    await bakeOcclusion(sceneOf(mesh, roof()), FEW);
    older.dispose();
    expect(lightest(mesh)).toBeGreaterThan(0.9);
  });

  test('a mesh that was given another geometry in the meantime keeps it unchanged', async () => {
    const mesh = await prepared(ground());
    const other = (await prepared(ground())).geometry;
    const baking = bakeOcclusion(sceneOf(mesh, roof()), FEW);
    mesh.geometry = other;
    await baking;
    expect(mesh.geometry).toBe(other);
    expect(darkest(mesh)).toBe(0);
  });

  test('a mesh that cannot be read is named, and the others go on', async () => {
    const mesh = await prepared(ground());
    const broken = roof();
    broken.geometry.setIndex([0, 1]);
    const bare = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ side: DoubleSide }));
    const bake = await bakeOcclusion(sceneOf(mesh, broken, bare), FEW);
    expect(bake.skipped.map((one) => one.mesh)).toEqual([broken, bare]);
    expect(bake.skipped.map(({ error }) => error?.message)).toEqual([
      expect.stringMatching(/^bakeOcclusion: the geometry: the index count is 2, which is not a multiple of three/),
      'bakeOcclusion: the geometry has no attribute "position". Set one with three floats per vertex.',
    ]);
    expect(darkest(mesh)).toBe(0);
  });
});

describe('during the bake', () => {
  test('results come early and grow finer; progress rises to 1', async () => {
    const mesh = await prepared(new BoxGeometry(0.5, 0.5, 0.5, 8, 8, 8));
    const passes: [number, number][] = [];
    const progress: number[] = [];
    const bake = await bakeOcclusion(sceneOf(mesh, roof()), {
      onPass: ({ directions }) => void passes.push([directions, darkest(mesh)]),
      onProgress: (part) => void progress.push(part),
    });
    expect(passes.map(([directions]) => directions)).toEqual([64, 192, 384]);
    for (const [, dark] of passes) expect(dark).toBeGreaterThan(0.9);
    expect(progress).toEqual([...new Set(progress)].sort((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
    expect(bake.directions).toBe(384);
  });

  test('an abort after a first result rejects with the reason and removes the result, geometries too', async () => {
    const mesh = await prepared(ground());
    const { geometry } = mesh;
    const twin = new Mesh(geometry, mesh.material);
    const alone = await prepared(ground());
    const controller = new AbortController();
    const onPass = vi.fn(() => {
      expect(lightest(alone)).toBeGreaterThan(0.9);
      controller.abort('enough');
    });
    const baking = bakeOcclusion(sceneOf(mesh, twin, alone, roof()), { onPass, signal: controller.signal });
    await expect(baking).rejects.toBe('enough');
    expect(onPass).toHaveBeenCalledTimes(1);
    expect(mesh.geometry).toBe(geometry);
    expect(darkest(mesh)).toBe(0);
    expect(darkest(alone)).toBe(0);
  });

  test('waits for pause between its parts, and shows nothing in the meantime', async () => {
    const mesh = await prepared(ground());
    let goOn: (() => void) | undefined;
    let asked = 0;
    const onPass = vi.fn();
    const baking = bakeOcclusion(sceneOf(mesh, roof()), {
      directions: 64,
      onPass,
      pause: () => {
        asked++;
        return new Promise<void>((resolve) => {
          goOn = resolve;
        });
      },
    });
    // Before the start, before each of the four parts, and before the one pass is shown.
    for (let part = 1; part <= 6; part++) {
      await eventually(() => expect(asked).toBe(part));
      expect(onPass).not.toHaveBeenCalled();
      expect(darkest(mesh)).toBe(0);
      goOn?.();
    }
    await baking;
    expect(asked).toBe(6);
    expect(lightest(mesh)).toBeGreaterThan(0.9);
  });

  test('a rejection of pause ends the bake', async () => {
    const mesh = await prepared(ground());
    await expect(bakeOcclusion(mesh, { pause: () => Promise.reject(new Error('no more')) })).rejects.toThrow('no more');
    expect(darkest(mesh)).toBe(0);
  });

  test('an abort before the bake changes nothing', async () => {
    const mesh = await prepared(ground());
    const onPass = vi.fn();
    await expect(bakeOcclusion(mesh, { signal: AbortSignal.abort('no'), onPass })).rejects.toBe('no');
    expect(onPass).not.toHaveBeenCalled();
  });

  test('an error in onPass ends the bake and removes its results', async () => {
    const mesh = await prepared(ground());
    const onPass = (bake: OcclusionBake) => {
      throw new Error(`seen ${bake.directions}`);
    };
    await expect(bakeOcclusion(sceneOf(mesh, roof()), { onPass })).rejects.toThrow('seen 64');
    expect(darkest(mesh)).toBe(0);
  });
});

describe('wrong calls', () => {
  test.each([
    [{ direction: 1 }, 'unknown option "direction"'],
    [{ directions: 3 }, 'directions is 3'],
    [{ directions: Number.NaN }, 'directions is NaN'],
    [{ onPass: 1 }, 'onPass must be a function'],
    [{ pause: 1 }, 'pause must be a function'],
    [{ signal: {} }, 'signal'],
  ])('%o', async (options, message) => {
    await expect(bakeOcclusion(new Group(), options as never)).rejects.toThrow(message);
  });

  test('no scene, and a scene without prepared meshes', async () => {
    await expect(bakeOcclusion(undefined as never)).rejects.toThrow('expected a THREE.Object3D');
    await expect(bakeOcclusion(sceneOf(roof()))).rejects.toThrow('prepareHatchingGeometry()');
  });
});
