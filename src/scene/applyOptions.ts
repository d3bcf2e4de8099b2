import { isPromise } from '../material/diagnostics/warn.js';
import {
  checkPrepareOptions,
  type PrepareHatchingGeometryOptions,
} from '../material/geometry/PrepareHatchingGeometryOptions.js';
import { checkTonalArtMap, isTonalArtMap } from '../material/propertyValues.js';
import { checkHatchImageOptions } from '../material/tam/checkHatchImageOptions.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import type { ApplyHatchingOptions, HatchingPreset } from './ApplyHatchingOptions.js';
import type { PresetName } from './presets.js';
import { withPreset } from './presets.js';

/** The names of the options that `prepareHatchingGeometry` does not have. */
const OWN_OPTIONS = {
  tonalArtMap: true,
  material: true,
  tilesPerWorldUnit: true,
  detail: true,
  filter: true,
  onGeometry: true,
  onFormProgress: true,
  invalidate: true,
  preset: true,
  shadow: true,
  renderer: true,
  camera: true,
} satisfies Record<Exclude<keyof ApplyHatchingOptions, keyof PrepareHatchingGeometryOptions>, true>;

/**
 * The options of `applyHatching`, checked, with those of their preset.
 *
 * @throws RangeError or TypeError that names the wrong option
 */
export function resolveOptions(given: ApplyHatchingOptions): ApplyHatchingOptions {
  checkPrepareOptions('applyHatching', given, OWN_OPTIONS);
  const options = given.preset === undefined ? given : withPreset(given.preset, given);
  checkOwnOptions(options);
  return options;
}

/** The keys of a preset. */
const OF_PRESET: readonly string[] = ['material', 'outlines', 'tonalArtMap'] satisfies (keyof HatchingPreset)[];

/** The options for a look, a preset or options, and for further options, which override it. */
export function lookOptions(
  look: PresetName | HatchingPreset | ApplyHatchingOptions,
  options: ApplyHatchingOptions = {},
): ApplyHatchingOptions {
  const isPreset =
    typeof look === 'string' ||
    (isObject(look) && OF_PRESET.every((key) => key in look) && Object.keys(look).length === OF_PRESET.length);
  if (isPreset) return { ...options, preset: look as PresetName | HatchingPreset };
  // Anything else that is no object is reported as wrong options.
  return isObject(look) ? { ...(look as ApplyHatchingOptions), ...options } : (look as never);
}

/** The options that are passed on to `prepareHatchingGeometry`. */
export const prepareOptions = (options: ApplyHatchingOptions): Omit<PrepareHatchingGeometryOptions, 'outlines'> =>
  Object.fromEntries(Object.entries(options).filter(([name]) => !(name in OWN_OPTIONS)));

const isFunction = (value: unknown): boolean => typeof value === 'function';
const isObject = (value: unknown): boolean => typeof value === 'object' && value !== null;

/** Options that are checked by themselves: what a value must be. */
const RULES: readonly [keyof ApplyHatchingOptions, isRight: (value: unknown) => boolean, rule: string][] = [
  ['filter', isFunction, 'a function of a mesh, or left out'],
  ['onGeometry', isFunction, 'a function of two numbers, or left out'],
  ['onFormProgress', isFunction, 'a function, or left out'],
  ['invalidate', isFunction, 'a function, or left out'],
  [
    'outlines',
    (value) => typeof value === 'boolean' || isObject(value),
    'true, false or an object with options of creases and outlines',
  ],
  [
    'material',
    (value) => isObject(value) || isFunction(value),
    'an object of parameters, or a function that returns one',
  ],
];

/** Checks the options that only `applyHatching` has; `prepareHatchingGeometry` checks those of the geometry. */
function checkOwnOptions(options: ApplyHatchingOptions): void {
  const { renderer, camera, tilesPerWorldUnit = 1, tonalArtMap = null } = options;
  for (const [name, isRight, rule] of RULES) {
    if (options[name] !== undefined && !isRight(options[name]))
      throw new TypeError(`applyHatching: ${name} must be ${rule}.`);
  }
  if ((renderer === undefined) !== (camera === undefined) || (renderer && !('isWebGLRenderer' in renderer))) {
    throw new TypeError(
      'applyHatching: renderer must be a WebGLRenderer, and camera must come with it; or leave out both, and await renderer.compileAsync(scene, camera) afterwards.',
    );
  }
  if (!(tilesPerWorldUnit > 0 && tilesPerWorldUnit < Infinity)) {
    throw new RangeError(
      `applyHatching: tilesPerWorldUnit is ${tilesPerWorldUnit}, but must be a positive number of tiles per world unit, or left out.`,
    );
  }
  if (!isToBeMade(tonalArtMap)) checkTonalArtMap(tonalArtMap);
  else if (typeof tonalArtMap === 'object') checkHatchImageOptions('applyHatching: tonalArtMap', tonalArtMap);
}

/** The option `tonalArtMap`. */
export type WantedMap = ApplyHatchingOptions['tonalArtMap'];

/** Whether the map does not exist yet: the option is a set of map options, or a function that resolves with a map. */
export const isToBeMade = (wanted: WantedMap): wanted is Exclude<WantedMap, TonalArtMap | null | undefined> =>
  typeof wanted === 'function' ||
  (typeof wanted === 'object' && wanted !== null && !isTonalArtMap(wanted) && !isPromise(wanted));
