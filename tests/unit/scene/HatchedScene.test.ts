import {
  BoxGeometry,
  type BufferGeometry,
  Color,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type Object3D,
  ShaderMaterial,
  SphereGeometry,
  Texture,
} from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { bakeOcclusion, presets } from '../../../src/index.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { HatchingOutlineMaterial } from '../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HATCHING_OUTLINE_DEFAULTS } from '../../../src/material/outlines/outlineProperties.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { reactive } from '../material/geometry/reactive.js';
import { disposals, looksOf, hatched as materialOf } from './hatchedScenes.js';

afterEach(() => vi.restoreAllMocks());

const crate = (color = 'white') => new Mesh(new BoxGeometry(), new MeshStandardMaterial({ color }));
const ball = () => new Mesh(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
const said = () => {
  const spy = vi.spyOn(console, 'warn').mockImplementation(() => {});
  return () => spy.mock.calls.map(([sentence]) => String(sentence));
};
const hex = (color: Color) => color.getHexString();
const outlineMaterial = (mesh: Mesh) => (mesh.children[0] as Mesh).material as unknown as HatchingOutlineMaterial;

describe('the call', () => {
  test('takes a preset and options, a whole preset and options, or options alone', async () => {
    const { signal } = new AbortController();
    const seen = [];
    for (const args of [
      ['technical', { signal, outlines: false }],
      [presets.technical, { signal, outlines: false }],
      [{ preset: 'technical', signal, outlines: false }],
      [{ preset: 'technical' }, { signal, outlines: false }],
    ] as Parameters<typeof applyHatching> extends [unknown, ...infer Rest] ? Rest[] : never) {
      const mesh = crate();
      const { materials, outlines } = await applyHatching(mesh, ...args);
      seen.push([materials[0].technique, outlines.length]);
    }
    expect(new Set(seen.map(String)).size).toBe(1);
    expect(seen[0]).toEqual([presets.technical.material.technique, 0]);
    await expect(applyHatching(crate(), 'pen', { signal: AbortSignal.abort(new Error('late')) })).rejects.toThrow(
      'late',
    );
  });

  test('of two for one root the later wins; the earlier ends with an AbortError that needs no handler', async () => {
    const unhandled = vi.fn();
    process.on('unhandledRejection', unhandled);
    const mesh = crate();
    const first = applyHatching(mesh, 'technical');
    const second = applyHatching(mesh, 'engraving');
    const hatched = await second;
    expect(hatched.materialOf(mesh)).toBe(mesh.material);
    await new Promise((resume) => setTimeout(resume));
    expect(unhandled).not.toHaveBeenCalled();
    process.off('unhandledRejection', unhandled);
    await expect(first).rejects.toMatchObject({ name: 'AbortError' });
    expect(materialOf(mesh).lineSpacing).toBe(presets.engraving.material.lineSpacing);
  });

  test.each<[string, () => Object3D]>([
    ['an empty root', () => new Group()],
    ['one whose meshes are all left alone', () => new Group().add(new Mesh(new BoxGeometry(), new ShaderMaterial()))],
  ])('%s gives an empty handle and one sentence, and update() finds what is added', async (_, make) => {
    const warnings = said();
    const root = make();
    const hatched = await applyHatching(root, 'technical');
    expect(warnings()).toEqual([expect.stringContaining('update()')]);
    expect([hatched.materials, hatched.outlines, hatched.skipped.length]).toEqual([[], [], root.children.length]);
    const added = crate();
    root.add(added);
    expect(await hatched.update()).toBe(hatched);
    expect(hatched.materials).toEqual([materialOf(added)]);
    expect(hatched.skipped).toHaveLength(root.children.length - 1);
    expect(warnings()).toHaveLength(1);
    hatched.dispose();
    expect(added.material).toBeInstanceOf(MeshStandardMaterial);
  });
});

describe('update', () => {
  test('hatches what was added, with the materials and sizes of before, and releases what is gone', async () => {
    const [kept, gone] = [crate(), ball()];
    const root = new Group().add(kept, gone);
    const hatched = await applyHatching(root, 'pen');
    const { tilesPerObjectUnit } = materialOf(kept);
    const { extent } = hatched.composition;
    const freed = disposals();
    freed.watch([gone.geometry, gone.material as Material]);
    const added = new Mesh(new SphereGeometry(50, 8, 6), kept.userData.source ?? new MeshStandardMaterial());
    const sharing = new Mesh(new BoxGeometry(), (await sourceOf(kept, hatched)) as Material);
    root.remove(gone);
    root.add(added, sharing);
    const before = kept.material;
    const ready = hatched.update();
    expect([added.material, gone.material]).toEqual([expect.any(MeshStandardMaterial), expect.any(HatchingMaterial)]);
    await ready;
    expect(kept.material).toBe(before);
    expect(sharing.material, 'one source, one material').toBe(before);
    expect(materialOf(added).tilesPerObjectUnit).toBe(tilesPerObjectUnit);
    expect(materialOf(added).composition.extent).toBe(extent);
    expect(extent!.box.max.x).toBeGreaterThan(40);
    expect(gone.material).toBeInstanceOf(MeshBasicMaterial);
    expect([gone.children, freed.count]).toEqual([[], 2]);
    expect(hatched.materialOf(gone)).toBeUndefined();
    expect(hatched.outlines).toHaveLength(3);
  });

  test('releases what only moved out, and another handle takes it', async () => {
    const mesh = crate();
    const [here, there] = [new Group().add(mesh, crate()), new Group().add(crate())];
    const [one, other] = [await applyHatching(here, 'technical'), await applyHatching(there, 'technical')];
    there.add(mesh);
    await one.update();
    expect(mesh.material).toBeInstanceOf(MeshStandardMaterial);
    await other.update();
    expect(other.materialOf(mesh)).toBe(mesh.material);
  });

  test('hatches anew what was given another geometry or material, and sets again what was set back', async () => {
    const [changed, recoloured, reset] = [crate(), crate(), crate()];
    const sources = [changed, recoloured, reset].map(({ geometry, material }) => ({ geometry, material }));
    const root = new Group().add(changed, recoloured, reset);
    const hatched = await applyHatching(root, 'technical');
    const look = { geometry: reset.geometry, material: reset.material };
    Object.assign(reset, sources[2]);
    changed.geometry = new BoxGeometry(2, 2, 2);
    const own = new MeshStandardMaterial({ color: 'tomato' });
    recoloured.material = own;
    await hatched.update();
    expect({ geometry: reset.geometry, material: reset.material }).toEqual(look);
    expect(changed.geometry.boundingBox!.max.x).toBe(1);
    expect(hex(materialOf(recoloured as never).color)).toBe('ff6347');
    hatched.dispose();
    expect(recoloured.material).toBe(own);
    expect(recoloured.geometry).toBe(sources[1].geometry);
  });

  test('that is aborted, or superseded, changes nothing and leaves no claim', async () => {
    const root = new Group().add(crate());
    const hatched = await applyHatching(root, 'technical');
    const added = crate();
    root.add(added);
    const stop = new AbortController();
    const aborted = hatched.update({ signal: stop.signal });
    stop.abort(new Error('enough'));
    await expect(aborted).rejects.toThrow('enough');
    expect(added.material).toBeInstanceOf(MeshStandardMaterial);
    const earlier = hatched.update();
    const later = hatched.update();
    await later;
    await expect(earlier).rejects.toMatchObject({ name: 'AbortError' });
    expect(materialOf(added)).toBe(hatched.materialOf(added));
  });

  test('ends with dispose(), even if there is nothing to hatch', async () => {
    const hatched = await applyHatching(crate(), 'technical');
    const ready = hatched.update();
    hatched.dispose();
    await expect(ready).rejects.toMatchObject({ name: 'AbortError' });
    expect(hatched.materials).toEqual([]);
  });

  test('reports its progress', async () => {
    const root = new Group().add(crate());
    const hatched = await applyHatching(root, 'technical');
    root.add(ball());
    const seen: number[] = [];
    await hatched.update({ onProgress: (value) => seen.push(value) });
    expect(seen.at(-1)).toBe(1);
  });

  test('rejects after dispose()', async () => {
    const hatched = await applyHatching(crate(), 'technical');
    hatched.dispose();
    await expect(hatched.update()).rejects.toThrow('disposed of');
  });
});

/** The source of a hatched mesh. */
async function sourceOf(mesh: Mesh, hatched: { restore(): void; update(): Promise<unknown> }) {
  hatched.restore();
  const { material } = mesh;
  await hatched.update();
  return material;
}

describe('setPreset', () => {
  test('changes the look in place: the same handle, meshes, materials and outlines', async () => {
    const root = new Group().add(crate(), ball());
    const before = looksOf(root);
    const hatched = await applyHatching(root, 'technical');
    const [mesh] = root.children as Mesh[];
    const [material, outlines] = [materialOf(mesh), hatched.outlineOf(mesh)!];
    const shown = looksOf(root);
    const ready = hatched.setPreset('engraving');
    expect(looksOf(root), 'nothing changes before it is ready').toEqual(shown);
    expect(await ready).toBe(hatched);
    expect(mesh.material).toBe(material);
    expect(hatched.materialOf(mesh)).toBe(material);
    expect(material.lineSpacing).toBe(presets.engraving.material.lineSpacing);
    expect(hatched.outlineOf(mesh)).toBe(outlines);
    expect(outlines.material.outlineWidth).toBe(presets.engraving.outlines.outlineWidth);
    await hatched.setPreset('pen', { outlines: false });
    expect([mesh.children, hatched.outlines]).toEqual([[], []]);
    await hatched.setPreset('banknote');
    expect(hatched.outlines).toHaveLength(2);
    hatched.dispose();
    expect(looksOf(root)).toEqual(before);
  });

  test('keeps what was changed on materials, sources and outlines, also meanwhile', async () => {
    const mesh = crate();
    const source = mesh.material;
    const hatched = await applyHatching(mesh, 'technical');
    const material = materialOf(mesh);
    material.ink.set('#123456');
    material.opacity = 0.5;
    material.perTriangle.blendAngle = 1;
    outlineMaterial(mesh).outlineWidth = 9;
    outlineMaterial(mesh).weights.borders = 0.1;
    source.color.set('red');
    // The listener is called when the new materials are there already.
    const onProgress = () => {
      material.lineSpacing = 17;
      source.side = 2;
    };
    await hatched.setPreset('engraving', { onProgress });
    expect(material).toMatchObject({ opacity: 0.5, lineSpacing: 17, visible: true, side: 2 });
    expect([hex(material.ink), hex(material.color)]).toEqual(['123456', 'ff0000']);
    expect(material.perTriangle).toMatchObject({ blendAngle: 1, levelRule: 'derivatives' });
    const { weights, outlineWidth } = outlineMaterial(mesh);
    expect(outlineWidth).toBe(9);
    expect({ ...weights }, 'weights are kept one by one').toEqual({
      ...HATCHING_OUTLINE_DEFAULTS.weights,
      borders: 0.1,
    });
    expect(material.crossFrom, 'the rest is that of the preset').toBe(presets.engraving.material.crossFrom);
    source.color.set('lime');
    expect(material.visible && hex(material.color), 'it is still followed').toBe('00ff00');
    await hatched.setPreset('pen');
    expect(material).toMatchObject({ opacity: 0.5, lineSpacing: 17 });
    await hatched.setPreset({ preset: 'pen', material: { ink: '#654321' } });
    expect(hex(material.ink), 'what is passed counts more').toBe('654321');
    await hatched.setPreset('pen', { outlines: { weights: { lit: 1 } } });
    expect(outlineMaterial(mesh).weights).toMatchObject({ borders: 0.1, lit: 1 });
    await hatched.setPreset({ preset: 'pen', outlines: { weights: { borders: 2 } } });
    expect(outlineMaterial(mesh).weights.borders).toBe(2);
  });

  test('reaches parts that are detached at the time, with their changes', async () => {
    const [mesh, part] = [crate(), crate('gold')];
    const root = new Group().add(mesh, part);
    const hatched = await applyHatching(root, 'technical');
    materialOf(part).ink.set('#123456');
    root.remove(part);
    await hatched.setPreset('engraving');
    root.add(part);
    expect(materialOf(part).lineSpacing).toBe(presets.engraving.material.lineSpacing);
    expect(hex(materialOf(part).ink)).toBe('123456');
    expect(hatched.materialOf(part)).toBe(part.material);
  });

  test('hatches what was added, too, and an update under way does not lose it', async () => {
    const root = new Group().add(crate());
    const hatched = await applyHatching(root, 'technical');
    const added = ball();
    root.add(added);
    const switching = hatched.setPreset('engraving');
    const updating = hatched.update();
    await updating;
    await expect(switching).rejects.toMatchObject({ name: 'AbortError' });
    for (const mesh of root.children) {
      expect(materialOf(mesh as Mesh).lineSpacing).toBe(presets.engraving.material.lineSpacing);
    }
  });

  test('of two the later wins, and one that fails or is aborted changes nothing', async () => {
    const root = new Group().add(crate(), ball());
    const hatched = await applyHatching(root, 'technical');
    const earlier = hatched.setPreset('pen');
    await hatched.setPreset('engraving');
    await expect(earlier).rejects.toMatchObject({ name: 'AbortError' });
    const shown = looksOf(root);
    const stop = new AbortController();
    const aborted = hatched.setPreset('chalk', { signal: stop.signal });
    stop.abort();
    await expect(aborted).rejects.toThrow('abort');
    await expect(hatched.setPreset({ creaseAngle: 90 })).rejects.toThrow('creaseAngle');
    await expect(hatched.setPreset(undefined as never)).rejects.toThrow('the options are undefined. Pass an object');
    await expect(hatched.setPreset('crayon' as never)).rejects.toThrow('no preset "crayon"');
    expect(looksOf(root)).toEqual(shown);
    const added = crate();
    root.add(added);
    await hatched.update();
    expect(materialOf(added).lineSpacing, 'the aborted look is forgotten').toBe(presets.engraving.material.lineSpacing);
  });

  test('keeps occlusion where it keeps the geometry, and restore() gives the former geometry back', async () => {
    const [one, other] = [crate(), crate()];
    other.position.y = 1.2;
    const { geometry } = one;
    other.geometry = geometry;
    const root = new Group().add(one, other);
    const hatched = await applyHatching(root, 'charcoal', { tonalArtMap: null });
    const bake = await bakeOcclusion(root, { directions: 64 });
    const own = [one.geometry, other.geometry];
    expect(own[0] === own[1]).toBe(false);
    await hatched.setPreset('chalk', { tonalArtMap: null });
    expect(one.geometry === own[0] && other.geometry === own[1]).toBe(true);
    await hatched.update();
    expect(one.geometry === own[0]).toBe(true);
    hatched.dispose();
    expect(one.geometry === geometry && other.geometry === geometry).toBe(true);
    bake.dispose();
  });

  test('bakes no geometry again that it can use, and frees what it replaces', async () => {
    const mesh = crate();
    const hatched = await applyHatching(mesh, 'charcoal', { tonalArtMap: null });
    const light = mesh.geometry;
    await hatched.setPreset('chalk', { tonalArtMap: null });
    expect(mesh.geometry).toBe(light);
    await hatched.setPreset('pencil', { tonalArtMap: null });
    const { geometry } = mesh;
    expect(geometry).not.toBe(light);
    await hatched.setPreset('pencil', { tonalArtMap: null });
    expect(mesh.geometry).toBe(geometry);
    const freed = disposals();
    freed.watch([geometry]);
    await hatched.setPreset({ tonalArtMap: null, adjacency: true });
    expect(freed.count).toBe(1);
  });
});

describe('release', () => {
  test('gives a part back and frees it; nothing is left after a hundred swaps', async () => {
    const root = new Group().add(crate());
    const hatched = await applyHatching(root, 'technical');
    const freed = disposals();
    for (let i = 0; i < 100; i++) {
      const part = new Group().add(ball());
      root.add(part);
      await hatched.update();
      const mesh = part.children[0] as Mesh;
      freed.watch([mesh.geometry, mesh.material as Material, outlineMaterial(mesh) as never]);
      hatched.release(part);
      root.remove(part);
      expect([mesh.material, mesh.children.length]).toEqual([expect.any(MeshBasicMaterial), 0]);
    }
    expect(freed.count).toBe(300);
    expect([hatched.materials.length, hatched.outlines.length]).toEqual([1, 1]);
  });

  test('keeps what other parts share', async () => {
    const [one, other] = [crate(), crate()];
    Object.assign(other, { geometry: one.geometry, material: one.material });
    const hatched = await applyHatching(new Group().add(one, other), 'technical');
    const freed = disposals();
    freed.watch([other.geometry, other.material as Material]);
    hatched.release(one);
    expect(freed.count).toBe(0);
    hatched.release(other);
    expect(freed.count).toBe(2);
  });

  test('counts for a call under way, too', async () => {
    const [one, other] = [crate(), ball()];
    const hatched = await applyHatching(new Group().add(one, other), 'technical');
    const ready = hatched.setPreset('engraving');
    hatched.release(other);
    await ready;
    expect([one.material, other.material]).toEqual([expect.any(HatchingMaterial), expect.any(MeshBasicMaterial)]);
    expect(other.children).toEqual([]);
    await hatched.update();
    expect(materialOf(other)).toBe(hatched.materialOf(other));
  });
});

describe('the materials of the scene', () => {
  const opacityOf = (mesh: Mesh) => {
    // As the renderer does just before it sorts a mesh into a render list.
    const { visible, transparent, opacity } = mesh.material as Material;
    return { visible, transparent, opacity };
  };

  test('stay the truth: what is changed in them counts when a frame is drawn', async () => {
    const mesh = crate();
    const source = mesh.material;
    await applyHatching(mesh, 'technical');
    const material = materialOf(mesh);
    Object.assign(source, { opacity: 0.4, transparent: true });
    expect(opacityOf(mesh)).toEqual({ visible: true, transparent: true, opacity: 0.4 });
    source.visible = false;
    expect(opacityOf(mesh).visible).toBe(false);
    source.visible = true;
    source.map = new Texture();
    expect(opacityOf(mesh).visible, 'and is shown again').toBe(true);
    expect(material.map).toBe(source.map);
    material.visible = false;
    source.opacity = 0.7;
    expect(opacityOf(mesh), 'what was set on the hatched material stays').toMatchObject({
      visible: false,
      opacity: 0.7,
    });
  });

  test('are no longer followed once the scene is disposed of', async () => {
    const mesh = crate();
    const source = mesh.material;
    const hatched = await applyHatching(mesh, 'technical');
    const material = materialOf(mesh);
    hatched.dispose();
    source.visible = false;
    expect(Object.getOwnPropertyDescriptor(material, 'visible')).toMatchObject({ value: true, writable: true });
  });

  test('fading all materials of a part fades that part alone', async () => {
    const [part, other] = [new Group().add(crate('gold')), crate()];
    await applyHatching(new Group().add(part, other), 'technical');
    part.traverse((object) => {
      const { material } = object as Mesh;
      if (material) Object.assign(material, { opacity: 0.3, transparent: true });
    });
    expect(materialOf(other)).toMatchObject({ opacity: 1, transparent: false });
    expect(outlineMaterial(other).opacity).toBe(1);
    expect(materialOf(part.children[0] as Mesh).opacity).toBe(0.3);
  });
});

describe('the parts of the result', () => {
  test('are found by mesh, and the paper is a colour to clear with', async () => {
    const [mesh, split, stray] = [crate(), crate(), crate()];
    split.material = [new MeshBasicMaterial(), new ShaderMaterial()] as never;
    const hatched = await applyHatching(new Group().add(mesh, split), 'chalk', { tonalArtMap: null });
    expect(hatched.materialOf(mesh)).toBe(mesh.material);
    expect(hatched.materialOf(split)).toEqual(split.material);
    expect(hatched.outlineOf(mesh)).toBe(mesh.children[0]);
    expect([hatched.materialOf(stray), hatched.outlineOf(stray)]).toEqual([undefined, undefined]);
    const { background } = hatched;
    expect(hex(background)).toBe(hex(new Color(presets.chalk.material.paper as string)));
    materialOf(mesh).paper.set('#ffeedd');
    expect(hex(hatched.background)).toBe('ffeedd');
    expect(hatched.background).toBe(background);
    expect(hex((await applyHatching(new Group(), 'chalk')).background)).toBe(
      hex(new Color(presets.chalk.material.paper as string)),
    );
  });
});

test('the background that a scene was given once is that of the next preset', async () => {
  const hatched = await applyHatching(crate(), 'pen');
  const { background } = hatched;
  await hatched.setPreset('chalk', { tonalArtMap: null });
  expect(hex(background)).toBe(hex(new Color(presets.chalk.material.paper as string)));
});

test('restore keeps what was set on a mesh since', async () => {
  const [first, second] = [crate(), ball()];
  const looks = [first, second].map(({ geometry, material }) => ({ geometry, material }));
  const hatched = await applyHatching(new Group().add(first, second), 'technical');
  const geometry = new BoxGeometry(2, 8, 6);
  const material = new MeshBasicMaterial();
  Object.assign(first, { geometry });
  Object.assign(second, { material });
  hatched.restore();
  expect(first.geometry).toBe(geometry);
  expect(first.material).toBe(looks[0].material);
  expect(second.geometry).toBe(looks[1].geometry);
  expect(second.material).toBe(material);
});

test('restore recognises its objects behind proxies, as in Vue', async () => {
  const meshes: Mesh[] = [crate(), ball()];
  const looks = meshes.map(({ geometry, material }) => ({ geometry, material }));
  const hatched = await applyHatching(new Group().add(...meshes), 'technical');
  const wrapped = reactive(meshes[0]);
  // A proxy that is assigned keeps its target in Vue; other frameworks keep the proxy.
  Object.assign(meshes[0], {
    geometry: reactive(wrapped.geometry as BufferGeometry),
    material: reactive(wrapped.material as Material),
  });
  hatched.restore();
  expect(meshes.map(({ geometry, material }) => ({ geometry, material }))).toEqual(looks);
});

test('restore ends a call under way, and update() draws with the same materials again', async () => {
  const mesh = crate();
  const hatched = await applyHatching(mesh, 'technical');
  const material = materialOf(mesh);
  material.ink.set('#123456');
  const switching = hatched.setPreset('engraving');
  hatched.restore();
  await expect(switching).rejects.toMatchObject({ name: 'AbortError' });
  expect(mesh.material).toBeInstanceOf(MeshStandardMaterial);
  await hatched.update();
  expect(mesh.material).toBe(material);
  expect(hex(material.ink)).toBe('123456');
});
