import { describe, expect, test } from 'vitest';
import { radianceAround } from '../../../../src/look/surroundings.js';
import { combined, normalize, type Vec3 } from '../../../../src/look/vectors.js';
import { fitToneCurve } from '../../../../src/material/fitToneCurve.js';
import {
  arriving,
  type Lamp,
  reflectedTo,
  responseTo,
  type ToneModel,
} from '../../../../src/vector/shading/radiance.js';
import {
  type ColorTones,
  localDarkness,
  openToLights,
  openToSky,
  shadedTone,
  type ToneLook,
  toneFromRadiance,
} from '../../../../src/vector/shading/tone.js';
import { defaults } from '../../../gpu/referenceScenes.js';
import { HatchingReference, type ReferenceLight } from '../../../reference/hatchingReference.js';
import { randomNumbers } from '../randomNumbers.js';

const CURVE: [number, number][] = [
  [0, 0],
  [0.3, 0.06],
  [0.6, 0.44],
  [1, 0.86],
];

const look: ToneLook = {
  curve: null,
  steps: 0,
  exposure: [1, 0],
  highlightRamp: [5e5, 0.5],
  toneEnds: [0, 1],
  occlusion: 1,
  hollowStrength: 1,
  openOcclusion: 0,
  darkness: 0,
};

const LUMINANCE: Vec3 = [0.2126729, 0.7151522, 0.072175];
const luminanceOf = ([r, g, b]: Vec3): number => r * LUMINANCE[0] + g * LUMINANCE[1] + b * LUMINANCE[2];

const lights: ReferenceLight[] = [
  { type: 'directional', color: [1, 0.8, 0.5], position: [1, 2, 3], target: [0, 0, 0] },
  { type: 'point', color: [4, 4, 6], position: [1, 1, -2], distance: 8, decay: 1.5 },
  { type: 'spot', color: [9, 9, 9], position: [-2, 3, 1], target: [0, 0, 0], angle: 0.6, penumbra: 0.4, decay: 2 },
];

const lamps = lights.map(({ type, color, position, target, distance = 0, decay = 2, angle, penumbra }): Lamp => {
  const isFar = type === 'directional';
  const way = target ? normalize(combined(1, position!, -1, target)) : ([0, 0, 0] as const);
  const cone =
    type === 'spot' ? { axis: way, outer: Math.cos(angle!), inner: Math.cos(angle! * (1 - penumbra!)) } : null;
  const at = isFar ? way : position!;
  return { luminance: luminanceOf(color), at, isFar, distance, decay, cone, castsShadow: false };
});

/** The radiance of a white surface from lamps alone. */
function radianceAt(
  point: Vec3,
  normal: Vec3,
  eye: Vec3,
  model: ToneModel,
  shininess: number,
  reflected: number,
  isPlane: boolean,
): number {
  const toViewer = normalize(combined(1, eye, -1, point));
  return lamps.reduce((sum, lamp) => {
    const { direction, luminance, coneless } = arriving(lamp, point);
    const direct = luminance * responseTo(model, normal, direction, toViewer, shininess);
    return sum + (direct + reflected * coneless * reflectedTo(normal, direction, isPlane)) / Math.PI;
  }, 0);
}

describe('the tone at a place is that of the reference', () => {
  test.each(['lambert', 'halfLambert', 'phong', 'toon'] as const)('%s, with every curve', (toneModel) => {
    const random = randomNumbers(3);
    for (let i = 0; i < 200; i++) {
      const toneCurve = ([CURVE, 'linear', 'perceptual'] as const)[i % 3];
      const curve = toneCurve === 'linear' ? null : toneCurve === 'perceptual' ? toneCurve : fitToneCurve(toneCurve);
      const [exposure, reflectedLight] = [0.5 + random(), random()];
      const eye: Vec3 = [0, 1, 5];
      const reference = new HatchingReference({
        matrixWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        eye: [...eye],
        lights,
        material: { ...defaults, toneModel, toneCurve, exposure, reflectedLight, shininess: 12, toneSteps: 5 },
        tones: 2,
        image: (tone) => tone,
      });
      const point: Vec3 = [random() - 0.5, random() - 0.5, random() - 0.5];
      const normal = normalize([random() - 0.5, random() - 0.5, random() - 0.5]);
      const radiance = radianceAt(point, normal, eye, toneModel, 12, reflectedLight, i % 2 === 1);
      const given: ToneLook = { ...look, curve, exposure: [exposure, 0], steps: toneModel === 'toon' ? 5 : 0 };
      const own = { ...given, toneEnds: [0, toneFromRadiance(0, given)] as const };
      // The curve is in single precision.
      const expected = reference.tone([...point], [...normal], true, i % 2 === 1);
      expect(Math.abs(shadedTone(radiance, 0, own) - expected)).toBeLessThan(1e-6);
    }
  });

  test('under hemisphere and ambient light', () => {
    const random = randomNumbers(19);
    const color = (): [number, number, number] => [random(), random(), random()];
    for (let i = 0; i < 100; i++) {
      const [ambient, above, below] = [color(), color(), color()];
      const up = normalize([random() - 0.5, random() - 0.5, random() - 0.5]);
      const reference = new HatchingReference({
        matrixWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        eye: [0, 1, 5],
        lights: [
          { type: 'ambient', color: ambient },
          { type: 'hemisphere', color: above, groundColor: below, position: [...up] },
        ],
        material: { ...defaults, toneModel: 'lambert', toneCurve: 'linear' },
        tones: 2,
        image: (tone) => tone,
      });
      const normal = normalize([random() - 0.5, random() - 0.5, random() - 0.5]);
      const [high, low] = [luminanceOf(above), luminanceOf(below)];
      const skies = [{ up, mean: (high + low) / 2, difference: (high - low) / 2 }];
      const around = { ambient: luminanceOf(ambient), skies, probes: new Float64Array(9), environment: null };
      const expected = reference.tone([0, 0, 0], [...normal]);
      expect(Math.abs(shadedTone(radianceAround(around, ...normal), 0, look) - expected)).toBeLessThan(1e-6);
    }
  });

  const measured: ColorTones = {
    colorHatching: 1,
    colorExposure: 1,
    colorFilter: [0.2126, 0.7152, 0.0722, 0],
    valueKnots: [0, 0, 0, 0],
    valueBends: [0, 0, 0, 0],
  };
  /** The darkness of a grey. */
  const darkness = (luminance: number, tones: Partial<ColorTones> = {}, emitted = 0): number =>
    localDarkness([luminance, luminance, luminance], emitted, { ...measured, ...tones });

  test('planned values are straight between the knots, behind a filter, and mix with those that are measured', () => {
    const plan = { valueKnots: [0.8, 0.5, 0.2, 0], valueBends: [0.5, 1, -1.5, 0] };
    const red = [1, 0, 0];
    const planned = (color: Vec3, share = 1): number =>
      localDarkness(color, 0, { ...measured, ...plan, colorFilter: [...red, share] });
    // Half as light as white is at the second knot; nearly black below the third.
    expect(planned([1, 0, 0])).toBe(0);
    expect(planned([0.18418651851, 1, 1])).toBeCloseTo(0.15, 6);
    expect(planned([0, 1, 1])).toBeCloseTo(0.6, 6);
    expect(planned([0.001, 1, 1])).toBeCloseTo(0.6, 6);
    expect(planned([0, 1, 1], 0.5)).toBeCloseTo(0.8, 6);
  });

  test('a colour is darker by as much as it looks darker than white', () => {
    expect(darkness(0.1842)).toBeCloseTo(0.5, 3);
    expect(darkness(0.1842, { colorHatching: 0.5 })).toBeCloseTo(0.25, 3);
    expect(darkness(0.1842, { colorExposure: 2 })).toBeCloseTo(0, 2);
    expect(darkness(0, {}, 1)).toBe(0);
    expect(shadedTone(1, 0, { ...look, darkness: 0.5, toneEnds: [0, 0.8] })).toBeCloseTo(0.4, 9);
  });
});

describe('occlusion', () => {
  test('takes all of its share of the sky, and of lamps only where much of the sky is hidden', () => {
    expect(openToSky(0.5, 1)).toBe(0.5);
    expect(openToLights(0.5, 1)).toBe(0.5);
    expect(openToLights(0.04, 1)).toBeGreaterThan(0.995);
    expect(openToLights(0.5, 0)).toBe(1);
  });

  test('makes deep hollows fully dark, whatever light falls into them', () => {
    expect(shadedTone(1, 0.8, look)).toBe(1);
    expect(shadedTone(1, 0.1, look)).toBe(0);
    // Half way between shallow and deep hollows.
    expect(shadedTone(1, 0.45, look)).toBeCloseTo(0.5, 9);
    expect(shadedTone(1, 0.8, { ...look, hollowStrength: 0 })).toBe(0);
    // Chalk draws the lights: a hollow is bare paper.
    expect(shadedTone(0, 0.8, { ...look, toneEnds: [0.95, 0] })).toBe(0);
  });
});

test('below the highlight tone the paper stays blank, with an edge as soft as asked', () => {
  const sharp: ToneLook = { ...look, highlightRamp: [0.5 / 1e-6, 0.5 - (0.5 * 0.3) / 1e-6] };
  expect(toneFromRadiance(0.71, sharp)).toBe(0);
  expect(toneFromRadiance(0.69, sharp)).toBeCloseTo(0.31, 9);
});
