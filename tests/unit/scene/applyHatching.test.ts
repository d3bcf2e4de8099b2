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
  GreaterDepth,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  LOD,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshDepthMaterial,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
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
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { disposals, hatched, looksOf, tonalArtMap } from './hatchedScenes.js';

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
    const scene = await applyHatching(new Group().add(mesh), { outlines: true, material: { technique: 'engraving' } });
    const [outlines] = scene.outlines;
    expect(outlines.layers.mask).toBe(mesh.layers.mask);
    mesh.layers.set(2);
    mesh.renderOrder = 3;
    expect([outlines.layers.mask, outlines.renderOrder]).toEqual([4, 3]);
    Object.assign(source, { opacity: 0, depthFunc: GreaterDepth, stencilWrite: true, stencilRef: 2 });
    expect(mesh.material.visible).toBe(true);
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
        material: { technique: 'engraving' },
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

  test('a material whose maps alone say what is metal is none', async () => {
    for (const map of ['metalnessMap', 'roughnessMap']) {
      const source = new MeshStandardMaterial({ metalness: 1, roughness: 0.2, [map]: new Texture() });
      const mesh = new Mesh(new PlaneGeometry(), source);
      await applyHatching(mesh, { tonalArtMap });
      expect(hatched(mesh).metalness, map).toBe(0);
    }
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
      metalness: 0.9,
      roughness: 0.2,
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
      'metalness',
      'roughness',
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
    await applyHatching(anchored, { tonalArtMap, material: { technique: 'hatching' } });
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
      material: ({ name }) => ({ technique: name === 'special' ? 'adjacency' : 'hatching' }),
    });
    expect(layouts()).toEqual(['corner', 'corner', 'indexed']);
    scene.dispose();
    await applyHatching(root, { tonalArtMap, layout: 'corner', material: { technique: 'hatching' } });
    expect(layouts()).toEqual(['corner', 'corner', 'corner']);
  });
});

describe('an array of materials with holes', () => {
  const holes: [what: string, hole: unknown][] = [
    ['undefined', undefined],
    ['null', null],
  ];
  test.each(holes)('keeps them, whatever the technique: %s', async (_what, hole) => {
    for (const technique of ['hatching', 'adjacency'] as const) {
      const mesh = new Mesh(new BoxGeometry(), [new MeshBasicMaterial(), hole as Material, new MeshBasicMaterial()]);
      const { materials, skipped } = await applyHatching(mesh, { tonalArtMap, material: { technique } });
      expect(mesh.material).toEqual([materials[0], hole, materials[1]]);
      expect(skipped).toEqual([]);
      expect(mesh.geometry.userData.hatching.layout).toBe(technique === 'hatching' ? 'indexed' : 'corner');
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
    (await applyHatching(batch, { tonalArtMap, material: { technique: 'hatching' } })).dispose();
    expect(gone.count).toBe(0);
  });
});
