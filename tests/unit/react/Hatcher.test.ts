import {
  BackSide,
  BoxGeometry,
  type BufferGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  type Material,
  Mesh,
  MeshBasicMaterial,
  ShaderMaterial,
  SphereGeometry,
  Texture,
  TorusGeometry,
} from 'three';
import { type ApplyHatchingOptions, type HatchedScene, HatchingMaterial, presets, TonalArtMap } from 'three-hatching';
import { exampleHand } from 'three-hatching/hands';
import { expect, test, vi } from 'vitest';
import { Hatcher } from '../../../src/react/Hatcher.js';
import { eventually } from '../patience.js';

// The threshold of large geometries is some hundred triangles here.
vi.mock('../../../src/material/geometry/PrepareHatchingGeometryOptions.js', async (original) => ({
  ...(await original<typeof import('../../../src/material/geometry/PrepareHatchingGeometryOptions.js')>()),
  MANY_TRIANGLES: 400,
}));

const SMALL_MAP = { size: 64, tones: 4 } as const;

/** A hatcher of a box, and a function that waits until it is idle. */
function atWork(options: ApplyHatchingOptions) {
  const mesh = new Mesh<BufferGeometry>(new BoxGeometry(), new MeshBasicMaterial());
  const root = new Group().add(mesh);
  const errors: unknown[] = [];
  const hatched: HatchedScene[] = [];
  let invalidate = (): void => {};
  const formed = new Promise<void>((resolve) => {
    invalidate = resolve;
  });
  const waiting: (() => void)[] = [];
  const told = (): void => {
    for (const go of waiting.splice(0)) go();
  };
  const hatcher = new Hatcher(root, false, {
    onHatched: (scene) => {
      hatched.push(scene);
      told();
    },
    invalidate: () => invalidate(),
    onError: (error) => {
      errors.push(error);
      told();
    },
  });
  const next = () => new Promise<void>((go) => waiting.push(go));
  hatcher.update(options);
  return { mesh, root, hatcher, errors, hatched, formed, next };
}

const materialOf = ({ material }: Mesh): HatchingMaterial => {
  expect(material).toBeInstanceOf(HatchingMaterial);
  return material as unknown as HatchingMaterial;
};

test('values change in place: the geometry, the material and the outlines stay', async () => {
  const { mesh, hatcher, hatched, next } = atWork({ preset: 'technical' });
  await next();
  const [geometry, material, lines] = [mesh.geometry, materialOf(mesh), mesh.children[0]];
  hatcher.update({ preset: 'engraving', material: { ink: '#123456', direction: 'light' }, outlines: { taper: 0 } });
  await next();
  expect([mesh.geometry, mesh.material, mesh.children[0]]).toEqual([geometry, material, lines]);
  expect(material.ink.getHexString()).toBe('123456');
  expect([material.direction, material.irregularity]).toEqual(['light', presets.engraving.material.irregularity]);
  const [{ material: look }] = hatched[0].outlines;
  // Those of `technical`, which draws outlines of even weight; `engraving` leaves them at their defaults.
  expect([look.taper, look.weights.creases, look.weights.lit, look.weights.shade]).toEqual([0, 0.35, 0.7, 1.7]);
  hatcher.update({ preset: 'engraving', material: { direction: 'light' } });
  await next();
  expect(look.taper).toBe(0.8);
  const outlines = (weights: object) => ({ preset: 'engraving', outlines: { weights } }) as const;
  hatcher.update({ ...outlines({ creases: 0 }), material: { direction: 'light' } });
  await next();
  hatcher.update({ ...outlines({ shade: 3 }), material: { direction: 'light' } });
  await next();
  expect([look.weights.creases, look.weights.shade]).toEqual([0.35, 3]);
  hatcher.update({ preset: 'engraving', material: { direction: 'light' } });
  await next();
  expect(look.weights.shade).toBe(1.7);
  expect(materialOf(mesh).ink.getHexString()).toBe('1c1a17');
});

test('lines that leave it to the shape hatch anew, as they need other geometry', async () => {
  const { mesh, hatcher, next } = atWork({ preset: 'technical' });
  await next();
  const { geometry } = mesh;
  hatcher.update({ preset: 'engraving' });
  await next();
  expect(mesh.geometry).not.toBe(geometry);
});

test('strokes that come to follow the form hatch anew, and turn across it or to another angle in place', async () => {
  const { mesh, hatcher, next } = atWork({ tonalArtMap: SMALL_MAP });
  await next();
  const geometries = [mesh.geometry];
  for (const material of [
    { direction: 'form' },
    { direction: 'acrossForm' },
    { direction: 'acrossForm', crossAngle: 1 },
    { direction: 'light' },
    { technique: 'engraving', direction: 'form' },
  ] as const) {
    hatcher.update({ tonalArtMap: SMALL_MAP, material });
    await next();
    expect(materialOf(mesh).direction).toBe('direction' in material ? material.direction : 'light');
    geometries.push(mesh.geometry);
  }
  const [light, form, across, atAngle, lightAgain, lines] = geometries;
  expect(form).not.toBe(light);
  expect(across).toBe(form);
  expect(atAngle).toBe(form);
  expect(lightAgain).not.toBe(form);
  expect(lines).not.toBe(form);
  expect(lines.hasAttribute('formValue')).toBe(true);
});

test('a technique that needs other geometry, other creases and other options of the bake hatch anew', async () => {
  const { mesh, hatcher, next } = atWork({ preset: 'technical' });
  await next();
  const plain = { preset: 'technical', outlines: false } as const;
  const rounded = { ...plain, smoothingRadius: 0.1 };
  for (const [options, isBaked] of [
    [{ preset: 'technical', outlines: { featureAngle: 1 } }, true],
    [plain, true],
    [{ ...plain, material: { tilesPerObjectUnit: 2 } }, false],
    [plain, false],
    [rounded, true],
    // An option that is left out returns to its default.
    [plain, true],
    [{ ...rounded, material: { technique: 'adjacency' }, tonalArtMap: SMALL_MAP }, true],
  ] as [ApplyHatchingOptions, boolean][]) {
    const before = mesh.geometry;
    hatcher.update(options);
    await next();
    expect(mesh.geometry !== before, JSON.stringify(options)).toBe(isBaked);
  }
  expect(mesh.geometry.userData.hatching.layout).toBe('corner');
  expect(mesh.children).toEqual([]);
});

test('a map is drawn once something is drawn with it', async () => {
  const shared = vi.spyOn(TonalArtMap, 'shared');
  const progress: number[] = [];
  const tonalArtMap = { ...SMALL_MAP, seed: 7 };
  const options = { tonalArtMap, onProgress: (share: number) => void progress.push(share) };
  const { mesh, hatcher, errors, next } = atWork({ ...options, material: { technique: 'engraving' } });
  await next();
  expect(materialOf(mesh)).toMatchObject({ technique: 'engraving', tonalArtMap: 'hatching' });
  expect(progress.at(-1)).toBe(1);
  // If the geometry serves both, it is set in place; otherwise the geometry is prepared again.
  hatcher.update({ ...options, material: () => ({ technique: 'engraving', ink: 'navy' }) });
  await next();
  expect(shared).not.toHaveBeenCalled();
  hatcher.update({ ...options, material: { technique: 'engraving' } });
  await next();
  const { geometry } = mesh;
  for (const technique of ['hatching', 'engraving', 'hatching', 'adjacency'] as const) {
    hatcher.update({ ...options, material: { technique } });
    await next();
    expect(mesh.geometry === geometry, technique).toBe(technique !== 'adjacency');
    const map = materialOf(mesh).tonalArtMap;
    if (technique === 'engraving') expect(map).toBe('hatching');
    else expect(map).toBeInstanceOf(TonalArtMap);
  }
  expect([new Set(shared.mock.results.map(({ value }) => value)).size, errors]).toEqual([1, []]);
  expect(progress.every((share) => share >= 0 && share <= 1)).toBe(true);
  hatcher.dispose();
  shared.mockRestore();
});

test('one map serves all who ask for the same, and leaves the graphics card with the last of them', async () => {
  const [one, other] = [1, 2].map(() => atWork({ tonalArtMap: { ...SMALL_MAP, seed: 3 } }));
  await Promise.all([one.next(), other.next()]);
  const map = materialOf(one.mesh).tonalArtMap as TonalArtMap;
  expect(materialOf(other.mesh).tonalArtMap).toBe(map);
  let freed = 0;
  map.texture.addEventListener('dispose', () => freed++);
  one.hatcher.dispose();
  await new Promise((go) => setTimeout(go));
  expect(freed).toBe(0);
  other.hatcher.update({ tonalArtMap: { ...SMALL_MAP, seed: 4 } });
  await other.next();
  await eventually(() => expect(freed).toBe(1));
  expect(materialOf(other.mesh).tonalArtMap).not.toBe(map);
});

test('meshes that come, and other geometries and materials, are hatched with the next frame', async () => {
  const { mesh, root, hatcher, hatched, next } = atWork({ preset: 'technical' });
  await next();
  hatcher.follow();
  expect(hatched).toHaveLength(1);
  const second = new Mesh<BufferGeometry>(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
  root.add(new Group().add(second));
  hatcher.follow();
  await next();
  materialOf(second);
  second.geometry = new BoxGeometry();
  const plain = new MeshBasicMaterial({ color: '#ff0000' });
  mesh.material = plain;
  hatcher.follow();
  await next();
  expect(materialOf(mesh).color.getHexString()).toBe('ff0000');
  expect(second.geometry.userData.hatching.triangles).toBe(12);
  root.remove(second.parent!);
  hatcher.follow();
  await next();
  expect(hatched.at(-1)!.materials).toEqual([mesh.material]);
  hatcher.dispose();
  expect(mesh.material).toBe(plain);
});

test('what is not hatched yet is not drawn, and is in its layers afterwards, its outlines too', async () => {
  const { mesh, root, hatcher, next } = atWork({ preset: 'technical' });
  expect(mesh.layers.mask).toBe(0);
  await next();
  expect([mesh.layers.mask, mesh.children[0].layers.mask]).toEqual([1, 1]);
  const second = new Mesh<BufferGeometry>(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
  second.layers.set(3);
  root.add(second);
  hatcher.follow();
  expect([mesh.layers.mask, second.layers.mask]).toEqual([1, 0]);
  await next();
  expect([second.layers.mask, second.children[0].layers.mask]).toEqual([8, 8]);
  root.add(new Mesh(new BoxGeometry(), new MeshBasicMaterial()));
  hatcher.follow();
  hatcher.dispose();
  expect(root.children.map(({ layers }) => layers.mask)).toEqual([1, 8, 1]);
});

test('what changes while geometry is being prepared is hatched right after', async () => {
  const { mesh, root, hatcher, hatched, errors } = atWork({ preset: 'technical' });
  await new Promise((go) => setTimeout(go));
  const second = new Mesh<BufferGeometry>(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
  root.add(second);
  const other = new SphereGeometry(2, 8, 6);
  mesh.geometry = other;
  hatcher.update({ preset: 'technical', material: { ink: '#abcdef' } });
  await eventually(() => expect(materialOf(mesh).ink.getHexString()).toBe('abcdef'));
  materialOf(second);
  expect(mesh.geometry.boundingSphere!.radius).toBeCloseTo(2);
  expect([hatched.at(-1)!.skipped, errors]).toEqual([[], []]);
});

test('an error is told once, and tried again when something changes', async () => {
  const { mesh, hatcher, errors, next } = atWork({ preset: 'technical', creaseAngle: 90 });
  await next();
  expect(String(errors[0])).toContain('creaseAngle is 90');
  hatcher.follow();
  hatcher.update({ preset: 'technical', creaseAngle: 90 });
  await new Promise((go) => setTimeout(go));
  expect(errors).toHaveLength(1);
  expect(mesh.material).toBeInstanceOf(MeshBasicMaterial);
  hatcher.update({ preset: 'technical' });
  await next();
  materialOf(mesh);
});

test('a hand with a fault is told once, and the one before it stays', async () => {
  const [hand, other] = [exampleHand('brush'), exampleHand('reedPen')];
  const { mesh, hatcher, errors, next } = atWork({ preset: 'pen', material: { hand } });
  await next();
  const material = materialOf(mesh);
  const dots = { ...hand, strokes: [{ points: [1, 1, 1.1, 1], widths: [1, 1] }] };
  hatcher.update({ preset: 'pen', material: { hand: dots } });
  await next();
  hatcher.update({ preset: 'pen', material: { hand: { ...dots } } });
  await new Promise((go) => setTimeout(go));
  expect(errors.map(String)).toEqual([expect.stringMatching(/: all strokes are dots.*\.$/)]);
  expect(materialOf(mesh)).toBe(material);
  expect(material.hand).toBe(hand);
  hatcher.update({ preset: 'pen', material: { hand: other } });
  await next();
  expect(materialOf(mesh).hand).toBe(other);
});

test('whoever is disposed of at work leaves the scene to the next, as in StrictMode', async () => {
  const { mesh, root, hatcher, errors, hatched } = atWork({ preset: 'technical' });
  const [geometry, material] = [mesh.geometry, mesh.material];
  hatcher.dispose();
  const done = await new Promise<HatchedScene>((onHatched, onError) => {
    new Hatcher(root, false, { onHatched, invalidate: () => {}, onError }).update({ preset: 'technical' });
  });
  materialOf(mesh);
  done.dispose();
  expect([mesh.geometry, mesh.material]).toEqual([geometry, material]);
  expect([errors, hatched]).toEqual([[], []]);
});

test('other functions alone change nothing, and the newest are called', async () => {
  const called: string[] = [];
  const withFilter = (name: string): ApplyHatchingOptions => ({
    preset: 'technical',
    filter: () => {
      called.push(name);
      return true;
    },
  });
  const { root, hatcher, hatched, next } = atWork(withFilter('first'));
  await next();
  hatcher.update(withFilter('second'));
  hatcher.follow();
  expect(hatched).toHaveLength(1);
  called.length = 0;
  root.add(new Mesh(new BoxGeometry(), new MeshBasicMaterial()));
  hatcher.follow();
  await next();
  expect(new Set(called)).toEqual(new Set(['second']));
});

test('changes within a material, by state or in place, are followed, and nothing is hatched again', async () => {
  const { mesh, hatcher, hatched, next } = atWork({ preset: 'technical', material: { side: DoubleSide } });
  const own = mesh.material as MeshBasicMaterial;
  await next();
  const [geometry, material] = [mesh.geometry, materialOf(mesh)];
  own.color.set('hotpink');
  const map = new Texture();
  Object.assign(own, { opacity: 0.5, transparent: true, map, wireframe: true, visible: false, side: BackSide });
  hatcher.follow();
  // three.js asks for it before it draws.
  expect(material.visible).toBe(false);
  expect(material.color.getHexString()).toBe('ff69b4');
  expect(material).toMatchObject({ opacity: 0.5, transparent: true, map, wireframe: true });
  // Props of <Hatched>, and values set on the new material, stay.
  expect(material.side).toBe(DoubleSide);
  material.color.set('navy');
  own.color.set('orange');
  own.map = null;
  hatcher.follow();
  expect(material.visible).toBe(false);
  expect([material.color.getHexString(), material.map]).toEqual(['000080', null]);
  expect([mesh.geometry, mesh.material, hatched.length]).toEqual([geometry, material, 1]);
});

test('a helper may swap materials of its own and of others: it is left alone, and nothing is hatched again', async () => {
  const { mesh, root, hatcher, hatched, errors, next } = atWork({ preset: 'technical' });
  const own = mesh.material;
  const helper = new Mesh<BufferGeometry, Material>(new BoxGeometry(), new ShaderMaterial());
  root.add(helper);
  hatcher.follow();
  expect(helper.layers.mask).toBe(1);
  await next();
  await new Promise((go) => setTimeout(go));
  const [look, count] = [mesh.material, hatched.length];
  for (let frame = 0; frame < 3; frame++) {
    // Like an accumulated shadow, it restores the values it found on mounting.
    mesh.material = own;
    helper.material = new ShaderMaterial();
    hatcher.follow();
    expect([mesh.material, mesh.layers.mask, helper.layers.mask]).toEqual([look, 1, 1]);
  }
  root.add(new Mesh(new BoxGeometry(), new ShaderMaterial()));
  hatcher.follow();
  await new Promise((go) => setTimeout(go));
  expect([hatched.length, errors]).toEqual([count, []]);
});

test('helpers alone are waited with, until there is something to hatch', async () => {
  const { mesh, root, hatcher, errors, hatched, next } = atWork({ preset: 'technical' });
  await next();
  mesh.userData.hatching = false;
  hatcher.follow();
  await next();
  expect([errors, hatched.at(-1)!.materials]).toEqual([[], []]);
  const added = new Mesh<BufferGeometry>(new BoxGeometry(), new MeshBasicMaterial());
  root.add(added);
  hatcher.follow();
  await next();
  materialOf(added);
  expect(mesh.material).toBeInstanceOf(MeshBasicMaterial);
});

test('a large mesh that follows the form only later is drawn once more, and not hatched again', async () => {
  const { mesh, hatcher, hatched, formed, next } = atWork({ preset: 'technical' });
  await next();
  mesh.geometry = new TorusGeometry(1, 0.4, 16, 32);
  hatcher.update({ material: { technique: 'engraving', direction: 'form' } });
  await Promise.all([next(), formed]);
  const { geometry } = mesh;
  expect(geometry.hasAttribute('formValue')).toBe(true);
  hatcher.follow();
  hatcher.update({ material: { technique: 'engraving', direction: 'form', ink: '#123456' } });
  await next();
  expect(materialOf(mesh).ink.getHexString()).toBe('123456');
  expect(mesh.geometry).toBe(geometry);
  expect(hatched).toHaveLength(3);
});

test('at another angle of crossing lines geometry is baked anew, and with other values it stays', async () => {
  const { mesh, hatcher, hatched, next } = atWork({ preset: 'technical' });
  await next();
  mesh.geometry = new TorusGeometry(1, 0.4, 8, 16);
  const material = { technique: 'engraving', direction: 'form', crossAngle: 1 } as const;
  const geometries = [];
  for (const change of [{}, { crossAngle: 1.2 }, { crossAngle: 1.2, ink: '#123456' }]) {
    hatcher.update({ material: { ...material, ...change } });
    await next();
    geometries.push(mesh.geometry);
  }
  const [first, turned, coloured] = geometries;
  expect(turned).not.toBe(first);
  expect(coloured).toBe(turned);
  expect(materialOf(mesh).ink.getHexString()).toBe('123456');
  expect(hatched).toHaveLength(4);
});

test('one handle serves all looks: no mesh is unhatched in between, and its background is that of the look', async () => {
  const { mesh, hatcher, hatched, next } = atWork({ preset: 'pen', tonalArtMap: SMALL_MAP });
  await next();
  const [handle] = hatched;
  const looks: unknown[] = [];
  for (const preset of ['chalk', 'engraving', 'technical', 'pen'] as const) {
    hatcher.update({ preset, tonalArtMap: SMALL_MAP });
    while (hatched.length === looks.length + 1) {
      expect([mesh.material, mesh.layers.mask]).toEqual([handle.materialOf(mesh), 1]);
      await new Promise((go) => setTimeout(go));
    }
    expect(hatched.at(-1)).toBe(handle);
    expect(handle.background.equals(materialOf(mesh).paper)).toBe(true);
    looks.push(`#${materialOf(mesh).paper.getHexString()}`);
  }
  expect(looks).toEqual(
    ['chalk', 'engraving', 'technical', 'pen'].map((name) => presets[name as 'pen'].material.paper),
  );
  expect(mesh.children).toHaveLength(1);
});

test('meshes without geometry and material, as React leaves those that it removes, are waited with and given back', async () => {
  const { mesh, root, hatcher, errors, hatched, next } = atWork({ preset: 'technical' });
  const late = new InstancedMesh(null! as BufferGeometry, null! as Material, 2);
  late.visible = false;
  root.add(late);
  hatcher.follow();
  await next();
  Object.assign(late, { geometry: new BoxGeometry(), material: new MeshBasicMaterial(), visible: true });
  hatcher.follow();
  await next();
  expect(late.material).toBe(hatched[0].materialOf(late));
  // A removal, and then another one in the frame in which everything is unmounted.
  Object.assign(late, { geometry: null, material: null });
  late.removeFromParent();
  hatcher.follow();
  await next();
  Object.assign(mesh, { geometry: null, material: null });
  hatcher.dispose();
  expect([late.geometry, late.material, mesh.geometry, mesh.material, errors]).toEqual([null, null, null, null, []]);
});
