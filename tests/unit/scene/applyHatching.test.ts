import {
  AdditiveBlending,
  BackSide,
  BatchedMesh,
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  GreaterDepth,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  LOD,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshDepthMaterial,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
  Object3D,
  ObjectSpaceNormalMap,
  PerspectiveCamera,
  Plane,
  PlaneGeometry,
  Points,
  PointsMaterial,
  Scene,
  ShadowMaterial,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Sprite,
  Texture,
  Vector2,
  Vector3,
} from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { describe, expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { reactive } from '../material/geometry/reactive.js';

const tonalArtMap = TonalArtMap.fromHatchImages({
  size: 4,
  images: [255, 128, 0].map((v) => [new Uint8Array(16).fill(v)]),
});

const hatched = (mesh: Mesh): HatchingMaterial => {
  expect(mesh.material).toBeInstanceOf(HatchingMaterial);
  return mesh.material as HatchingMaterial;
};

/** Everything that hatching could change, by identity. */
const looksOf = (root: Object3D) => {
  const looks: unknown[] = [];
  root.traverse((object) => {
    if ('geometry' in object) looks.push(object, object.geometry, (object as Mesh).material);
  });
  return looks;
};

function brokenMesh(): Mesh {
  const mesh = new Mesh(new PlaneGeometry(), new MeshBasicMaterial());
  mesh.name = 'torn';
  mesh.geometry.attributes.position.array[0] = Number.NaN;
  return mesh;
}

/** Counts the `dispose` events of whatever `watch` is given. */
function disposals() {
  let count = 0;
  const onDispose = () => {
    count++;
  };
  return {
    watch: (things: { addEventListener(type: 'dispose', listener: () => void): void }[]) => {
      for (const thing of things) thing.addEventListener('dispose', onDispose);
    },
    get count() {
      return count;
    },
  };
}

describe('the hatched scene', () => {
  test('every mesh gets a baked geometry and a material, shared ones once', async () => {
    const box = new BoxGeometry();
    const paint = new MeshStandardMaterial({ color: 'tomato' });
    const [a, b, c] = [new Mesh(box, paint), new Mesh(box, paint), new Mesh(new SphereGeometry(), paint)];
    const root = new Group().add(a, new Group().add(b), new LOD().addLevel(c, 3));
    c.visible = false;
    const { materials, skipped } = await applyHatching(root, { tonalArtMap });
    expect(skipped).toEqual([]);
    expect(materials).toEqual([a.material]);
    expect(b.material).toBe(a.material);
    expect(c.material).toBe(a.material);
    expect(hatched(a).tonalArtMap).toBe(tonalArtMap);
    expect(b.geometry).toBe(a.geometry);
    expect(a.geometry).not.toBe(box);
    expect(a.geometry.userData.hatching).toMatchObject({ triangles: 12, layout: 'indexed' });
    expect(c.geometry.userData.hatching).toMatchObject({ layout: 'indexed' });
  });

  test('outlines follow the layers, the order and the opacity of their meshes, also after changes', async () => {
    const source = new MeshStandardMaterial({ transparent: true });
    const mesh = new Mesh(new BoxGeometry(), source);
    mesh.layers.set(1);
    const scene = await applyHatching(new Group().add(mesh), { outlines: true, material: { technique: 'engraved' } });
    const [outlines] = scene.outlines;
    expect(outlines.layers.mask).toBe(mesh.layers.mask);
    mesh.layers.set(2);
    mesh.renderOrder = 3;
    expect([outlines.layers.mask, outlines.renderOrder]).toEqual([4, 3]);
    Object.assign(source, { opacity: 0, depthFunc: GreaterDepth, stencilWrite: true, stencilRef: 2 });
    scene.follow();
    expect(mesh.material).toMatchObject({ opacity: 0, depthFunc: GreaterDepth, stencilWrite: true, stencilRef: 2 });
    outlines.geometry.setDrawRange(0, 9);
    outlines.onBeforeRender({} as never, new Scene(), new PerspectiveCamera());
    expect(outlines.geometry.drawRange.count).toBe(-1);
    scene.dispose();
  });

  test('cut-outs have outlines, unless these would be drawn where the surface is invisible', async () => {
    const map = new DataTexture(Uint8Array.of(255, 255, 255, 0), 1, 1);
    const hasOutlines = async (parameters: MeshStandardMaterialParameters) => {
      const group = new Group().add(
        new Mesh(new BoxGeometry(), new MeshStandardMaterial(parameters)),
        new Mesh(new BoxGeometry(), new MeshStandardMaterial()),
      );
      const { outlines, skipped } = await applyHatching(group, {
        outlines: true,
        material: { technique: 'engraved' },
      });
      const has = outlines.some(({ mesh }) => mesh === group.children[0]);
      expect(skipped.map(({ mesh }) => mesh)).toEqual(has ? [] : [group.children[0]]);
      for (const { reason } of skipped)
        expect(reason).toMatch(/ is hatched without outlines: they would be drawn where/);
      return has;
    };
    for (const parameters of [
      { alphaTest: 0.5, map },
      { alphaHash: true, map },
      { transparent: true, map },
    ])
      expect(await hasOutlines(parameters), Object.keys(parameters).join()).toBe(true);
    for (const parameters of [
      { alphaTest: 0.5, map, transparent: true },
      { alphaTest: 0.5, map, depthWrite: false },
      { alphaHash: true, opacity: 0.5 },
      { transparent: true, alphaMap: map },
    ])
      expect(await hasOutlines(parameters), Object.keys(parameters).join()).toBe(false);
  });

  test('a material keeps everything that has a meaning on paper', async () => {
    const planes = [new Plane(new Vector3(1, 0, 0), 2)];
    const circular: { self?: object } = {};
    circular.self = circular;
    const source = new MeshStandardMaterial({
      name: 'leaf',
      color: '#336699',
      map: new Texture(),
      alphaMap: new Texture(),
      normalMap: new Texture(),
      normalMapType: ObjectSpaceNormalMap,
      normalScale: new Vector2(0.5, -1),
      bumpMap: new Texture(),
      bumpScale: 0.5,
      flatShading: true,
      aoMap: new Texture(),
      aoMapIntensity: 0.6,
      lightMap: new Texture(),
      lightMapIntensity: 0.7,
      emissive: 'gold',
      emissiveIntensity: 0.8,
      emissiveMap: new Texture(),
      alphaTest: 0.25,
      opacity: 0.5,
      transparent: true,
      side: BackSide,
      vertexColors: true,
      depthWrite: false,
      depthTest: false,
      blending: AdditiveBlending,
      fog: false,
      wireframe: true,
      wireframeLinewidth: 2,
      clippingPlanes: planes,
      clipShadows: true,
      polygonOffset: true,
      polygonOffsetFactor: 3,
      toneMapped: false,
      colorWrite: false,
      alphaHash: true,
      stencilWrite: true,
      stencilRef: 7,
      visible: false,
      userData: circular,
    });
    const mesh = new Mesh(new PlaneGeometry(), source);
    await applyHatching(mesh, { tonalArtMap });
    const material = hatched(mesh);
    for (const key of [
      'name',
      'map',
      'alphaMap',
      'normalMap',
      'normalMapType',
      'bumpMap',
      'bumpScale',
      'flatShading',
      'aoMap',
      'aoMapIntensity',
      'lightMap',
      'lightMapIntensity',
      'emissiveIntensity',
      'emissiveMap',
      'alphaTest',
      'opacity',
      'transparent',
      'side',
      'vertexColors',
      'depthWrite',
      'depthTest',
      'blending',
      'fog',
      'wireframe',
      'wireframeLinewidth',
      'clippingPlanes',
      'clipShadows',
      'polygonOffset',
      'polygonOffsetFactor',
      'toneMapped',
      'colorWrite',
      'alphaHash',
      'stencilWrite',
      'stencilRef',
      'visible',
    ] as const) {
      expect(material[key], key).toBe(source[key]);
    }
    expect(material.color.equals(new Color('#336699'))).toBe(true);
    expect(material.color).not.toBe(source.color);
    expect(material.emissive.equals(new Color('gold'))).toBe(true);
    expect(material.normalScale.toArray()).toEqual([0.5, -1]);
    expect(material.userData.self).toBe(circular);
    expect(material.uniforms.map.value).not.toBe(undefined);
  });

  test('several materials of a mesh stay separate, in order, with the groups', async () => {
    const [red, blue] = [new MeshBasicMaterial({ color: 'red' }), new MeshStandardMaterial({ color: 'blue' })];
    const mesh = new Mesh(new BoxGeometry(), [red, blue, red, blue, red, blue]);
    const groups = structuredClone(mesh.geometry.groups);
    const { materials } = await applyHatching(mesh, { tonalArtMap });
    const replaced = mesh.material as unknown as HatchingMaterial[];
    expect(replaced.map(({ color }) => color.getHexString())).toEqual([
      'ff0000',
      '0000ff',
      'ff0000',
      '0000ff',
      'ff0000',
      '0000ff',
    ]);
    expect(new Set(replaced)).toEqual(new Set(materials));
    expect(materials).toHaveLength(2);
    expect(mesh.geometry.groups).toEqual(groups);
  });

  test('lines, points, sprites, shadow catchers and hatched meshes are left alone', async () => {
    const own = new Mesh(new PlaneGeometry(), new HatchingMaterial());
    const others = [
      new Line(new BufferGeometry(), new LineBasicMaterial()),
      new Points(new BufferGeometry(), new PointsMaterial()),
      new Sprite(),
      new LineSegments2(new LineSegmentsGeometry().setPositions([0, 0, 0, 1, 0, 0])),
      new Mesh(new PlaneGeometry(), new ShadowMaterial()),
      own,
    ];
    const root = new Group().add(...others);
    const before = looksOf(root);
    const { materials, skipped } = await applyHatching(root, { tonalArtMap });
    expect(looksOf(root)).toEqual(before);
    expect([materials, skipped]).toEqual([[], []]);
  });

  test('instances, skins, morph targets, shadows and their materials keep working', async () => {
    const instanced = new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 3);
    const { instanceMatrix } = instanced;
    const geometry = new PlaneGeometry();
    geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(16), 4));
    geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array(16).fill(0.25), 4));
    geometry.morphAttributes.position = [new BufferAttribute(new Float32Array(12).fill(0.1), 3)];
    const skinned = new SkinnedMesh(geometry, new MeshBasicMaterial());
    const skeleton = new Skeleton([new Bone()]);
    skinned.add(skeleton.bones[0]);
    skinned.bind(skeleton);
    skinned.morphTargetInfluences = [0.5];
    skinned.castShadow = true;
    const depth = new MeshDepthMaterial();
    skinned.customDepthMaterial = depth;
    await applyHatching(new Group().add(instanced, skinned), { tonalArtMap });
    expect(instanced.instanceMatrix).toBe(instanceMatrix);
    expect(instanced.count).toBe(3);
    expect(skinned.skeleton).toBe(skeleton);
    expect(Object.keys(skinned.geometry.attributes)).toEqual(expect.arrayContaining(['skinIndex', 'skinWeight']));
    expect(skinned.geometry.morphAttributes.position).toHaveLength(1);
    expect(skinned.morphTargetInfluences).toEqual([0.5]);
    expect([skinned.castShadow, skinned.customDepthMaterial]).toEqual([true, depth]);
  });

  test('meshes that deform have a material of their own, so that no program changes from mesh to mesh', async () => {
    const paint = new MeshBasicMaterial();
    const [still, alsoStill, moving] = [1, 2, 3].map((n) => new Mesh(new BoxGeometry(n), paint)) as unknown as [
      Mesh,
      Mesh,
      Mesh,
    ];
    moving.geometry.morphAttributes.position = [moving.geometry.attributes.position.clone()];
    await applyHatching(new Group().add(still, alsoStill, moving), {
      tonalArtMap,
      material: { technique: 'adjacency' },
    });
    expect(alsoStill.material).toBe(still.material);
    expect(moving.material).not.toBe(still.material);
    expect(moving.geometry.userData.hatching.layout).toBe('pull');
    expect(still.geometry.userData.hatching.layout).toBe('corner');
  });

  test('a batch keeps its geometry: anchored hatches it, other techniques name the remedy', async () => {
    const make = () => {
      const batch = new BatchedMesh(1, 24, 36, new MeshBasicMaterial());
      batch.addInstance(batch.addGeometry(new BoxGeometry()));
      return batch;
    };
    const anchored = make();
    const { geometry } = anchored;
    await applyHatching(anchored, { tonalArtMap, material: { technique: 'anchored' } });
    expect(anchored.geometry).toBe(geometry);
    hatched(anchored);
    await expect(applyHatching(make(), { tonalArtMap, material: { technique: 'adjacency' } })).rejects.toThrow(
      /BatchedMesh .* has no triangle adjacency/,
    );
  });

  test('geometries that only anchored draws are baked without corners, unless a layout is requested', async () => {
    const shared = new BoxGeometry();
    const [a, b, c] = [
      new Mesh(shared, new MeshBasicMaterial({ name: 'plain' })),
      new Mesh(shared, new MeshBasicMaterial({ name: 'special' })),
      new Mesh(new BoxGeometry(), new MeshBasicMaterial({ name: 'plain' })),
    ];
    const root = new Group().add(a, b, c);
    const layouts = () => [a, b, c].map(({ geometry }) => geometry.userData.hatching.layout);
    const scene = await applyHatching(root, {
      tonalArtMap,
      material: ({ name }) => ({ technique: name === 'special' ? 'adjacency' : 'anchored' }),
    });
    expect(layouts()).toEqual(['corner', 'corner', 'indexed']);
    scene.dispose();
    await applyHatching(root, { tonalArtMap, layout: 'corner', material: { technique: 'anchored' } });
    expect(layouts()).toEqual(['corner', 'corner', 'corner']);
  });
});

describe('an array of materials with holes', () => {
  const holes: [what: string, hole: unknown][] = [
    ['undefined', undefined],
    ['null', null],
  ];
  test.each(holes)('keeps them, whatever the technique: %s', async (_what, hole) => {
    for (const technique of ['anchored', 'adjacency'] as const) {
      const mesh = new Mesh(new BoxGeometry(), [new MeshBasicMaterial(), hole as Material, new MeshBasicMaterial()]);
      const { materials, skipped } = await applyHatching(mesh, { tonalArtMap, material: { technique } });
      expect(mesh.material).toEqual([materials[0], hole, materials[1]]);
      expect(skipped).toEqual([]);
      expect(mesh.geometry.userData.hatching.layout).toBe(technique === 'anchored' ? 'indexed' : 'corner');
    }
  });

  test('is left alone if all materials hatch already, or if there are only holes', async () => {
    const meshes = [[new HatchingMaterial(), undefined], [undefined]].map(
      (materials) => new Mesh(new BoxGeometry(), materials as Material[]),
    );
    const before = meshes.map(({ geometry }) => geometry);
    expect((await applyHatching(new Group().add(...meshes), { tonalArtMap })).materials).toEqual([]);
    expect(meshes.map(({ geometry }) => geometry)).toEqual(before);
  });
});

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
    expect(hatched(small).tilesPerUnit).toBeCloseTo(perWorldUnit * 5, 6);
    expect(hatched(large).tilesPerUnit).toBeCloseTo(perWorldUnit * 20, 6);
    expect(hatched(instanced).tilesPerUnit).toBeCloseTo(perWorldUnit * 2.5, 6);
    expect(alike.material).toBe(small.material);
    expect(scene.materials).toHaveLength(3);
    scene.dispose();
    await applyHatching(root, {
      tonalArtMap,
      tilesPerWorldUnit: 2,
      material: (_, mesh) => (mesh === large ? { tilesPerUnit: 7 } : {}),
    });
    expect(hatched(small).tilesPerUnit).toBeCloseTo(10, 6);
    expect(hatched(large).tilesPerUnit).toBe(7);
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
    expect(hatched(skinned).tilesPerUnit).toBeCloseTo(4, 6);
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
    [{ preset: 'engraving', material: { technique: 'anchored' } }, true],
    [{ preset: 'stipple', material: { medium: 'ink' } }, true],
    [{ preset: 'stipple', material: () => ({ medium: 'dry' }) }, true],
    [{ preset: 'engraving' }, false],
    [{ preset: 'pencil', material: { technique: 'engraved' } }, false],
    // Only `anchored` has a medium.
    [{ material: { technique: 'adjacency', medium: 'stipple' } }, true],
    [{ material: { technique: 'anchored', medium: 'stipple' } }, false],
    [{ preset: 'engraving', material: { technique: 'anchored' }, tonalArtMap: null }, false],
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

describe('restoring', () => {
  test('restore sets the same objects again, once, and the scene can be hatched again', async () => {
    const root = new Group().add(
      new Mesh(
        new BoxGeometry(),
        [1, 2, 3, 4, 5, 6].map(() => new MeshBasicMaterial()),
      ),
      new Mesh(new SphereGeometry(), new MeshStandardMaterial()),
    );
    const before = looksOf(root);
    const first = await applyHatching(root, { tonalArtMap });
    expect(looksOf(root)).not.toEqual(before);
    first.restore();
    for (const [i, part] of looksOf(root).entries()) expect(part).toBe(before[i]);

    const second = await applyHatching(root, { tonalArtMap });
    const during = looksOf(root);
    first.restore();
    first.dispose();
    for (const [i, part] of looksOf(root).entries()) expect(part).toBe(during[i]);
    await expect(applyHatching(root, { tonalArtMap })).rejects.toThrow(/hatched already/);
    second.restore();
    for (const [i, part] of looksOf(root).entries()) expect(part).toBe(before[i]);
  });

  test('dispose restores and frees every geometry and material made, once, and no other', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const root = new Group().add(mesh, new Mesh(mesh.geometry, new MeshStandardMaterial()));
    const [mine, theirs] = [disposals(), disposals()];
    mine.watch([mesh.geometry, mesh.material]);
    const before = looksOf(root);
    const scene = await applyHatching(root, { tonalArtMap });
    theirs.watch([mesh.geometry, ...scene.materials]);
    scene.dispose();
    scene.dispose();
    expect(looksOf(root)).toEqual(before);
    expect([mine.count, theirs.count]).toEqual([0, 3]);
  });

  test('the geometry of a batch, which is not new, is not freed', async () => {
    const batch = new BatchedMesh(1, 24, 36, new MeshBasicMaterial());
    batch.addInstance(batch.addGeometry(new BoxGeometry()));
    const gone = disposals();
    gone.watch([batch.geometry]);
    (await applyHatching(batch, { tonalArtMap, material: { technique: 'anchored' } })).dispose();
    expect(gone.count).toBe(0);
  });
});

describe('errors', () => {
  test.each([
    [
      { layot: 'pull' },
      'unknown option "layot". The known ones are tonalArtMap, material, tilesPerWorldUnit, detail, filter, onGeometry, onFormProgress, invalidate, preset, replaces, renderer, camera, adjacency, ',
    ],
    [null, 'the options are null. Pass an object'],
    [{ signal: 'now' }, 'signal is now, but must be an AbortSignal'],
  ])('options %o are refused, and the scene can be hatched', async (options, message) => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    await expect(applyHatching(mesh, options as never)).rejects.toThrow(`applyHatching: ${message}`);
    await applyHatching(mesh, { tonalArtMap, weldTolerance: 0 });
    hatched(mesh);
  });

  test('a scene that is hatched, or being hatched, in whole or in part, is refused', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    mesh.name = 'crate';
    const root = new Group().add(mesh);
    const first = applyHatching(mesh, { tonalArtMap });
    await expect(applyHatching(root, { tonalArtMap })).rejects.toThrow(
      'applyHatching: nothing is left to hatch. The Mesh "crate" at Group/crate is hatched already, or is being hatched.',
    );
    const during = (await first).materials[0];
    await expect(applyHatching(root, { tonalArtMap })).rejects.toThrow(/hatched already/);
    expect(mesh.material).toBe(during);
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
    // The first call has released its claim late: the claim of the second stands.
    await expect(mount().scene).rejects.toThrow(/is being hatched/);
    const scene = await second.scene;
    expect(hatched(mesh)).toBe(scene.materials[0]);
    // An abort after the end changes nothing.
    second.unmount();
    await expect(mount().scene).rejects.toThrow(/hatched already/);
    scene.dispose();
    expect(mesh.material).toBe(original);
  });

  test('a mesh and its proxy, as by ref of Vue, are one mesh', async () => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const scene = await applyHatching(reactive(mesh), { tonalArtMap });
    hatched(mesh);
    await expect(applyHatching(mesh, { tonalArtMap })).rejects.toThrow(/hatched already/);
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
    const promise = applyHatching(new Group().add(changed, kept), { tonalArtMap });
    const replacement = new MeshStandardMaterial();
    changed.material = replacement;
    const { skipped } = await promise;
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
    ['a wrong parameter', () => ({ material: { technique: 'magic' as 'anchored' } }), /"magic" is not known/],
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
