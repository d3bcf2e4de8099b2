import { Color, DoubleSide, FrontSide, Plane, ShaderMaterial, Texture, Vector3 } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import {
  HatchingOutlineMaterial,
  type HatchingOutlineParameters,
} from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import {
  HATCHING_OUTLINE_DEFAULTS,
  OUTLINE_NUMBER_NAMES,
  OUTLINE_NUMBERS,
  OUTLINE_WEIGHT_NAMES,
  WEIGHTED_LINES,
} from '../../../../src/material/outlines/outlineProperties.js';

afterEach(() => vi.restoreAllMocks());

/** A value other than the default for every parameter. */
const changed = {
  outlineWidth: 3,
  weights: {
    contours: 0.5,
    innerContours: 0.8,
    borders: 0.25,
    creases: 2,
    materialBorders: 0.1,
    intersections: 0.9,
    suggestiveContours: 0.7,
    lit: 0.1,
    shade: 3,
  },
  lostEdges: 0.9,
  accents: 1.5,
  taper: 0,
  wobble: 1.5,
  overshoot: 4,
  paperGrain: 0.5,
  paperGrainSize: 3,
  ink: '#123456',
  hidden: 'dashed',
  intersections: true,
  opacity: 0.5,
  fog: false,
  clipping: false,
  side: FrontSide,
  depthTest: false,
  name: 'pen',
  toneMapped: false,
} as const satisfies HatchingOutlineParameters;

describe('HatchingOutlineMaterial', () => {
  test('can be made without parameters, with the documented defaults', () => {
    const material = new HatchingOutlineMaterial();
    const { ink, ...numbers } = HATCHING_OUTLINE_DEFAULTS;
    expect(material).toMatchObject(numbers);
    expect(material).toMatchObject({
      isHatchingOutlineMaterial: true,
      type: 'HatchingOutlineMaterial',
      lights: true,
      fog: true,
      clipping: true,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    expect(material.ink.getHex()).toBe(ink);
    expect(numbers).toEqual({
      outlineWidth: 1.8,
      weights: {
        contours: 1,
        innerContours: 0.5,
        borders: 1,
        creases: 0.35,
        materialBorders: 0.35,
        intersections: 0.35,
        suggestiveContours: 0,
        lit: 0.7,
        shade: 1.7,
      },
      lostEdges: 0.2,
      accents: 0.5,
      taper: 0.8,
      wobble: 0,
      overshoot: 0,
      paperGrain: 0,
      paperGrainSize: 2.5,
      hidden: 'none',
      intersections: false,
    });
  });

  test('the parameters of the tests below differ from every default', () => {
    expect(Object.keys(changed)).toEqual(expect.arrayContaining(Object.keys(HATCHING_OUTLINE_DEFAULTS)));
    for (const name of OUTLINE_NUMBER_NAMES) expect(changed[name]).not.toBe(HATCHING_OUTLINE_DEFAULTS[name]);
    for (const name of OUTLINE_WEIGHT_NAMES)
      expect(changed.weights[name]).not.toBe(HATCHING_OUTLINE_DEFAULTS.weights[name]);
  });

  test('takes parameters the way three does', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const material = new HatchingOutlineMaterial(changed);
    const { ink, ...others } = changed;
    expect(material).toMatchObject(others);
    expect(material.ink.equals(new Color(ink))).toBe(true);
    expect(warn).not.toHaveBeenCalled();
  });

  test('warns of a parameter it does not know', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    new HatchingOutlineMaterial({ linewidths: 2 } as HatchingOutlineParameters);
    expect(warn.mock.calls.flat().join(' ')).toContain('linewidths');
  });

  test('refuses an ink that is no colour, before anything is set', () => {
    const material = new HatchingOutlineMaterial();
    expect(() => material.setValues({ outlineWidth: 5, ink: 'nonsense' })).toThrow(
      'HatchingOutlineMaterial.ink: expected a THREE.Color',
    );
    expect(material.outlineWidth).toBe(HATCHING_OUTLINE_DEFAULTS.outlineWidth);
  });

  test('has at most 12 properties of its own', () => {
    expect(Object.keys(HATCHING_OUTLINE_DEFAULTS).length).toBeLessThanOrEqual(12);
    const { prototype } = HatchingOutlineMaterial;
    const own = [...Object.keys(new HatchingOutlineMaterial()), ...Object.getOwnPropertyNames(prototype)];
    const inherited = new ShaderMaterial();
    const added = own.filter((name) => !(name in inherited) && typeof Reflect.get(prototype, name) !== 'function');
    const internal = ['isHatchingOutlineMaterial', 'ofMesh', 'hiddenLines', 'written', 'writtenLook'];
    expect(added.filter((name) => !internal.includes(name)).sort()).toEqual(
      Object.keys(HATCHING_OUTLINE_DEFAULTS).sort(),
    );
  });

  test('each has an ink and weights of its own', () => {
    const [a, b] = [new HatchingOutlineMaterial(), new HatchingOutlineMaterial()];
    a.ink.set('red');
    a.weights.shade = 7;
    expect(b.ink.getHex()).toBe(HATCHING_OUTLINE_DEFAULTS.ink);
    expect({ ...b.weights }).toEqual(HATCHING_OUTLINE_DEFAULTS.weights);
    expect(a.uniforms).not.toBe(b.uniforms);
  });
});

describe.each(OUTLINE_NUMBER_NAMES)('%s', (name) => {
  const bad = [-0.001, -Infinity, Infinity, Number.NaN, '1', null, ...('above' in OUTLINE_NUMBERS[name] ? [0] : [])];

  test.each(bad)('refuses %s and keeps what it has', (value) => {
    const material = new HatchingOutlineMaterial({ [name]: 0.75 });
    const act = () => {
      (material as unknown as Record<string, unknown>)[name] = value;
    };
    expect(act).toThrow(RangeError);
    expect(act).toThrow(`HatchingOutlineMaterial.${name}: ${value} is not a number in `);
    expect(material[name]).toBe(0.75);
    expect(() => new HatchingOutlineMaterial({ [name]: value } as HatchingOutlineParameters)).toThrow(RangeError);
  });

  test('reaches its uniform when drawn', () => {
    const material = new HatchingOutlineMaterial();
    material[name] = 0.75;
    material.writeUniforms(false, true);
    expect(material.uniforms[name].value).toBe(0.75);
  });
});

test('only sizes may not be 0', () => {
  for (const name of OUTLINE_NUMBER_NAMES) {
    if (name === 'outlineWidth' || name === 'paperGrainSize') continue;
    expect(new HatchingOutlineMaterial({ [name]: 0 })[name]).toBe(0);
  }
});

describe('copy and clone', () => {
  /** Everything that can be set, as plain values. */
  const valuesOf = (material: HatchingOutlineMaterial) => ({
    ...Object.fromEntries(Object.keys(changed).map((name) => [name, Reflect.get(material, name)])),
    ink: material.ink.getHex(),
    weights: { ...material.weights },
    userData: material.userData,
    planes: material.clippingPlanes?.map(({ constant }) => constant),
  });

  const full = () => {
    const material = new HatchingOutlineMaterial(changed);
    material.userData = { mine: 1 };
    material.clippingPlanes = [new Plane(new Vector3(0, 1, 0), 3)];
    return material;
  };

  test('keep everything', () => {
    const source = full();
    const clone = source.clone();
    expect(clone).toBeInstanceOf(HatchingOutlineMaterial);
    expect(valuesOf(clone)).toEqual(valuesOf(source));
    expect(valuesOf(new HatchingOutlineMaterial().copy(source))).toEqual(valuesOf(source));
    expect(valuesOf(clone)).not.toEqual(valuesOf(new HatchingOutlineMaterial()));
    expect(clone.vertexShader).toBe(source.vertexShader);
    expect(clone.lights).toBe(true);
  });

  test('share neither colours nor uniforms, and clone no textures', () => {
    const source = full();
    const texture = new Texture();
    const cloneTexture = vi.spyOn(texture, 'clone');
    source.uniforms.outlinePoints.value = texture;
    const clone = source.clone();
    clone.ink.set('red');
    clone.weights.shade = 7;
    clone.outlineWidth = 9;
    expect(source.ink.equals(new Color(changed.ink))).toBe(true);
    expect({ ...source.weights }).toEqual(changed.weights);
    expect(source.outlineWidth).toBe(changed.outlineWidth);
    expect(clone.uniforms.eye.value).not.toBe(source.uniforms.eye.value);
    expect(cloneTexture).not.toHaveBeenCalled();
  });
});

test('the program changes only if wobble or deformation start or end', () => {
  const material = new HatchingOutlineMaterial();
  material.writeUniforms(false, true);
  const { version } = material;
  const step = (isDeformed: boolean, values: HatchingOutlineParameters) => {
    material.setValues(values);
    material.writeUniforms(isDeformed, true);
    return [material.version - version, 'WOBBLE' in material.defines, 'DEFORMED' in material.defines];
  };
  expect(step(false, { outlineWidth: 3, ink: 'red', weights: { creases: 0 } })).toEqual([0, false, false]);
  expect(step(false, { wobble: 1 })).toEqual([1, true, false]);
  expect(step(false, { wobble: 2 })).toEqual([1, true, false]);
  expect(step(true, {})).toEqual([2, true, true]);
  expect(step(true, { wobble: 0 })).toEqual([3, false, true]);
  expect(step(false, {})).toEqual([4, false, false]);
});

test('its shaders have all includes resolved, and define each name shared with the bake once', () => {
  const { vertexShader, fragmentShader } = new HatchingOutlineMaterial();
  expect(`${vertexShader}${fragmentShader}`).not.toMatch(/#include\s*"/);
  expect(vertexShader).toContain('#define EDGE_CORNER_AT_END 32u');
  expect(vertexShader).toContain('#define POINT_BITS 28');
});

test.each([2, 0.5])('sizes are in CSS pixels, %d pixels of the renderer each, and nothing else is', (pixelRatio) => {
  const look = { outlineWidth: 2, wobble: 1, overshoot: 3, paperGrainSize: 4, taper: 5 };
  const material = new HatchingOutlineMaterial({ ...look, weights: { contours: 6 } });
  material.writeUniforms(false, false, pixelRatio);
  for (const [name, value] of Object.entries(look)) {
    const factor = name === 'taper' ? 1 : pixelRatio;
    expect([name, material.uniforms[name].value]).toEqual([name, factor * value]);
    expect(material[name as keyof typeof look]).toBe(value);
  }
  expect(material.uniforms.contours.value).toBe(6);
});

test('groups count only on meshes with several materials', () => {
  const material = new HatchingOutlineMaterial({ weights: { materialBorders: 0.5 } });
  material.writeUniforms(false, false);
  expect(material.uniforms.materialBorders.value).toBe(0);
  material.writeUniforms(false, true);
  expect(material.uniforms.materialBorders.value).toBe(0.5);
});

describe('weights', () => {
  const { weights: defaults } = HATCHING_OUTLINE_DEFAULTS;

  test('parameters set some of them over the defaults, and setValues over those that are set', () => {
    const material = new HatchingOutlineMaterial({ weights: { creases: 0, lit: undefined } });
    expect({ ...material.weights }).toEqual({ ...defaults, creases: 0 });
    const { weights } = material;
    material.setValues({ weights: { shade: 3 }, outlineWidth: 5 });
    expect(material.weights).toBe(weights);
    expect({ ...weights }).toEqual({ ...defaults, creases: 0, shade: 3 });
    material.setValues({ weights: undefined });
    expect({ ...weights }).toEqual({ ...defaults, creases: 0, shade: 3 });
  });

  test('an assigned object has the defaults where it names none, as attributes of React need', () => {
    const material = new HatchingOutlineMaterial({ weights: { creases: 0 } });
    Object.assign(material, { weights: { shade: 3 } });
    expect({ ...material.weights }).toEqual({ ...defaults, shade: 3 });
    Object.assign(material, { weights: new HatchingOutlineMaterial().weights });
    expect({ ...material.weights }).toEqual(defaults);
  });

  test.each(OUTLINE_WEIGHT_NAMES)('%s is checked by name, and nothing is set if it is wrong', (name) => {
    for (const value of [-0.001, Infinity, Number.NaN, '1', null]) {
      const material = new HatchingOutlineMaterial({ weights: { [name]: 0.75 } });
      const message = `HatchingOutlineMaterial.weights.${name}: ${value} is not a number in [0, ∞).`;
      expect(() => Object.assign(material.weights, { [name]: value })).toThrow(new RangeError(message));
      const values = {
        outlineWidth: 9,
        weights: { contours: 3, shade: 3, [name]: value },
      } as HatchingOutlineParameters;
      expect(() => material.setValues(values)).toThrow(new RangeError(message));
      expect({ ...material.weights, width: material.outlineWidth }).toEqual({ ...defaults, [name]: 0.75, width: 1.8 });
    }
  });

  test.each(WEIGHTED_LINES)('%s reaches its uniform when drawn', (name) => {
    const material = new HatchingOutlineMaterial();
    material.weights[name] = 0.75;
    material.writeUniforms(false, true);
    expect(material.uniforms[name].value).toBe(0.75);
  });

  test('those in the light and in the shade reach one uniform', () => {
    const material = new HatchingOutlineMaterial({ weights: { lit: 0.2, shade: 0.9 } });
    material.writeUniforms(false, true);
    expect(material.uniforms.shadeWeights.value.toArray()).toEqual([0.2, 0.9]);
  });

  test('other names, and what is no object of weights, are refused', () => {
    const material = new HatchingOutlineMaterial();
    expect(() => material.setValues({ weights: { crease: 0 } as object })).toThrow(
      new TypeError(`HatchingOutlineMaterial.weights.crease is none of ${OUTLINE_WEIGHT_NAMES.join(', ')}.`),
    );
    expect(() => Object.assign(material.weights, { crease: 0 })).toThrow(TypeError);
    for (const weights of [null, 7]) {
      expect(() => material.setValues({ weights } as unknown as HatchingOutlineParameters)).toThrow(
        `HatchingOutlineMaterial.weights: expected an object such as { creases: 0.5 }, not ${weights}.`,
      );
    }
  });
});
