import { BoxGeometry, Group, Mesh, MeshBasicMaterial } from 'three';
import { afterEach, beforeEach, describe, expect, type MockInstance, test, vi } from 'vitest';
import {
  applyHatching,
  HatchingMaterial,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
} from '../../../../src/index.js';

const tonalArtMap = TonalArtMap.fromHatchImages({ size: 1, images: [[Uint8Array.of(255)], [Uint8Array.of(0)]] });
const crate = () => new Mesh(new BoxGeometry(), new MeshBasicMaterial());

let warn: MockInstance;
beforeEach(() => {
  warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
});
afterEach(() => {
  HatchingMaterial.silent = false;
  vi.restoreAllMocks();
});

const said = () => warn.mock.calls.flat();

describe('a promise that nobody awaits', () => {
  test('says so when its result is asked of it, once', async () => {
    const hatched = applyHatching(crate(), { tonalArtMap });
    const { materials, skipped } = hatched as unknown as Awaited<typeof hatched>;
    expect([materials, skipped]).toEqual([undefined, undefined]);
    expect(said()).toEqual([
      'applyHatching() returns a promise, which has no "materials". Write await before the call.',
    ]);
    expect((await hatched).materials).toHaveLength(1);
    expect(said()).toHaveLength(1);
  });

  test('says so when three.js draws it as a geometry', async () => {
    const geometry = prepareHatchingGeometry(new BoxGeometry());
    expect(() => new Mesh(geometry as never)).toThrow();
    expect(said()).toEqual([expect.stringContaining('prepareHatchingGeometry() returns a promise')]);
    await geometry;
  });

  test('is refused as a map, a geometry or a scene', async () => {
    const promise = Promise.resolve(tonalArtMap) as never;
    expect(() => new HatchingMaterial({ tonalArtMap: promise })).toThrow('a promise is no TonalArtMap; write await');
    await expect(applyHatching(crate(), { tonalArtMap: promise })).rejects.toThrow(
      'a promise is no TonalArtMap; write await',
    );
    await expect(prepareHatchingGeometry(promise)).rejects.toThrow('got Promise. Write await before it.');
    await expect(applyHatching(promise)).rejects.toThrow('Write await');
    expect(said()).toEqual([]);
  });

  test('says nothing where it is awaited', async () => {
    await prepareHatchingGeometry(new BoxGeometry());
    (await applyHatching(crate(), { tonalArtMap })).dispose();
    expect(said()).toEqual([]);
  });
});

test('a scene without a mesh is named', async () => {
  const empty = Object.assign(new Group(), { name: 'car' });
  await applyHatching(empty, { tonalArtMap });
  expect(said()).toEqual([
    expect.stringMatching(
      /there is no mesh to hatch in the Group "car"\. Call it once the model is loaded and added, or call update()/,
    ),
  ]);
  HatchingMaterial.silent = true;
  await applyHatching(empty, { tonalArtMap });
  expect(said()).toHaveLength(1);
});

test('a whole preset is no list of parameters', () => {
  for (const name of ['pen', 'engraving'] as const) {
    expect(() => new HatchingMaterial(presets[name] as never)).toThrow(
      'HatchingMaterial: this is a whole preset. Pass its material: presets.pen.material.',
    );
  }
});

test('a map is not made with "new"', () => {
  const Made = TonalArtMap as unknown as new (options?: object) => TonalArtMap;
  for (const options of [undefined, { style: 'hatching' }]) {
    expect(() => new Made(options)).toThrow('Use draw(), fromHatchImages() or await load().');
  }
});
