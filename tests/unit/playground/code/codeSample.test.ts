import * as THREE from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { counts } from '../../../../src/look/measuredFacts.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { codeSample } from '../../../../src/playground/code/codeSample.js';
import { materialParameters } from '../../../../src/playground/code/lookSample.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { presets } from '../../../../src/scene/presets.js';
import { parameterSetter } from '../../../../src/viewer/drawing/parameterSetter.js';
import { LightRig } from '../../../../src/viewer/sceneSetup/LightRig.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { outlineLook } from '../../../../src/viewer/settings/outlineLook.js';
import { PRESET_NAMES } from '../../../../src/viewer/settings/presetLabels.js';
import { presetLook, presetOf } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

/** What samples may import from the library. */
const OURS = ['HatchingMaterial', 'HatchingOutlines', 'TonalArtMap', 'applyHatching', 'prepareHatchingGeometry'];

/** Runs a sample in a project that has a scene, and returns the scene. */
async function run(sample: string, loaded?: THREE.Object3D): Promise<THREE.Scene> {
  const names = [...sample.matchAll(/^import \{ (.*) \} from '(.*)';$/gm)];
  const loader = loaded ? ['three/addons/loaders/GLTFLoader.js'] : [];
  expect(names.map(([, , from]) => from)).toEqual(['three', ...loader, 'three-hatching']);
  const given: Record<string, unknown> = {
    HatchingOutlines,
    HatchingMaterial,
    applyHatching,
    presets,
    GLTFLoader: class {
      loadAsync = async () => ({ scene: loaded });
    },
    prepareHatchingGeometry: async (geometry: unknown) => geometry,
    TonalArtMap: { generate: async () => null },
    scene: new THREE.Scene(),
    camera: viewer,
    geometry: new THREE.IcosahedronGeometry(1, 2),
    renderer: { shadowMap: {} },
  };
  for (const name of names[0][1].split(', ')) given[name] = (THREE as Record<string, unknown>)[name];
  const body = sample.replace(/^import .*$/gm, '');
  const imported = names.at(-1)![1].split(', ');
  for (const name of [...OURS, ...imported])
    expect(imported.includes(name), name).toBe(new RegExp(`\\b${name}\\b`).test(body));
  const program = new Function(
    'given',
    `const { ${Object.keys(given).join(', ')} } = given; return (async () => { ${body} })();`,
  );
  await program(given);
  return given.scene as THREE.Scene;
}

/** Seen from the side, so that what stays with the viewer is told from what stays with the model. */
const viewer = new THREE.PerspectiveCamera();
viewer.position.set(3, 2, 1);
viewer.lookAt(0, 0, 0);

/** The line material that the page draws with. */
const lineMaterialOf = (settings: Settings): HatchingOutlineMaterial =>
  new HatchingOutlineMaterial(outlineLook(settings));

function expectLines(outlines: HatchingOutlines | undefined, settings: Settings): void {
  const expected = lineMaterialOf(settings);
  const made = outlines!.material;
  for (const [key, value] of Object.entries(outlineLook(settings))) {
    if (typeof value === 'number') expect(made[key as 'outlineWidth'], key).toBeCloseTo(value, 3);
  }
  expect(made.shadeWeights.distanceTo(expected.shadeWeights)).toBeCloseTo(0, 3);
  expect(made.ink.equals(expected.ink)).toBe(true);
  expect(made.taper).toBe(expected.taper);
}

const outlinesIn = (root: THREE.Object3D): HatchingOutlines | undefined =>
  root.children.find((child) => child instanceof HatchingOutlines);

const looks: Record<string, Partial<Settings>> = {
  ...Object.fromEntries(PRESET_NAMES.map((name) => [name, presetLook(name)])),
  'a preset with shadows': { ...presetLook('engraving'), shadows: 'on' },
  'a preset with shadows across its outlines': { ...presetLook('engraving'), shadows: 'on', shadowStrokes: 'cross' },
  'a preset with another ink': { ...presetLook('pen'), ink: '#203080' },
  'two lights': { secondLight: 'left', secondStrength: 80, lightKind: 'spot' },
  'one layer under two lights': {
    secondLight: 'opposite',
    secondStrength: 70,
    strokeLayers: 'single',
    toneModel: 'phong',
    shininess: 9,
  },
  'two lights that stay with the viewer': { lightFollows: 'viewer', secondLight: 'right', secondStrength: 70 },
  'a second light somewhere else': { secondLight: 'free', secondAzimuth: 75, secondElevation: -20 },
  'a highlight with an edge': { highlightTone: 20, reflectedLight: 0 },
  'layers by tone': { strokeLayers: 'tone', crossFrom: 40, crossAngle: 90, secondLight: 'right' },
  'engraved, crossing at a right angle': { technique: 'engraved', crossFrom: 30, crossAngle: 90 },
  'tinted, curved, by depth': {
    technique: 'adjacency',
    toneCurve: 'contrast',
    inkBlend: 'multiply',
    levelRule: 'depth',
    offsetU: 0.25,
    blendAngle: 30,
  },
  'other outlines': {
    outlineWidth: 3.3,
    outlineContours: 150,
    outlineInner: 80,
    outlineCreases: 0,
    outlineSuggestive: 60,
    outlineLost: 45,
    outlineAccents: 110,
    outlineShade: 100,
    outlineHand: 3,
  },
  'toon, perceptual': {
    technique: 'adjacencyCrisp',
    toneModel: 'toon',
    toneSteps: 6,
    toneCurve: 'perceptual',
    lightKind: 'point',
  },
};

// What a program consists of is compared at once.
beforeAll(() => HatchingMaterial.preload());

describe('codeSample', () => {
  test.each(Object.entries(looks))('makes the material and the lights of the page: %s', async (_name, look) => {
    const settings = { ...defaultSettings(), ...look };
    const scene = await run(codeSample(settings, undefined));

    const expected = new HatchingMaterial();
    parameterSetter(lookOf(settings).drawn)(expected);
    const mesh = scene.children.find((child) => child instanceof THREE.Mesh) as THREE.Mesh;
    const { material } = mesh;
    expectLines(outlinesIn(mesh), settings);
    const made = material as HatchingMaterial;
    // Unless it names a preset, the sample leaves out a second layer for lights that disagree if there is one light.
    if (!presetOf(settings) && settings.secondLight === 'none' && settings.strokeLayers === 'lights')
      expected.strokeLayers = 'single';
    expect(made.defines).toEqual(expected.defines);
    for (const key of [
      'tilesPerUnit',
      'strokeRotation',
      'reflectedLight',
      'blendAngle',
      'edgePixels',
      'crossAngle',
      'crossFrom',
    ] as const) {
      if (!counts(expected, key)) continue;
      expect(made[key], key).toBeCloseTo(expected[key], 3);
    }
    if (look.toneModel === 'toon') expect(made.toneSteps).toBe(expected.toneSteps);
    if (look.toneModel === 'phong') expect(made.shininess).toBe(expected.shininess);
    expect(made.toneCurve).toEqual(expected.toneCurve);
    expect(made.strokeOffset.toArray()).toEqual(expected.strokeOffset.toArray());
    for (const key of ['ink', 'paper', 'color'] as const) expect(made[key].equals(expected[key]), key).toBe(true);

    const drawn = new THREE.Scene();
    const rig = new LightRig(drawn);
    rig.apply(lookOf(settings).lights);
    rig.place(viewer);
    const describeLight = (light: THREE.Object3D) => {
      const direction = light.position.clone();
      if (light instanceof THREE.DirectionalLight) direction.normalize();
      return [
        light.type,
        ...[...direction.toArray(), (light as THREE.Light).intensity].map((x) => x.toFixed(2)),
      ].join();
    };
    const lights = (of: THREE.Scene) =>
      of.children
        .filter((child) => child instanceof THREE.Light && child.visible)
        .map(describeLight)
        .sort();
    expect(lights(scene)).toEqual(lights(drawn));
  });

  test.each(
    (['shown', 'paper'] as const).flatMap((surfaceColors) => [
      [surfaceColors, 'spelled out', { ink: '#203080' }] as const,
      [surfaceColors, 'by a preset', presetLook('woodcut')] as const,
    ]),
  )(
    'hatches a loaded scene as the page does, its surfaces %s, %s',
    async (surfaceColors, _how, look: Partial<Settings>) => {
      const settings: Settings = { ...defaultSettings(), ...look, surfaceColors };
      const paint = new THREE.MeshStandardMaterial({ color: 'tomato', map: new THREE.Texture() });
      const model = new THREE.Mesh(new THREE.IcosahedronGeometry(5, 8), paint);
      const scene = await run(codeSample(settings, 5), model);
      expect(scene.children).toContain(model);
      const made = model.material as unknown as HatchingMaterial;
      expect(made).toBeInstanceOf(HatchingMaterial);
      expect(made.technique).toBe(settings.technique);
      expect(`#${made.ink.getHexString()}`).toBe(settings.ink);
      // The page scales models to a radius of 1; a bounding sphere may be a little larger than the farthest vertex.
      expect(made.tilesPerUnit * 5).toBeCloseTo(settings.tilesPerUnit, 0);
      expect(made.color.equals(new THREE.Color(surfaceColors === 'shown' ? 'tomato' : 'white'))).toBe(true);
      expect(made.map).toBe(surfaceColors === 'shown' ? paint.map : null);
      expectLines(outlinesIn(model), settings);
    },
  );

  test.each([{}, presetLook('pen')])('places a lamp by the size of a loaded scene', async (look: Partial<Settings>) => {
    const settings: Settings = { ...defaultSettings(), ...look, lightKind: 'point', lightDistance: 2 };
    const model = new THREE.Mesh(new THREE.IcosahedronGeometry(5, 2), new THREE.MeshStandardMaterial());
    const scene = await run(codeSample(settings, 5), model);
    const lamp = scene.children.find((child) => child instanceof THREE.PointLight)!;
    expect(lamp.position.length()).toBeCloseTo(10, 2);
  });

  test.each(PRESET_NAMES)('names the preset that the page shows: %s', (name) => {
    const settings: Settings = { ...defaultSettings(), ...presetLook(name) };
    expect(codeSample(settings, undefined)).toContain(`...presets.${name},`);
    expect(codeSample({ ...settings, ink: '#203080' }, undefined)).not.toContain('presets');
    expect(codeSample({ ...settings, reflectedLight: settings.reflectedLight + 1 }, 5)).not.toContain('presets');
  });

  test.each<[Partial<Settings>, boolean]>([
    [{ technique: 'engraved' }, false],
    [{ technique: 'anchored', medium: 'stipple' }, false],
    [{ technique: 'anchored', medium: 'dry' }, true],
    [{ technique: 'adjacency', medium: 'stipple' }, true],
    // The code draws one technique.
    [{ technique: 'engraved', compare: 'adjacency' }, false],
  ])('loads a map only for what is drawn with one: %j', async (look, isMapped) => {
    for (const mapStyle of ['file', 'ruled'] as const) {
      const settings: Settings = { ...defaultSettings(), ...look, mapStyle };
      for (const sample of [codeSample(settings, undefined), codeSample(settings, 5)]) {
        expect(/tonalArtMap/i.test(sample)).toBe(isMapped);
        expect(sample.includes('map.json')).toBe(isMapped && mapStyle === 'file');
      }
      await run(codeSample(settings, undefined).replace("load('map.json')", 'generate()'));
    }
  });

  test.each([
    [100, 'lineSpacing: 4 * share,'],
    [50, 'lineSpacing: 4 * share ** 0.5,'],
    [0, 'lineSpacing: 4,'],
  ])('spaces lines on a small sheet as far as they are on the screen: %d %%', (sizedOnScreen, expected) => {
    const settings: Settings = { ...defaultSettings(), technique: 'engraved', lineSpacing: 4, sizedOnScreen };
    expect(materialParameters(settings, true, 'share').join(',\n')).toContain(expected);
    expect(codeSample(settings, undefined)).toContain('lineSpacing: 4,');
  });

  test('has lines follow the form where the page does', () => {
    const engraved: Settings = { ...defaultSettings(), technique: 'engraved', crossAngle: 30 };
    expect(codeSample(engraved, undefined)).not.toContain('form:');
    for (const [lineField, option] of [
      ['form', 'form: { crossAngle: (30 / 180) * Math.PI }'],
      ['auto', 'form: { auto: true, crossAngle: (30 / 180) * Math.PI }'],
    ] as const) {
      const settings: Settings = { ...engraved, lineField };
      for (const sample of [codeSample(settings, undefined), codeSample(settings, 5)])
        expect(sample).toContain(`lineField: '${lineField}'`);
      expect(codeSample(settings, undefined)).toContain(option);
    }
    const strokes: Settings = { ...defaultSettings(), strokeField: 'acrossForm' };
    for (const sample of [codeSample(strokes, undefined), codeSample(strokes, 5)])
      expect(sample).toContain("strokeField: 'acrossForm'");
    expect(codeSample(strokes, undefined)).toContain('form: true');
  });

  test('draws no outlines if the page draws none', async () => {
    const settings: Settings = { ...defaultSettings(), outlines: 'off' };
    expect(codeSample(settings, undefined)).not.toMatch(/outlines/i);
    const scene = await run(codeSample(settings, undefined));
    expect(scene.children.find((child) => child instanceof THREE.Mesh)!.children).toEqual([]);
    const model = new THREE.Mesh(new THREE.IcosahedronGeometry(5, 2), new THREE.MeshStandardMaterial());
    await run(codeSample(settings, 5), model);
    expect(model.children).toEqual([]);
  });
});
