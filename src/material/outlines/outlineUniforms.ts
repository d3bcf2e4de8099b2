import { type Color, type IUniform, UniformsLib, UniformsUtils, Vector2, Vector4 } from 'three';
import { HIDDEN_OUTLINES, type HiddenOutlines } from '../../look/hiddenOutlines.js';
import { checkNumber } from '../checkNumber.js';
import { createFadingUniforms } from '../fading/fading.js';
import { keptFromProxies } from '../hatchingUniforms.js';
import { OutlineWeights, setWeights } from './OutlineWeights.js';
import {
  HATCHING_OUTLINE_DEFAULTS,
  OUTLINE_NUMBER_NAMES,
  OUTLINE_NUMBERS,
  OUTLINE_SIZES,
  type OutlineNumberName,
  WEIGHTED_LINES,
} from './outlineProperties.js';

/** The uniforms that may differ between outlines with the same material, and all textures (see `MeshUniforms`). */
export const OUTLINE_MESH_UNIFORMS = [
  ...['outlinePoints', 'outlinePrimitives', 'deformedNormals', 'deformedPositions', 'deformedTurns'],
  ...['candidates', 'instancePlaces', 'sceneDepth', 'toothMap'],
  ...[
    'clippingPlanes',
    'eye',
    'importance',
    'isCutOut',
    'isDrawnBefore',
    'isListed',
    'materialBorders',
    'objectScale',
    'opacity',
    'pull',
    'radius',
    'showsBack',
  ],
];

/** Creates the uniforms of an outline material: those of its properties, of the geometry and camera, and of lights and fog. */
export const createOutlineUniforms = (): Record<string, IUniform> =>
  keptFromProxies(
    UniformsUtils.merge([
      UniformsLib.lights,
      UniformsLib.fog,
      // All are written before the first draw.
      Object.fromEntries(
        [
          ...[...OUTLINE_NUMBER_NAMES, ...WEIGHTED_LINES, ...OUTLINE_MESH_UNIFORMS],
          ...['ink', 'isDashed', 'hasSceneDepth', 'nearDistance'],
        ].map((name) => [name, { value: null }]),
      ),
      createFadingUniforms(),
      {
        shadeWeights: { value: new Vector2() },
        eye: { value: new Vector4() },
        viewport: { value: new Vector4() },
        toothOffset: { value: new Vector2() },
      },
    ]),
  );

/** The values of an outline material. */
type OutlineLook = Record<OutlineNumberName, number> & {
  ink: Color;
  weights: OutlineWeights;
  opacity: number;
  hidden: HiddenOutlines;
};

/**
 * Defines a checked property for each number on a material. @param told called after a property was set. @param owner the name of the class
 */
export function defineOutlineNumbers(
  material: object,
  owner: string,
  told: (name: OutlineNumberName, value: number) => void,
): void {
  for (const name of OUTLINE_NUMBER_NAMES) {
    let current: number = HATCHING_OUTLINE_DEFAULTS[name];
    Object.defineProperty(material, name, {
      get: () => current,
      set: (value: number) => {
        current = checkNumber(name, value, OUTLINE_NUMBERS[name], owner);
        told(name, current);
      },
      enumerable: true,
    });
  }
}

/**
 * Defines the weights of a material. An object that is assigned sets them to what it has, and to the defaults where it has nothing, as
 * attributes of React Three Fiber do.
 *
 * @param owner the name of the class
 */
export function defineOutlineWeights(material: object, owner: string): void {
  const weights = new OutlineWeights(owner);
  Object.defineProperty(material, 'weights', {
    get: () => weights,
    set: (values: Partial<OutlineWeights>) => {
      setWeights(weights, { ...HATCHING_OUTLINE_DEFAULTS.weights, ...values }, owner);
    },
    enumerable: true,
  });
}

/** Defines whether there are lines where surfaces meet, on a material. @param owner the name of the class */
export function defineIntersections(material: object, owner: string): void {
  let current: boolean = HATCHING_OUTLINE_DEFAULTS.intersections;
  Object.defineProperty(material, 'intersections', {
    get: () => current,
    set: (value: boolean) => {
      if (typeof value !== 'boolean') {
        throw new TypeError(`${owner}.intersections is ${String(value)}, but must be true or false.`);
      }
      current = value;
    },
    enumerable: true,
  });
}

/** @throws TypeError unless `value` is one of the choices */
export function checkHidden(value: HiddenOutlines, owner: string): HiddenOutlines {
  if (HIDDEN_OUTLINES.includes(value)) return value;
  throw new TypeError(
    `${owner}.hidden is ${String(value)}, but must be ${HIDDEN_OUTLINES.map((one) => `'${one}'`).join(', ')}.`,
  );
}

/** Writes the properties of a material to uniforms. @param pixelRatio pixels of the render target per CSS pixel */
export function writeOutlineLook(look: OutlineLook, u: Record<string, IUniform>, pixelRatio: number): void {
  for (const name of OUTLINE_NUMBER_NAMES) u[name].value = look[name];
  for (const name of OUTLINE_SIZES) u[name].value *= pixelRatio;
  const { weights } = look;
  for (const name of WEIGHTED_LINES) u[name].value = weights[name];
  (u.shadeWeights.value as Vector2).set(weights.lit, weights.shade);
  u.ink.value = look.ink;
  u.opacity.value = look.opacity;
  u.isDashed.value = look.hidden === 'dashed';
}
