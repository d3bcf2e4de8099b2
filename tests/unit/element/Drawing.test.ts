import { Mesh, type OrthographicCamera, type PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import { HatchingMaterial, presets } from 'three-hatching';
import { beforeEach, describe, expect, test, vi } from 'vitest';
import { Drawing } from '../../../src/element/Drawing.js';
import { chosenIndex } from '../../../src/element/loadModel.js';
import { type GltfBuilder, tetrahedron } from '../../../tools/modelFiles/GltfBuilder.js';

/** Half the size of the model, which the element scales to a radius of 1. */
const RADIUS = Math.sqrt(3);
const EYE = { azimuth: 0, elevation: 8 };
const LIGHT = { azimuth: -45, elevation: 40 };

beforeEach(() => vi.stubGlobal('ProgressEvent', class {}));

function load(change: (json: GltfBuilder['json']) => void, camera = '', variant = ''): Promise<Drawing> {
  const builder = tetrahedron();
  Object.assign(builder.json.accessors[0], { min: [-1, -1, -1], max: [1, 1, 1] });
  change(builder.json);
  const address = `data:model/gltf-binary;base64,${Buffer.from(builder.glb()).toString('base64')}`;
  const source = { address, variant, folders: { draco: undefined, ktx2: undefined }, renderer: {} as WebGLRenderer };
  return Drawing.load(source, presets.pen, camera, new AbortController().signal, () => {});
}

describe('a camera of the file', () => {
  const seen = (json: GltfBuilder['json']): void => {
    json.cameras = [
      { type: 'perspective', name: 'hero', perspective: { yfov: 0.6, znear: 0.1, aspectRatio: 2 } },
      { type: 'orthographic', orthographic: { xmag: 4, ymag: 2, znear: 0, zfar: 20 } },
    ];
    json.nodes.push({ camera: 0, translation: [0, 0, 9] }, { name: 'plan', camera: 1, translation: [0, 0, 9] });
    json.scenes[0].nodes = [0, 1, 2];
  };

  test('draws the first view, with everything that it sees in the picture', async () => {
    const drawing = await load(seen, 'hero');
    expect(drawing.firstEye).toEqual({ azimuth: 0, elevation: 0 });
    drawing.arrange(LIGHT, EYE, 1, 1, true);
    const camera = drawing.camera as PerspectiveCamera;
    expect(camera.position.toArray().map((value) => Number(value.toFixed(4)))).toEqual([0, 0, 5.1962]);
    expect(Math.tan((camera.fov * Math.PI) / 360)).toBeCloseTo(2 * Math.tan(0.3), 5);
    // Once it is turned, the model is seen as without a camera.
    drawing.arrange(LIGHT, { azimuth: 90, elevation: 0 }, 1, 1, false);
    expect(drawing.camera.position.x).toBeGreaterThan(3);
    drawing.dispose();
  });

  test("may be selected by its node's name or by its number, and may be orthographic", async () => {
    for (const name of ['plan', '2']) {
      const drawing = await load(seen, name);
      drawing.arrange(LIGHT, EYE, 1, 4, true);
      const { top, right } = drawing.camera as OrthographicCamera;
      expect([top * RADIUS, right * RADIUS].map((value) => Number(value.toFixed(4)))).toEqual([2, 8]);
      drawing.dispose();
    }
  });

  test('that does not exist is named in an error', async () => {
    await expect(load(seen, 'side')).rejects.toThrow('The model has no camera "side". There are hero, plan.');
    expect(() => chosenIndex('camera', [], '1')).toThrow('The model has no camera "1". It has none.');
  });
});

test('another preset changes the look in place, and its paper', async () => {
  const drawing = await load(() => {});
  const meshes = () => drawing.scene.getObjectsByProperty('isMesh', true).map((mesh) => (mesh as Mesh).material);
  const before = meshes();
  expect(`#${drawing.paper.getHexString()}`).toBe(presets.pen.material.paper);
  await drawing.setPreset(presets.technical, new AbortController().signal);
  expect(meshes()[0]).toBe(before[0]);
  expect((before[0] as unknown as HatchingMaterial).technique).toBe(presets.technical.material.technique);
  expect(`#${drawing.paper.getHexString()}`).toBe(presets.technical.material.paper);
  drawing.dispose();
});

test('the brightest light of the file is the only light of the drawing', async () => {
  const drawing = await load((json) => {
    json.extensions = { KHR_lights_punctual: { lights: [{ type: 'directional' }, { type: 'point', intensity: 0.1 }] } };
    // To the right: the light shines from the right to the left.
    json.nodes.push(
      { rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2], extensions: { KHR_lights_punctual: { light: 0 } } },
      { translation: [0, 5, 0], extensions: { KHR_lights_punctual: { light: 1 } } },
    );
    json.scenes[0].nodes = [0, 1, 2];
  });
  const { azimuth, elevation } = drawing.lightFor(EYE, 1);
  expect([azimuth, elevation].map(Math.round)).toEqual([90, 0]);
  let lights = 0;
  drawing.scene.traverseVisible((object) => {
    lights += 'isLight' in object ? 1 : 0;
  });
  expect(lights).toBe(1);
  drawing.dispose();
});

test('a material variant is drawn, or its absence is an error', async () => {
  const varied = (json: GltfBuilder['json']): void => {
    json.materials = [{}, { pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }];
    json.extensionsUsed = ['KHR_materials_variants'];
    json.extensions = { KHR_materials_variants: { variants: [{ name: 'white' }, { name: 'red' }] } };
    const mappings = [{ material: 1, variants: [1] }];
    Object.assign(json.meshes[0].primitives[0], { extensions: { KHR_materials_variants: { mappings } } });
  };
  const colourOf = (drawing: Drawing): number[] => {
    const colours: number[][] = [];
    drawing.scene.traverse((object) => {
      if (object instanceof Mesh && object.material instanceof HatchingMaterial)
        colours.push(new Vector3().setFromColor(object.material.color).toArray());
    });
    drawing.dispose();
    return colours[0];
  };
  expect(colourOf(await load(varied))).toEqual([1, 1, 1]);
  expect(colourOf(await load(varied, '', 'red'))).toEqual([1, 0, 0]);
  await expect(load(varied, '', 'blue')).rejects.toThrow('The model has no variant "blue". There are white, red.');
});

describe('a model fills the picture with its visible parts', () => {
  /** The scaled model, whose own radius is known. */
  const radiusOf = (drawing: Drawing): number => 1 / drawing.scene.children[0].scale.x;
  const addPart = (json: GltfBuilder['json'], material: object): void => {
    json.materials = [material];
    json.meshes.push({ primitives: [{ ...json.meshes[0].primitives[0], material: 0 }] });
    json.nodes.push({ mesh: 1, translation: [3, 0, 0], scale: [9, 9, 9] });
    json.scenes[0].nodes = [0, 1];
  };
  const clear = { pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0] } };

  test.each([
    ['a part of alpha 0', { ...clear, alphaMode: 'BLEND' }],
    ['a part that its cutoff leaves out', { ...clear, alphaMode: 'MASK', alphaCutoff: 0.5 }],
  ])('not with %s', async (_, material) => {
    const drawing = await load((json) => addPart(json, material));
    expect(radiusOf(drawing)).toBeCloseTo(RADIUS, 5);
    drawing.dispose();
  });

  test('also with a part that is opaque, whatever its alpha, and with glass', async () => {
    const pane = { alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0.25] } };
    for (const material of [clear, pane]) {
      const drawing = await load((json) => addPart(json, material));
      expect(radiusOf(drawing)).toBeGreaterThan(9);
      drawing.dispose();
    }
  });

  test('with all of its parts, if none is visible', async () => {
    const drawing = await load((json) => {
      addPart(json, { ...clear, alphaMode: 'BLEND' });
      json.meshes[0].primitives[0].material = 0;
    });
    expect(radiusOf(drawing)).toBeGreaterThan(9);
    drawing.dispose();
  });

  test('wherever its nodes are', async () => {
    const drawing = await load((json) => {
      json.nodes[0].translation = [1e7, -3e6, 5e6];
    });
    expect(radiusOf(drawing)).toBeCloseTo(RADIUS, 5);
    const centre = new Vector3();
    drawing.scene.traverse((object) => {
      if (object instanceof Mesh) centre.setFromMatrixPosition(object.matrixWorld);
    });
    expect(centre.length()).toBeLessThan(1e-6);
    drawing.dispose();
  });
});
