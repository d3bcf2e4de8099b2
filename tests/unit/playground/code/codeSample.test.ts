import * as THREE from 'three';
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { counts } from '../../../../src/look/measuredFacts.js';
import { givenValue } from '../../../../src/look/queries.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { OUTLINE_WEIGHT_NAMES } from '../../../../src/material/outlines/outlineProperties.js';
import { codeForms } from '../../../../src/playground/code/codeForms.js';
import { lookSample } from '../../../../src/playground/code/lookSample.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { presets } from '../../../../src/scene/presets.js';
import { parameterSetter } from '../../../../src/viewer/drawing/materials.js';
import { LightRig } from '../../../../src/viewer/sceneSetup/LightRig.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { outlineLook } from '../../../../src/viewer/settings/materialLook.js';
import { PRESET_NAMES } from '../../../../src/viewer/settings/presetLabels.js';
import { presetLook } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

/** What samples may import from the library. */
const OURS = ['TonalArtMap', 'applyHatching', 'bakeOcclusion', 'presets'];

const codeSample = (settings: Settings, sceneRadius?: number): string =>
  codeForms.look({
    model: { model: 'file', title: 'model.glb', sceneRadius, isOpen: false, hasParts: true },
    settings,
    camera: { position: [0, 0, 4], target: [0, 0, 0] },
    groundHeight: -1,
    aspect: 1,
  }).code;

/** Runs a sample in a project that has a scene with a model, and returns the scene. */
async function run(sample: string, model: THREE.Mesh = plainMesh()): Promise<THREE.Scene> {
  const names = [...sample.matchAll(/^import \{ (.*) \} from '(.*)';$/gm)];
  expect(names.map(([, , from]) => from)).toEqual(['three', 'three-hatching']);
  const given: Record<string, unknown> = {
    applyHatching,
    presets,
    bakeOcclusion: async () => {},
    TonalArtMap: { load: async () => null },
    scene: new THREE.Scene().add(model),
    model,
    camera: viewer,
    renderer: { shadowMap: {} },
  };
  for (const name of names[0][1].split(', ')) given[name] = (THREE as Record<string, unknown>)[name];
  const body = sample.replace(/^import .*$/gm, '');
  const imported = names[1][1].split(', ');
  for (const name of [...OURS, ...imported])
    expect(imported.includes(name), name).toBe(new RegExp(`\\b${name}\\b`).test(body));
  const program = new Function(
    'given',
    `const { ${Object.keys(given).join(', ')} } = given; return (async () => { ${body} })();`,
  );
  const warn = vi.spyOn(console, 'warn');
  await program(given);
  expect(warn).not.toHaveBeenCalled();
  warn.mockRestore();
  const scene = given.scene as THREE.Scene;
  scene.updateMatrixWorld(true);
  return scene;
}

const plainMesh = (): THREE.Mesh =>
  new THREE.Mesh(new THREE.IcosahedronGeometry(1, 2), new THREE.MeshStandardMaterial({ color: 'white' }));

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
  for (const name of OUTLINE_WEIGHT_NAMES) expect(made.weights[name], name).toBeCloseTo(expected.weights[name], 3);
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
  'other weights of outlines': { ...presetLook('technical'), outlineCreases: 80, outlineShade: 20 },
  'weights of outlines that its preset changes': { ...presetLook('technical'), outlineInner: 50, outlineCreases: 35 },
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
  'a highlight with an edge': { highlightThreshold: 20, reflectedLight: 0 },
  'layers by tone': { strokeLayers: 'tone', crossFrom: 40, crossAngle: 90, secondLight: 'right' },
  'engraved, crossing at a right angle': { technique: 'engraving', crossFrom: 30, crossAngle: 90 },
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
    const mesh = plainMesh();
    const scene = await run(codeSample(settings), mesh);

    const expected = new HatchingMaterial();
    const shown = lookOf(settings);
    parameterSetter({ ...shown.drawn, ...shown.sizes })(expected);
    const { material } = mesh;
    expectLines(outlinesIn(mesh), settings);
    const made = material as HatchingMaterial;
    expect(made.defines).toEqual(expected.defines);
    for (const key of [
      'lineSpacing',
      'strokeWidth',
      'strokeAngle',
      'reflectedLight',
      'blendAngle',
      'edgePixels',
      'crossAngle',
      'crossFrom',
    ] as const) {
      if (!counts(expected, key)) continue;
      expect(givenValue(made, key), key).toBeCloseTo(Number(givenValue(expected, key)), 3);
    }
    if (look.toneModel === 'toon') expect(made.toneSteps).toBe(expected.toneSteps);
    if (look.toneModel === 'phong') expect(made.shininess).toBe(expected.shininess);
    expect(made.toneCurve).toEqual(expected.toneCurve);
    expect(made.perTriangle.strokeOffset.toArray()).toEqual(expected.perTriangle.strokeOffset.toArray());
    for (const key of ['ink', 'paper', 'color'] as const) expect(made[key].equals(expected[key]), key).toBe(true);

    const drawn = new THREE.Scene();
    const rig = new LightRig(drawn);
    rig.apply(shown.lights);
    rig.place(viewer);
    const describeLight = (light: THREE.Object3D) => {
      const direction = light.getWorldPosition(new THREE.Vector3());
      if (light instanceof THREE.DirectionalLight) direction.normalize();
      return [
        light.type,
        ...[...direction.toArray(), (light as THREE.Light).intensity].map((x) => x.toFixed(2)),
      ].join();
    };
    const lights = (of: THREE.Scene) =>
      [...of.children, ...of.children.flatMap(({ children }) => children)]
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
      await run(codeSample(settings, 5), model);
      const made = model.material as unknown as HatchingMaterial;
      expect(made).toBeInstanceOf(HatchingMaterial);
      expect(made.technique).toBe(settings.technique);
      expect(`#${made.ink.getHexString()}`).toBe(settings.ink);
      // The page scales models to a radius of 1; a bounding sphere may be a little larger than the farthest vertex.
      expect(made.tilesPerObjectUnit * 5).toBeCloseTo(settings.tilesPerObjectUnit, 0);
      expect(made.color.equals(new THREE.Color(surfaceColors === 'shown' ? 'tomato' : 'white'))).toBe(true);
      expect(made.map).toBe(surfaceColors === 'shown' ? paint.map : null);
      expectLines(outlinesIn(model), settings);
    },
  );

  test.each([{}, presetLook('pen')])('places a lamp by the size of a loaded scene', async (look: Partial<Settings>) => {
    const settings: Settings = { ...defaultSettings(), ...look, lightKind: 'point', lightDistance: 2 };
    const model = new THREE.Mesh(new THREE.IcosahedronGeometry(5, 2), new THREE.MeshStandardMaterial());
    const scene = await run(codeSample(settings, 5), model);
    const lamp = scene.children.at(-1)!.children[0];
    expect(lamp).toBeInstanceOf(THREE.PointLight);
    expect(lamp.position.length()).toBeCloseTo(10, 2);
  });

  test.each(PRESET_NAMES)('names the preset that the page shows: %s', (name) => {
    const settings: Settings = { ...defaultSettings(), ...presetLook(name) };
    expect(codeSample(settings)).toContain(`...presets.${name},`);
    expect(codeSample(settings)).not.toContain('material:');
    // With another ink it is that preset, and the ink.
    const inked = codeSample({ ...settings, ink: '#203080' });
    expect(inked).toContain(`material: {\n    ...presets.${name}.material,\n    ink: '#203080',\n  },`);
    expect(inked).toContain(
      `outlines: {\n    ...presets.${name}.outlines,\n    intersections: true,\n    ink: '#203080',\n  },`,
    );
  });

  test.each<[Partial<Settings>, boolean]>([
    [{ technique: 'engraving' }, false],
    [{ technique: 'stipple' }, false],
    [{ technique: 'dryMedia' }, true],
    [{ technique: 'adjacency' }, true],
    // The code draws one technique.
    [{ technique: 'engraving', compare: 'adjacency' }, false],
  ])('loads a map only for what is drawn with one: %j', async (look, isMapped) => {
    for (const mapStyle of ['file', 'ruled'] as const) {
      const settings: Settings = { ...defaultSettings(), ...look, mapStyle };
      for (const sample of [codeSample(settings), codeSample(settings, 5)]) {
        expect(/tonalArtMap/i.test(sample.replace('presets.pencil', ''))).toBe(isMapped);
        expect(sample.includes('map.json')).toBe(isMapped && mapStyle === 'file');
      }
      await run(codeSample(settings));
    }
  });

  test.each([100, 50, 0])(
    'names sizes that shrink on a small sheet, also at their defaults, and leaves that to the library: screenSpaceShare %d',
    (screenSpaceShare) => {
      const settings: Settings = { ...defaultSettings(), technique: 'hatching', strokeWidth: 1.5, screenSpaceShare };
      const placed = lookSample(settings, 'root', { share: 'share' });
      expect(placed).toContain('preset: scalePreset(look, share),');
      expect(placed).toMatch(/strokeWidth: 1\.5,/);
      expect(lookSample(settings, 'root', {})).toContain('preset: look,');
    },
  );

  test('has lines follow the form where the page does', () => {
    const engraved: Settings = { ...defaultSettings(), technique: 'engraving', crossAngle: 30 };
    for (const direction of ['form', 'x'] as const) {
      const settings: Settings = { ...engraved, direction };
      for (const sample of [codeSample(settings), codeSample(settings, 5)])
        expect(sample).toContain(`direction: '${direction}'`);
    }
    const strokes: Settings = { ...defaultSettings(), direction: 'acrossForm' };
    for (const sample of [codeSample(strokes), codeSample(strokes, 5)])
      expect(sample).toContain("direction: 'acrossForm'");
  });

  test('draws no outlines if the page draws none', async () => {
    const settings: Settings = { ...defaultSettings(), outlines: 'off' };
    expect(codeSample(settings)).toContain('outlines: false');
    const model = new THREE.Mesh(new THREE.IcosahedronGeometry(5, 2), new THREE.MeshStandardMaterial());
    await run(codeSample(settings, 5), model);
    expect(model.children).toEqual([]);
  });
});
