import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  Color,
  DataUtils,
  DoubleSide,
  Mesh,
  ShaderChunk,
  ShaderLib,
  Texture,
  Vector2,
  Vector3,
} from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { HATCHING_PROPERTIES } from '../../../src/look/hatchingProperties.js';
import type { HatchingMaterialParameters } from '../../../src/material/checkValues.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { programSwitches } from '../../../src/material/programDefines.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';

// Materials are read in the same task in which they are created.
await HatchingMaterial.preload();

const map = TonalArtMap.fromHatchImages({ size: 4, images: [255, 128, 0].map((v) => [new Uint8Array(16).fill(v)]) });

afterEach(() => vi.restoreAllMocks());

describe('HatchingMaterial', () => {
  test("knows the channels of its maps when the renderer is about to choose a program, also with a user's own program key", () => {
    const material = new HatchingMaterial();
    material.customProgramCacheKey = () => 'mine';
    material.map = new Texture();
    material.aoMap = new Texture();
    material.aoMap.channel = 2;
    expect(material.customProgramCacheKey()).toBe('mine');
    expect(material.defines).toMatchObject({ MAP_CHANNEL: 'vUv', AOMAP_CHANNEL: 'vUv2', USE_UV0: '' });
    material.map = null;
    material.customProgramCacheKey();
    expect(Object.keys(material.defines)).not.toContain('MAP_CHANNEL');
    expect(Object.keys(material.defines)).not.toContain('USE_UV0');
  });

  test('draws lines by the light on a mesh that was prepared without the form they should follow', () => {
    const material = new HatchingMaterial({ technique: 'engraving', direction: 'acrossForm' });
    const { choices } = HATCHING_PROPERTIES.direction;
    const drawn = (geometry: BufferGeometry) => {
      material.announce(new Mesh(geometry));
      return choices[material.defines.DIRECTION as number];
    };
    const formed = new BoxGeometry();
    formed.setAttribute('formValue', new BufferAttribute(new Float32Array(48), 2));
    expect(choices[material.defines.DIRECTION as number]).toBe('acrossForm');
    expect(drawn(new BoxGeometry())).toBe('light');
    expect(drawn(formed)).toBe('acrossForm');
    expect(drawn(new BoxGeometry())).toBe('light');
    material.direction = 'auto';
    expect([drawn(formed), drawn(new BoxGeometry())]).toEqual(['form', 'light']);
    expect(material.clone().direction).toBe('auto');
    material.direction = 'x';
    expect(drawn(new BoxGeometry())).toBe('x');
    expect(material.direction).toBe('x');
  });

  test('draws strokes that turn with the light on a mesh that was prepared without the form they should follow', () => {
    const material = new HatchingMaterial({ direction: 'acrossForm' });
    const { choices } = HATCHING_PROPERTIES.direction;
    const drawn = (geometry: BufferGeometry) => {
      material.announce(new Mesh(geometry));
      return choices[material.defines.DIRECTION as number];
    };
    const formed = new BoxGeometry();
    formed.setAttribute('formValue', new BufferAttribute(new Float32Array(48), 2));
    expect([drawn(new BoxGeometry()), drawn(formed)]).toEqual(['light', 'acrossForm']);
    expect(material.direction).toBe('acrossForm');
    expect(material.clone().direction).toBe('acrossForm');
    material.direction = 'light';
    expect(drawn(formed)).toBe('light');
  });

  test('can be made without parameters, with the documented defaults', () => {
    const material = new HatchingMaterial();
    expect(material.isHatchingMaterial).toBe(true);
    expect(material.type).toBe('HatchingMaterial');
    expect(material).toMatchObject({
      technique: 'hatching',
      screenSpaceShare: 1,
      strokeWidth: 1.5,
      toneModel: 'lambert',
      toneNormal: 'smooth',
      debugView: 'none',
      strokeAnchor: 'rest',
      tilesPerObjectUnit: 3,
      strokeAngle: Math.PI / 2,
      tonalArtMap: 'hatching',
      toneCurve: 'printed',
      reflectedLight: 0.35,
      strokeLayers: 'tone',
      toneMapped: false,
      perTriangle: { levelRule: 'derivatives' },
      inkBlend: 'cover',
      paperOpacity: 1,
    });
    expect(material.paper.getHex()).toBe(0xffffff);
    expect(material.ink.getHex()).toBe(0x000000);
  });

  test.each([
    ['triangle', {}],
    ['adjacency', { blendAngle: Math.PI / 2 }],
  ] as const)('%s alone draws the equations of Suarez et al.', (technique, more) => {
    expect(new HatchingMaterial({ technique })).toMatchObject({
      ...{ toneNormal: 'face', toneCurve: 'linear', reflectedLight: 0, strokeLayers: 'single', crossFrom: 0.52 },
      ...{ strokeAngle: 0, strokeWidth: null, tilesPerObjectUnit: 3 },
      perTriangle: { sharpInk: false, levelRule: 'derivatives', ...more },
    });
  });

  test('numbers that were never set follow the technique, in clones too', () => {
    const material = new HatchingMaterial({ crossFrom: 0.3 });
    for (const one of [material, material.clone()]) {
      one.technique = 'adjacency';
      expect([one.crossFrom, one.reflectedLight, one.strokeWidth, one.toneCurve]).toEqual([0.3, 0, null, 'linear']);
      one.technique = 'hatching';
      expect([one.crossFrom, one.reflectedLight, one.strokeWidth, one.toneCurve]).toEqual([0.3, 0.35, 1.5, 'printed']);
    }
  });

  describe('a preset by its name', () => {
    const looks = ({ technique, strokeLayers, ink, tonalArtMap }: HatchingMaterial) => [
      ...[technique, strokeLayers, `#${ink.getHexString()}`, tonalArtMap],
    ];

    test('sets the preset, overridden by the other parameters, in any order', () => {
      const given = new HatchingMaterial({ ink: '#000080', preset: 'stipple' });
      expect(looks(given)).toEqual(['stipple', 'single', '#000080', 'hatching']);
      expect(looks(new HatchingMaterial({ preset: 'crossHatching' }))[0]).toBe('pen');
    });

    test('resets the former preset', () => {
      const material = new HatchingMaterial({ preset: 'charcoal' });
      material.preset = 'woodcut';
      material.preset = 'pen';
      expect(looks(material)).toEqual(looks(new HatchingMaterial({ preset: 'pen' })));
      expect(material.defines).toEqual(new HatchingMaterial({ preset: 'pen' }).defines);
    });

    test('must exist', () => {
      expect(() => new HatchingMaterial({ preset: 'etching' as 'pen' })).toThrow(
        'HatchingMaterial: there is no preset "etching". Use one of pen, crossHatching, ',
      );
    });
  });

  test('no map is requested before a renderer draws; null stays blank paper', async () => {
    const shared = vi.spyOn(TonalArtMap, 'shared');
    const material = new HatchingMaterial();
    const { tonalArtMap } = HatchingMaterial.fromJSON(JSON.parse(JSON.stringify(material.clone().toJSON())));
    expect([tonalArtMap, material.tonalArtMap]).toEqual(['hatching', 'hatching']);
    const blank = new HatchingMaterial({ tonalArtMap: null });
    expect(HatchingMaterial.fromJSON(JSON.parse(JSON.stringify(blank.toJSON()))).tonalArtMap).toBe(null);
    await blank.ready;
    await new HatchingMaterial({ technique: 'engraving' }).ready;
    await new HatchingMaterial({ technique: 'stipple' }).ready;
    expect(shared).not.toHaveBeenCalled();
    expect(() => {
      material.tonalArtMap = 'hachures' as 'hatching';
    }).toThrow('HatchingMaterial.tonalArtMap: "hachures" is no style; use one of hatching, ');
    shared.mockRestore();
  });

  test('takes parameters the way three does', () => {
    const material = new HatchingMaterial({
      tonalArtMap: map,
      technique: 'triangle',
      ink: '#112233',
      perTriangle: { strokeOffset: new Vector2(0.25, 0.5) },
      side: DoubleSide,
      opacity: 0.5,
    });
    expect(material.technique).toBe('triangle');
    expect(material.ink.equals(new Color('#112233'))).toBe(true);
    expect(material.perTriangle.strokeOffset.toArray()).toEqual([0.25, 0.5]);
    expect(material.side).toBe(DoubleSide);
    expect(material.uniforms.tonalArtMap.value).toBe(map.texture);
    expect(material.uniforms.opacity.value).toBe(0.5);
  });

  test('warns of a parameter it does not know', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    new HatchingMaterial({ tilesPerUnits: 2 } as HatchingMaterialParameters);
    expect(warn.mock.calls.flat().join(' ')).toContain('tilesPerUnits');
  });

  test.each(['technique', 'toneModel', 'toneNormal', 'inkBlend', 'strokeAnchor', 'strokeLayers', 'debugView'] as const)(
    'refuses an unknown %s',
    (property) => {
      const material = new HatchingMaterial();
      const before = material[property];
      expect(() => {
        (material as unknown as Record<string, string>)[property] = 'nonsense';
      }).toThrow(`HatchingMaterial.${property}: "nonsense" is not known; use one of`);
      expect(material[property]).toBe(before);
    },
  );

  test('changes its program only if the shader changes', () => {
    const material = new HatchingMaterial({ tonalArtMap: map, technique: 'adjacency' });
    const { version } = material;
    material.tilesPerObjectUnit = 7;
    material.strokeAngle = 1;
    material.perTriangle.strokeOffset.set(0.1, 0.2);
    material.toneSteps = 6;
    material.shininess = 5;
    material.perTriangle.blendAngle = 1;
    material.reflectedLight = 0.3;
    material.paperOpacity = 0.5;
    material.ink.set('red');
    material.technique = 'adjacency';
    material.toneCurve = 'linear';
    material.perTriangle.levelRule = 'derivatives';
    material.inkBlend = 'cover';
    material.strokeLayers = 'single';
    expect(material.version).toBe(version);
    material.technique = 'triangle';
    material.perTriangle.levelRule = 'depth';
    material.inkBlend = 'multiply';
    material.strokeLayers = 'tone';
    expect(material.version).toBe(version + 4);
  });

  test('a new tone curve changes the program only if it is of another kind', () => {
    const material = new HatchingMaterial({ toneCurve: 'linear' });
    const { version } = material;
    material.toneCurve = [
      [0, 0],
      [1, 0.8],
    ];
    expect(material.version).toBe(version + 1);
    const points = [
      [0, 0.1],
      [0.5, 0.2],
      [1, 1],
    ] as const;
    material.toneCurve = points;
    expect(material.version).toBe(version + 1);
    expect(material.toneCurve).toBe(points);
    const { data } = material.uniforms.toneCurveTable.value.image;
    expect([data[0], data.at(-1)].map(DataUtils.fromHalfFloat)).toEqual([expect.closeTo(0.1, 3), 1]);
    material.toneCurve = 'perceptual';
    expect(material.version).toBe(version + 2);
  });

  test.each(['dark', 'points', [[0, 0]]])('refuses the tone curve %j and keeps the one it has', (curve) => {
    const material = new HatchingMaterial({ toneCurve: 'perceptual' });
    expect(() => {
      material.toneCurve = curve as 'linear';
    }).toThrow('HatchingMaterial.toneCurve: ');
    expect(material.toneCurve).toBe('perceptual');
    expect(material.defines).toEqual(new HatchingMaterial({ toneCurve: 'perceptual' }).defines);
  });

  test('tone is smooth with anchored and faceted with the techniques of Suarez et al., unless it is set', () => {
    const material = new HatchingMaterial({ technique: 'hatching' });
    expect(material.toneNormal).toBe('smooth');
    material.technique = 'adjacency';
    expect(material.toneNormal).toBe('face');
    material.toneNormal = 'smooth';
    material.technique = 'triangle';
    expect(material.toneNormal).toBe('smooth');
    expect(new HatchingMaterial({ toneNormal: 'face', technique: 'hatching' }).toneNormal).toBe('face');
    expect(material.clone().toneNormal).toBe('smooth');
  });

  test('sharp ink changes the program, and only when it is changed', () => {
    const material = new HatchingMaterial({ technique: 'adjacency' });
    const { version } = material;
    material.perTriangle.sharpInk = false;
    expect(material.version).toBe(version);
    material.perTriangle.sharpInk = true;
    expect(material.version).toBe(version + 1);
    expect(material.clone().perTriangle.sharpInk).toBe(true);
  });

  test('strokes sized on the object alone have a program of their own, and all other sizes share one', () => {
    const material = new HatchingMaterial({ technique: 'hatching' });
    // The renderer reads it when it chooses a program.
    const definesAt = (screenSpaceShare: number) => {
      material.screenSpaceShare = screenSpaceShare;
      material.customProgramCacheKey();
      return { ...material.defines };
    };
    const onObject = definesAt(0);
    expect(definesAt(0.5)).not.toEqual(onObject);
    expect(definesAt(0.5)).toEqual(definesAt(1));
    expect(definesAt(0)).toEqual(onObject);
    expect(programSwitches(Object.assign(material, { screenSpaceShare: 0.4 }))).not.toBe(
      programSwitches(new HatchingMaterial({ technique: 'hatching', screenSpaceShare: 0 })),
    );
  });

  test('a vignette or a focus that is not there is not in the program, and all that are there share one', () => {
    const material = new HatchingMaterial();
    const programWith = (vignette: number, focus: Vector3 | null): [isDefined: boolean, switches: number] => {
      Object.assign(material.composition, { vignette, focus });
      material.customProgramCacheKey();
      return ['FADES_AROUND' in material.defines, programSwitches(material)];
    };
    const [isDefined, switches] = programWith(0, null);
    expect(isDefined).toBe(false);
    expect(programWith(0.5, null)).toEqual([true, switches + 1]);
    expect(programWith(1, new Vector3())).toEqual(programWith(0, new Vector3()));
    expect(programWith(1, new Vector3())).toEqual([true, switches + 1]);
  });

  test('reads thresholds only where they are drawn', () => {
    const material = new HatchingMaterial({ tonalArtMap: map, technique: 'adjacency' });
    expect(material.uniforms.thresholdMap.value).toBe(null);
    const anchored = new HatchingMaterial({ tonalArtMap: map, technique: 'hatching' });
    expect(anchored.uniforms.thresholdMap.value).toBe(map.thresholdTexture);
  });

  test('clones to an equal material that shares textures and nothing else', () => {
    const source = new HatchingMaterial({
      tonalArtMap: map,
      technique: 'triangle',
      toneModel: 'toon',
      toneSteps: 6,
      toneNormal: 'smooth',
      debugView: 'tone',
      strokeAnchor: 'deformed',
      tilesPerObjectUnit: 5,
      strokeAngle: 0.5,
      perTriangle: { strokeOffset: new Vector2(0.1, 0.2), blendAngle: 0.7, levelRule: 'depth' },

      latticeSpacing: 0.2,
      screenSpaceShare: 0.5,
      edgePixels: 0.5,
      shininess: 8,
      toneCurve: [
        [0, 0.1],
        [1, 0.9],
      ],
      reflectedLight: 0.3,
      strokeLayers: 'tone',
      crossAngle: 1.2,

      inkBlend: 'multiply',
      paperOpacity: 0.4,
      ink: 'navy',
      paper: 'ivory',
      color: 'tan',
      map: new Texture(),
      alphaMap: new Texture(),
      fog: false,
      transparent: true,
      opacity: 0.25,
    });
    const clone = source.clone();
    expect(clone).toBeInstanceOf(HatchingMaterial);
    for (const key of [
      'tonalArtMap',
      'technique',
      'toneModel',
      'toneSteps',
      'toneNormal',
      'debugView',
      'strokeAnchor',
      'tilesPerObjectUnit',
      'strokeAngle',
      'latticeSpacing',
      'screenSpaceShare',
      'edgePixels',
      'shininess',
      'toneCurve',
      'reflectedLight',
      'strokeLayers',
      'crossAngle',
      'inkBlend',
      'paperOpacity',
      'map',
      'alphaMap',
      'fog',
      'transparent',
      'opacity',
    ] as const) {
      expect(clone[key], key).toBe(source[key]);
    }
    for (const key of ['ink', 'paper', 'color'] as const) {
      expect(clone[key].equals(source[key]), key).toBe(true);
      expect(clone[key]).not.toBe(source[key]);
    }
    expect(clone.perTriangle.strokeOffset.toArray()).toEqual([0.1, 0.2]);
    for (const key of ['blendAngle', 'levelRule', 'sharpInk'] as const)
      expect(clone.perTriangle[key], key).toBe(source.perTriangle[key]);
    expect(clone.composition).toBe(source.composition);
    expect(clone.uniforms).not.toBe(source.uniforms);
    expect(clone.uniforms.tonalArtMap.value).toBe(map.texture);
    expect(clone.uniforms.toneCurveTable.value.image.data).toEqual(source.uniforms.toneCurveTable.value.image.data);
    clone.technique = 'adjacency';
    clone.ink.set('red');
    expect(source.technique).toBe('triangle');
    expect(source.ink.equals(new Color('navy'))).toBe(true);
  });

  test("leaves three's shader library alone", () => {
    const chunks = Object.keys(ShaderChunk).join();
    new HatchingMaterial();
    expect(Object.keys(ShaderChunk).join()).toBe(chunks);
    expect(ShaderLib).not.toHaveProperty('hatching');
  });

  test('two materials share no uniform object', () => {
    const a = new HatchingMaterial();
    const b = new HatchingMaterial();
    for (const name of Object.keys(a.uniforms)) expect(a.uniforms[name], name).not.toBe(b.uniforms[name]);
  });
});

describe('values of the wrong kind', () => {
  test('are refused before anything is set', () => {
    // three.js warns of colours that it cannot parse.
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const material = new HatchingMaterial();
    for (const [wrong, message] of [
      [{ tilesPerObjectUnit: 7, map: { image: {} } }, 'HatchingMaterial.map: expected a THREE.Texture or null.'],
      [{ tilesPerObjectUnit: 7, normalMap: 1 }, 'HatchingMaterial.normalMap: expected a THREE.Texture or null.'],
      [
        { tilesPerObjectUnit: 7, perTriangle: { strokeOffset: null } },
        'HatchingMaterial.perTriangle.strokeOffset: expected a THREE.Vector2',
      ],
      [
        { tilesPerObjectUnit: 7, normalScale: { x: 1, y: Number.NaN } },
        'HatchingMaterial.normalScale: expected a THREE.Vector2',
      ],
      [{ tilesPerObjectUnit: 7, strokeWidth: '1.9' }, 'HatchingMaterial.strokeWidth: 1.9 is not a number in (0, ∞).'],
      [{ tilesPerObjectUnit: 7, edgePixels: null }, 'HatchingMaterial.edgePixels: null is not a number'],
      [{ tilesPerObjectUnit: 7, direction: 'constructor' }, 'HatchingMaterial.direction: "constructor" is not known'],
      [{ tilesPerObjectUnit: 7, inkBlend: 'auto' }, 'HatchingMaterial.inkBlend: "auto" is not known'],
      [
        { tilesPerObjectUnit: 7, perTriangle: { sharpInk: 'yes' } },
        'HatchingMaterial.perTriangle.sharpInk: expected true or false.',
      ],
      [{ tilesPerObjectUnit: 7, toneCurve: [[0, 0]] }, 'HatchingMaterial.toneCurve: '],
      [{ tilesPerObjectUnit: 7, tonalArtMap: {} }, 'HatchingMaterial.tonalArtMap: '],
      ...['nonsense', 'constructor', '#12', 'rgb(red)', '', null, Number.NaN, {}, true].map(
        (ink) => [{ tilesPerObjectUnit: 7, ink }, 'HatchingMaterial.ink: expected a THREE.Color, a number'] as const,
      ),
      [JSON.parse('{ "tilesPerObjectUnit": 7, "__proto__": { "isMaterial": false } }'), '"__proto__" is no parameter'],
    ] as const) {
      expect(() => material.setValues(wrong as never)).toThrow(message);
      expect(() => new HatchingMaterial(wrong as never)).toThrow(message);
    }
    expect(material.tilesPerObjectUnit).not.toBe(7);
    expect(material).toBeInstanceOf(HatchingMaterial);
    expect(() => Object.assign(material.perTriangle, { sharpInk: 'yes' })).toThrow('expected true or false');
    expect(warn.mock.calls.every(([message]) => /Color/.test(message))).toBe(true);
  });

  test('do not include those that three.js accepts', () => {
    const warn = vi.spyOn(console, 'warn');
    for (const ink of [
      'navy',
      'NAVY',
      '#abc',
      '#A1b2C3',
      'rgb(1, 2, 3)',
      'hsl(120, 50%, 50%)',
      0xff0000,
      new Color(),
    ]) {
      expect(new HatchingMaterial({ ink }).ink.getHex()).toBe(new Color(ink).getHex());
    }
    new HatchingMaterial({
      map: null,
      strokeWidth: null,
      toneNormal: 'auto',
      tonalArtMap: null,
      perTriangle: { sharpInk: false },
    });
    expect(warn).not.toHaveBeenCalled();
  });
});
