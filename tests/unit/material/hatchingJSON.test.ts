import { Color, DoubleSide, Plane, Texture, Vector3 } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { type HatchingMaterialJSON, propertiesToJSON } from '../../../src/material/hatchingJSON.js';

afterEach(() => vi.restoreAllMocks());

/** JSON as read from a file of unknown origin. */
const read = (text: string, textures?: Record<string, Texture>): HatchingMaterial =>
  HatchingMaterial.fromJSON(JSON.parse(text) as HatchingMaterialJSON, textures);

describe('JSON of a material, from anywhere', () => {
  test('sets known properties and no others', () => {
    const warn = vi.spyOn(console, 'warn');
    const material = read(`{
      "__proto__": { "isMaterial": false, "dispose": "mine" },
      "dispose": "no function", "onBeforeCompile": 1, "customProgramCacheKey": null, "setValues": {}, "constructor": 5,
      "isMaterial": false, "isHatchingMaterial": false, "type": "Other", "version": -1, "needsUpdate": false,
      "vertexShader": "", "fragmentShader": "", "uniforms": {}, "defines": { "MINE": 1 }, "extensions": 1,
      "tonalArtMap": "contours", "roughness": 1, "tilesPerObjectUnit": 7, "opacity": 0.5
    }`);
    expect(Object.getPrototypeOf(material)).toBe(HatchingMaterial.prototype);
    expect(material).toMatchObject({ isMaterial: true, isHatchingMaterial: true, type: 'HatchingMaterial' });
    expect(Object.keys(material)).toEqual(Object.keys(new HatchingMaterial()));
    expect(material).toMatchObject({ tilesPerObjectUnit: 7, opacity: 0.5, tonalArtMap: 'contours' });
    const { defines, vertexShader, fragmentShader } = new HatchingMaterial();
    expect(material).toMatchObject({ defines, vertexShader, fragmentShader });
    for (const name of ['dispose', 'onBeforeCompile', 'customProgramCacheKey', 'setValues', 'constructor'] as const) {
      expect(typeof material[name], name).toBe('function');
    }
    expect(warn).not.toHaveBeenCalled();
  });

  test.each([
    ['{ "ink": "nonsense" }', 'HatchingMaterial.ink: expected a THREE.Color'],
    ['{ "strokeWidth": "1.9" }', 'HatchingMaterial.strokeWidth: 1.9 is not a number'],
    [
      '{ "perTriangle": { "strokeOffset": 3 } }',
      'HatchingMaterial.perTriangle.strokeOffset: expected a THREE.Vector2 or an array of two finite numbers.',
    ],
    [
      '{ "perTriangle": { "strokeOffset": [1, "2"] } }',
      'HatchingMaterial.perTriangle.strokeOffset: expected a THREE.Vector2 or an array of two finite numbers.',
    ],
    ['{ "technique": "toString" }', 'HatchingMaterial.technique: "toString" is not known'],
    ['{ "perTriangle": { "sharpInk": 1 } }', 'HatchingMaterial.perTriangle.sharpInk: expected true or false.'],
    ['{ "perTriangle": 1 }', 'HatchingMaterial.fromJSON: perTriangle is 1, but must be a JSON object.'],
    ['{ "composition": { "vignette": 2 } }', 'HatchingComposition.vignette: 2 is not a number in [0, 1].'],
    ['{ "map": 5 }', 'HatchingMaterial.fromJSON: map is 5, but must be a uuid of a texture.'],
    ['{ "side": "double" }', 'HatchingMaterial.fromJSON: side is "double", but must be a number.'],
    ['{ "side": null }', 'HatchingMaterial.fromJSON: side is null, but must be a number.'],
    ['{ "transparent": 1 }', 'HatchingMaterial.fromJSON: transparent is 1, but must be a boolean.'],
    ['{ "name": {} }', 'HatchingMaterial.fromJSON: name is {}, but must be a string.'],
    ['{ "uuid": 5 }', 'HatchingMaterial.fromJSON: uuid is 5, but must be a string.'],
    ['{ "userData": null }', 'HatchingMaterial.fromJSON: userData is null, but must be a JSON object.'],
    ['{ "clippingPlanes": [{ "normal": [0, 1], "constant": 2 }] }', 'must be a list of planes.'],
    ['{ "clippingPlanes": 1 }', 'must be a list of planes.'],
  ])('is refused with a value of the wrong kind, and sets nothing: %s', (text, message) => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const material = new HatchingMaterial();
    const json = { tilesPerObjectUnit: 7, opacity: 0.5, ...JSON.parse(text) };
    expect(() => material.fromJSON(json)).toThrow(message);
    expect([material.tilesPerObjectUnit, material.opacity]).toEqual([3, 1]);
  });

  test.each([
    [null, 'null'],
    [undefined, 'undefined'],
    [5, '5'],
    [true, 'true'],
    ['{}', '"{}"'],
    [[], '[]'],
    [() => {}, 'undefined'],
  ])('is refused in a sentence where it is no object: %s', (json, shown) => {
    const read = () => HatchingMaterial.fromJSON(json as unknown as HatchingMaterialJSON);
    expect(read).toThrow(TypeError);
    expect(read).toThrow(`HatchingMaterial.fromJSON: what it is given is ${shown}, but must be a JSON object.`);
  });

  test('omits defaults, also those of a technique, and has all other values', async () => {
    await HatchingMaterial.preload();
    const named = (material: HatchingMaterial) => Object.keys(propertiesToJSON(material));
    expect(named(new HatchingMaterial())).toEqual([]);
    for (const technique of ['engraving', 'adjacency', 'triangle'] as const) {
      expect(named(new HatchingMaterial({ technique })), technique).toEqual(['technique']);
    }
    // The default of one technique is not that of another.
    const { strokeLayers } = new HatchingMaterial({ technique: 'engraving' });
    const other = new HatchingMaterial({ technique: 'hatching', strokeLayers, tilesPerObjectUnit: 7 });
    expect(named(other)).toEqual(expect.arrayContaining(['tilesPerObjectUnit']));
    expect(read(JSON.stringify(other.toJSON()))).toMatchObject({ strokeLayers, tilesPerObjectUnit: 7 });
  });

  test('finds textures by their own names alone', () => {
    const texture = new Texture();
    expect(read(`{ "map": "${texture.uuid}" }`, { [texture.uuid]: texture }).map).toBe(texture);
    expect(read('{ "map": "constructor", "alphaMap": "__proto__" }').map).toBe(null);
    expect(read('{ "map": null }').map).toBe(null);
  });

  test("restores three's own properties: planes, null and colours", () => {
    const source = new HatchingMaterial({ side: DoubleSide });
    source.clippingPlanes = [new Plane(new Vector3(0, 1, 0), 2)];
    source.blendColor = new Color(0x123456);
    source.shadowSide = null;
    const made = read(
      JSON.stringify({
        ...source.toJSON(),
        // three.js before 0.187 writes no planes.
        clippingPlanes: [{ normal: [0, 1, 0], constant: 2 }],
        blendColor: 0x123456,
        shadowSide: null,
      }),
    );
    expect(made.clippingPlanes).toEqual(source.clippingPlanes);
    expect(made.blendColor).toEqual(source.blendColor);
    expect([made.side, made.shadowSide]).toEqual([DoubleSide, null]);
  });

  test('warns of what the technique does not use only once it knows the technique', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    read('{ "smudge": 0.5, "technique": "dryMedia" }');
    expect(warn).not.toHaveBeenCalled();
  });
});
