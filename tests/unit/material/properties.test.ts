import { readFileSync } from 'node:fs';
import { Color, DoubleSide, MaterialLoader, Texture, Vector2, Vector3 } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import type { NumberRange } from '../../../src/look/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
} from '../../../src/look/hatchingProperties.js';
import { defaultOf } from '../../../src/look/presetParameters.js';
import { givenValue, parametersOf } from '../../../src/look/queries.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../src/material/HatchingShadowMaterial.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { outputs } from '../../../tools/properties/outputs.js';
import type { PropertyRow } from '../../../tools/properties/PropertyRow.js';
import { PROPERTIES } from '../../../tools/properties/table.js';

// Materials are read in the same task in which they are created.
await HatchingMaterial.preload();

afterEach(() => vi.restoreAllMocks());

const rows = Object.entries(PROPERTIES) as [HatchingPropertyName, PropertyRow][];
const names = rows.map(([name]) => name);

/** A value other than the default. */
function anotherValue(name: HatchingPropertyName, row: PropertyRow): unknown {
  switch (row.kind) {
    case 'number':
      return typeof row.default === 'number' ? Math.max(row.default / 2 + 0.25, row.range?.from ?? 0) : 0.25;
    case 'color':
      return new Color('tomato');
    case 'vector2':
      return new Vector2(0.25, 0.75);
    case 'point':
      return new Vector3(1, 2, 3);
    case 'texture':
      return new Texture();
    case 'tonalArtMap':
      return TonalArtMap.fromHatchImages({ size: 2, images: [[new Uint8Array(4).fill(255)], [new Uint8Array(4)]] });
    case 'hand':
      return learnHand([1, 2, 3].map((y) => ({ points: [0, y, 5, y, 10, y], widths: [0.2, 0.5, 0.2] })));
    case 'choice':
      // One that the first technique knows.
      return (row.choicesFor?.strokes ?? Object.keys(row.choices)).find((choice) => choice !== HATCHING_DEFAULTS[name]);
    case 'switch':
      return true;
    case 'curve':
      return [
        [0, 0.1],
        [1, 0.9],
      ];
  }
}

const changed = Object.fromEntries(rows.map(([name, row]) => [name, anotherValue(name, row)]));
/** How errors name the owner of a property. */
const OWNERS = {
  material: 'HatchingMaterial',
  composition: 'HatchingComposition',
  perTriangle: 'HatchingMaterial.perTriangle',
  shadowMaterial: 'HatchingShadowMaterial',
} as const;
/** Properties that three's own material always writes. */
const WRITTEN_BY_THREE = [
  ...['color', 'shininess', 'emissive', 'emissiveIntensity', 'flatShading', 'metalness', 'roughness'],
];

const plain = (value: unknown): unknown =>
  value instanceof Color
    ? value.getHex()
    : value instanceof Vector2 || value instanceof Vector3
      ? value.toArray()
      : value;

describe('the table of properties', () => {
  const written = outputs();
  test.each(Object.keys(written))('%s is up to date; if not, run `npm run properties`', (path) => {
    expect(readFileSync(path, 'utf8')).toBe(written[path]);
  });

  test('names existing techniques', () => {
    const techniques = Object.keys(PROPERTIES.technique.choices);
    for (const [name, row] of rows)
      expect(techniques, name).toEqual(expect.arrayContaining([...(row.techniques ?? [])]));
  });

  test('keeps its sentences out of the bundle', () => {
    const runtime = JSON.stringify([HATCHING_PROPERTIES, HATCHING_DEFAULTS]);
    for (const [name, { sentence }] of rows) expect(runtime, name).not.toContain(sentence.slice(0, 20));
  });
});

describe('every property', () => {
  test('has its default', () => {
    const material = new HatchingMaterial();
    for (const [name, { owner }] of rows) {
      const holder = owner === 'shadowMaterial' ? new HatchingShadowMaterial() : material;
      expect(plain(givenValue(holder, name)), name).toEqual(defaultOf(name, 'hatching'));
    }
  });

  test('is copied', () => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const source = new HatchingShadowMaterial(parametersOf(changed));
    const clone = source.clone();
    for (const [name] of rows) {
      expect(plain(givenValue(source, name)), name).toEqual(plain(changed[name]));
      expect(plain(givenValue(clone, name)), name).toEqual(plain(changed[name]));
    }
    expect(clone.composition).toBe(source.composition);
    expect(clone.perTriangle).not.toBe(source.perTriangle);
    expect(clone.defines).toEqual(source.defines);
  });

  test('is written as JSON unless it is at its default, except the tonal art map', () => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const bare = new HatchingMaterial().toJSON() as unknown as Record<string, unknown>;
    const full = new HatchingShadowMaterial(parametersOf(changed)).toJSON() as unknown as typeof bare;
    expect(bare.type).toBe('HatchingMaterial');
    expect(bare).not.toHaveProperty('uniforms');
    expect(bare).not.toHaveProperty('composition');
    expect(bare).not.toHaveProperty('perTriangle');
    for (const [name, { kind, owner }] of rows) {
      if (owner === 'composition' || owner === 'perTriangle')
        expect((full[owner] as typeof bare)[name], name).toEqual(plain(changed[name]));
      else if (kind === 'texture') expect(full[name], name).toBe((changed[name] as Texture).uuid);
      else if (kind === 'tonalArtMap') expect(full).not.toHaveProperty(name);
      else expect(full[name], name).toEqual(plain(changed[name]));
      if (!WRITTEN_BY_THREE.includes(name)) expect(bare).not.toHaveProperty(name);
    }
  });

  test('reaches the shader, each by its uniform or its define', () => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const seen = ({ vertexShader, fragmentShader, defines, uniforms }: HatchingMaterial): string => {
      const values = Object.entries(uniforms).map(([key, { value }]) => [key, idOf(value)]);
      return JSON.stringify([vertexShader, fragmentShader, defines, values]);
    };
    for (const [name, row] of rows) {
      // Without highlights their softness has no effect, and an exposure that is not fitted has no compensation.
      const base = {
        technique: row.techniques?.[0] ?? (row.owner === 'composition' ? 'hatching' : 'adjacency'),
        highlightThreshold: 0.1,
        exposure: 'auto',
        ...(name === 'focusRadius' && { focus: [0, 0, 0] }),
      };
      const Made = row.owner === 'shadowMaterial' ? HatchingShadowMaterial : HatchingMaterial;
      const drawn = (values: object): string => {
        const material = new Made(parametersOf({ ...base, ...values }));
        material.copy(material);
        return seen(material);
      };
      const { tonalArtMap } = changed;
      const before = drawn({ tonalArtMap: name === 'tonalArtMap' ? null : tonalArtMap });
      expect(drawn({ tonalArtMap, [name]: anotherValue(name, row) }), name).not.toBe(before);
    }
  });
});

describe('a property that does not count for the technique', () => {
  const unused = rows.flatMap(([name, { techniques }]) =>
    Object.keys(PROPERTIES.technique.choices)
      .filter((technique) => techniques && !techniques.includes(technique))
      .map((technique) => [name, technique as HatchingMaterial['technique']] as const),
  );

  test.each(unused)('%s under %s does not change the program', (name, technique) => {
    const material = new HatchingMaterial({ technique });
    const { version } = material;
    Object.assign(material, parametersOf({ [name]: changed[name] }));
    expect(material.version).toBe(version);
  });

  test('is remembered for the technique that uses it', () => {
    const material = new HatchingMaterial({ technique: 'hatching' });
    material.perTriangle.levelRule = 'depth';
    material.perTriangle.sharpInk = true;
    expect(material.defines).toEqual(new HatchingMaterial({ technique: 'hatching' }).defines);
    material.technique = 'adjacency';
    const expected = new HatchingMaterial({
      technique: 'adjacency',
      perTriangle: { levelRule: 'depth', sharpInk: true },
    });
    expect(material.defines).toEqual(expected.defines);
  });

  test('causes one warning if it is set to another value than its default', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    new HatchingMaterial({ technique: 'hatching', perTriangle: { blendAngle: HATCHING_DEFAULTS.blendAngle } });
    expect(warn).not.toHaveBeenCalled();
    for (let i = 0; i < 2; i++) new HatchingMaterial({ perTriangle: { blendAngle: 1 }, technique: 'hatching' });
    expect(warn.mock.calls).toEqual([
      ['HatchingMaterial.perTriangle: "blendAngle" is not used by the technique "hatching", only by adjacency.'],
    ]);
  });
});

/** Objects by their content, so that equal ones compare as equal. */
const idOf = (value: unknown): unknown =>
  (value as Texture | null)?.isTexture ? (value as Texture).uuid : value instanceof Color ? value.getHex() : value;

describe('a value out of range', () => {
  const numbers = rows.flatMap(([name, row]) => (row.kind === 'number' ? [[name, row] as const] : []));
  const outside = ({ above, from, to }: NumberRange = {}): number[] => [
    Number.NaN,
    Infinity,
    ...[above, from === undefined ? from : from - 0.1, to && to + 0.1].filter((x) => x !== undefined),
  ];

  test.each(numbers)('%s is refused, and the previous value stays', (name, row) => {
    const { range } = row;
    const material = new HatchingShadowMaterial();
    const fallback = givenValue(material, name);
    for (const value of [...outside(range), '1', ...(row.default === null ? [] : [null])]) {
      const set = (): unknown => Object.assign(material, parametersOf({ [name]: value }));
      expect(set, String(value)).toThrow(`${OWNERS[row.owner ?? 'material']}.${name}: ${value} is not a number`);
    }
    expect(givenValue(material, name)).toBe(fallback);
    for (const value of [range?.from, range?.to].filter((bound) => bound !== undefined)) {
      Object.assign(material, parametersOf({ [name]: value }));
      expect(givenValue(material, name)).toBe(value);
    }
  });

  test.each([5, 'map', {}, undefined])('tonalArtMap is refused: %j', (value) => {
    const material = new HatchingMaterial();
    expect(() => Object.assign(material, { tonalArtMap: value })).toThrow('HatchingMaterial.tonalArtMap: ');
    expect(material.tonalArtMap).toBe('hatching');
  });
});

test('vectors may be given as arrays, and stay vectors of their own', () => {
  const given = [0.2, 0.4] as const;
  const material = new HatchingMaterial({ perTriangle: { strokeOffset: given }, normalScale: [2, 3] });
  const { strokeOffset } = material.perTriangle;
  expect([strokeOffset, material.normalScale]).toEqual([new Vector2(0.2, 0.4), new Vector2(2, 3)]);
  material.setValues({ perTriangle: { strokeOffset: [0, 1] } });
  expect(material.perTriangle.strokeOffset).toBe(strokeOffset);
  expect(strokeOffset.toArray()).toEqual([0, 1]);
  for (const wrong of [[1], [1, 2, 3], [1, '2'], [Number.NaN, 0]]) {
    expect(() => material.setValues({ perTriangle: { strokeOffset: wrong as unknown as [number, number] } })).toThrow(
      'array of two',
    );
  }
});

describe('the width of strokes on the screen', () => {
  const map = (strokeTexels: number) =>
    TonalArtMap.fromHatchImages({ size: 1, strokeTexels, images: [[new Uint8Array([255])], [new Uint8Array(1)]] });

  test('follows from the width that the map draws', () => {
    const material = new HatchingMaterial({ tonalArtMap: map(2.5), strokeWidth: 5 });
    expect(material.uniforms.texelPixels.value).toBe(2);
    const wider = new HatchingMaterial({ tonalArtMap: map(1.25), strokeWidth: 5 });
    expect(wider.uniforms.texelPixels.value).toBe(4);
  });

  test('is that of the map by default', () => {
    const material = new HatchingMaterial({ tonalArtMap: map(2), technique: 'adjacency' });
    expect(material.strokeWidth).toBe(null);
    expect(material.uniforms.texelPixels.value).toBe(1);
    expect(material.uniforms.dotPixels.value).toBe(2);
  });
});

describe('JSON', () => {
  test('restores every property, textures by their uuid, except the tonal art map', () => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    const source = new HatchingShadowMaterial({ ...parametersOf(changed), side: DoubleSide, fog: false });
    source.name = 'stone';
    source.stencilRef = 3;
    source.userData = { note: [1, 2] };
    source.depthWrite = false;
    const given = names.map((name) => changed[name]).filter((value) => value instanceof Texture);
    const textures = Object.fromEntries(given.map((texture) => [texture.uuid, texture]));
    const made = HatchingShadowMaterial.fromJSON(JSON.parse(JSON.stringify(source.toJSON())), textures);
    for (const name of names.filter((name) => name !== 'tonalArtMap')) {
      expect(plain(givenValue(made, name)), name).toEqual(plain(givenValue(source, name)));
    }
    for (const key of ['uuid', 'name', 'side', 'fog', 'stencilRef', 'depthWrite', 'userData'] as const) {
      expect(made[key], key).toEqual(source[key]);
    }
    expect(made.defines).toEqual(source.defines);
    expect(HatchingMaterial.fromJSON(JSON.parse(JSON.stringify(source.toJSON()))).map).toBe(null);
  });

  test("three's own loader finds the class once it is registered", () => {
    MaterialLoader.registerMaterial('HatchingMaterial', HatchingMaterial);
    const source = new HatchingMaterial({ ink: 'navy', tilesPerObjectUnit: 5, technique: 'hatching' });
    const made = new MaterialLoader().parse(JSON.parse(JSON.stringify(source.toJSON())));
    expect(made).toBeInstanceOf(HatchingMaterial);
    expect(made).toMatchObject({ tilesPerObjectUnit: 5, technique: 'hatching', ink: source.ink });
  });
});

describe('what belongs to the user', () => {
  test('defines are added to the material’s own', () => {
    const plainDefines = new HatchingMaterial({ technique: 'hatching' }).defines;
    const material = new HatchingMaterial({ defines: { MINE: 1 }, technique: 'hatching' });
    expect(material.defines).toEqual({ ...plainDefines, MINE: 1 });
    expect(material.clone().defines).toEqual(material.defines);
  });

  test('shaders stay as they were changed until the technique changes', () => {
    const material = new HatchingMaterial({ technique: 'adjacency' });
    const own = material.fragmentShader;
    material.fragmentShader = own.replace('void main', '// mine\nvoid main');
    material.toneModel = 'toon';
    expect(material.fragmentShader).toContain('// mine');
    expect(material.clone().fragmentShader).toContain('// mine');
    material.technique = 'triangle';
    material.technique = 'adjacency';
    expect(material.fragmentShader).toBe(own);
  });

  test('copying onto a material that was drawn changes its program', () => {
    const material = new HatchingMaterial();
    const { version } = material;
    material.copy(new HatchingMaterial({ toneModel: 'toon' }));
    expect(material.version).toBeGreaterThan(version);
  });

  test('toneNormal returns to the default of the technique', () => {
    const material = new HatchingMaterial({ technique: 'hatching', toneNormal: 'face' });
    material.toneNormal = 'auto';
    expect(material.toneNormal).toBe('smooth');
    material.technique = 'triangle';
    expect(material.toneNormal).toBe('face');
    expect(() => Object.assign(material, { inkBlend: 'auto' })).toThrow('"auto" is not known');
  });
});
