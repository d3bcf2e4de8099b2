import {
  BoxGeometry,
  DirectionalLight,
  Mesh,
  MeshPhongMaterial,
  MeshStandardMaterial,
  Scene,
  SphereGeometry,
  Vector3,
} from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { HATCHING_PROPERTIES } from '../../../src/look/hatchingProperties.js';
import type { PresetName } from '../../../src/look/presetMaterials.js';
import { WHITE_PLAN } from '../../../src/material/exposure/writeFit.js';
import { SceneExtent } from '../../../src/material/fading/SceneExtent.js';
import { HatchingComposition } from '../../../src/material/groups/HatchingComposition.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../src/material/HatchingShadowMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { withPreset } from '../../../src/scene/presets.js';
import { HatchingNodeMaterial } from '../../../src/webgpu/HatchingNodeMaterial.js';
import { HatchingShadowNodeMaterial } from '../../../src/webgpu/HatchingShadowNodeMaterial.js';

afterEach(() => vi.restoreAllMocks());

describe.each([
  ['HatchingMaterial', HatchingMaterial],
  ['HatchingShadowMaterial', HatchingShadowMaterial],
  ['HatchingNodeMaterial', HatchingNodeMaterial],
  ['HatchingShadowNodeMaterial', HatchingShadowNodeMaterial],
])('the composition of %s', (_, Made) => {
  test('is its own until it is given one, which it shares', () => {
    const [first, second] = [new Made(), new Made()];
    expect(first.composition).toBeInstanceOf(HatchingComposition);
    expect(first.composition).not.toBe(second.composition);
    const shared = new HatchingComposition({ vignette: 0.4 });
    first.composition = shared;
    second.setValues({ composition: shared });
    shared.vignette = 0.6;
    expect([first.composition.vignette, second.composition.vignette]).toEqual([0.6, 0.6]);
    expect(new Made({ composition: shared }).composition).toBe(shared);
  });

  test('takes numbers of a plain object, and keeps the others', () => {
    const material = new Made({ composition: { vignette: 0.4, exposure: 'fit' } });
    const { composition } = material;
    material.setValues({ composition: { vignette: 0.5 } });
    material.composition = { depthFade: 0.2 };
    expect(material.composition).toBe(composition);
    expect(composition).toMatchObject({ vignette: 0.5, exposure: 'fit', depthFade: 0.2 });
  });

  test('is shared by a clone, as a texture is', () => {
    const material = new Made({ composition: { vignette: 0.4 } });
    expect(material.clone().composition).toBe(material.composition);
  });

  test('refuses wrong values before anything is set', () => {
    const material = new Made({ composition: { vignette: 0.4 } });
    for (const [wrong, message] of [
      [{ depthFade: 0.1, vignette: 2 }, 'HatchingComposition.vignette: 2 is not a number in [0, 1].'],
      [
        { depthFade: 0.1, exposure: 'fitted' },
        "HatchingComposition.exposure: fitted is not a number in (0, ∞) or 'fit' or 'auto'.",
      ],
      [{ depthFade: 0.1, focus: [1] }, 'HatchingComposition.focus: expected null, a THREE.Vector3'],
      [5, 'HatchingMaterial.composition: expected an object of its properties, such as { vignette: 0.4 }.'],
      [null, 'HatchingMaterial.composition: expected an object of its properties'],
    ] as const) {
      expect(() => material.setValues({ ink: 'red', composition: wrong as never })).toThrow(message);
      expect(() => Object.assign(material, { composition: wrong })).toThrow(message);
    }
    expect(material.composition).toMatchObject({ depthFade: 'auto', vignette: 0.4 });
    expect(material.ink.getHex()).toBe(0);
  });
});

test.each([
  [{ vignette: 0.4 }, 'HatchingMaterial: "vignette" belongs to composition. Pass { composition: { vignette } }.'],
  [
    { levelRule: 'depth' },
    'HatchingMaterial: "levelRule" belongs to perTriangle. Pass { perTriangle: { levelRule } }.',
  ],
])('%o is refused beside what owns it', (parameters, message) => {
  expect(() => new HatchingMaterial(parameters as object)).toThrow(message);
});

describe('a composition', () => {
  test('warns of a name that it does not know', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    new HatchingComposition({ vignete: 0.4 } as object);
    expect(warn.mock.calls.flat().join()).toContain('HatchingComposition: "vignete" is no property of it.');
  });

  test('is copied with its extent, and fits its exposure anew', () => {
    const source = new HatchingComposition({ exposure: 'fit', focus: [1, 2, 3] });
    source.extent = new SceneExtent(new Scene());
    source.kept({ scale: 2, offset: 0, white: 1, openOcclusion: 0, plan: WHITE_PLAN });
    const copy = source.clone();
    expect(copy).toMatchObject({ exposure: 'fit', extent: source.extent, keptFit: null });
    expect(copy.focus).toEqual(new Vector3(1, 2, 3));
    expect(copy.focus).not.toBe(source.focus);
  });

  test("keeps the first fit of 'fit' until refit(), and none of 'auto'", () => {
    const [first, second] = [2, 3].map((scale) => ({ scale, offset: 0, white: 1, openOcclusion: 0, plan: WHITE_PLAN }));
    const composition = new HatchingComposition({ exposure: 'fit' });
    expect(composition.keptFit).toBeNull();
    expect(composition.kept(first)).toEqual(first);
    expect(composition.kept(second)).toEqual(first);
    composition.refit();
    expect(composition.kept(second)).toEqual(second);
    composition.exposure = 'auto';
    expect(composition.keptFit).toBeNull();
    expect(composition.kept(first)).toBe(first);
  });
});

describe('presets', () => {
  test.each(['pen', 'chalk'] as const)('%s fits its exposure; other numbers of a composition are merged', (preset) => {
    const material = new HatchingMaterial({ preset, composition: { vignette: 0.3 } });
    expect(material.composition).toMatchObject({ exposure: 'fit', vignette: 0.3 });
    const composition = new HatchingComposition({ vignette: 0.3 });
    expect(new HatchingMaterial({ preset, composition }).composition).toMatchObject({ exposure: 1, vignette: 0.3 });
    const options = withPreset(preset, { material: { composition: { vignette: 0.3 } } });
    expect(options.material).toMatchObject({ composition: { exposure: 'fit', vignette: 0.3 } });
  });

  test('say how soft shadows on a ground are, and another preset takes it back', () => {
    const ground = new HatchingShadowMaterial({ preset: 'woodcut' });
    expect(ground.shadowSoftness).toBe(0.05);
    ground.preset = 'pen' satisfies PresetName;
    expect(ground.shadowSoftness).toBe(0.12);
    expect(new HatchingShadowMaterial({ preset: 'woodcut', shadowSoftness: 0.2 }).shadowSoftness).toBe(0.2);
  });
});

describe('a scene that applyHatching hatches', () => {
  const scene = () => {
    const root = new Scene();
    root.add(new Mesh(new BoxGeometry(), new MeshStandardMaterial()), new DirectionalLight());
    root.add(new Mesh(new SphereGeometry(), new MeshStandardMaterial()));
    return root;
  };

  test('has one composition, with the extent of the scene', async () => {
    const hatched = await applyHatching(scene(), { preset: 'pen', material: { composition: { vignette: 0.2 } } });
    for (const { composition } of hatched.materials) expect(composition).toBe(hatched.composition);
    expect(hatched.materials).toHaveLength(2);
    expect(hatched.composition).toMatchObject({ exposure: 'fit', vignette: 0.2 });
    expect(hatched.composition.extent).toBeInstanceOf(SceneExtent);
    hatched.dispose();
  });

  test('takes one that is given', async () => {
    const composition = new HatchingComposition({ exposure: 2 });
    const hatched = await applyHatching(scene(), { preset: 'pen', material: { composition } });
    expect(hatched.composition).toBe(composition);
    for (const material of hatched.materials) expect(material.composition).toBe(composition);
    hatched.dispose();
  });
});

test('HatchingMaterial itself has at most 41 properties beside those that a material of three.js has', () => {
  const ofThree = { ...new MeshPhongMaterial(), ...new MeshStandardMaterial() };
  const own = Object.entries(HATCHING_PROPERTIES).filter(([name, row]) => !('owner' in row) && !(name in ofThree));
  // `composition` and `perTriangle` hold the others.
  expect(own.length + 2).toBeLessThanOrEqual(41);
});
