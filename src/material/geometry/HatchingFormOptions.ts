import type { FormRequest } from '../../mesh/bake/bakeSurface.js';
import { FORM_DEFAULTS } from '../../mesh/form/FormField.js';
import { checkNames } from '../../worker/TaskOptions.js';

/** Options of the form field, which lines follow; omitted options have their defaults. */
export interface HatchingFormOptions {
  /**
   * Whether the field is baked only for a shape that has a form, not for machine parts and other meshes of flat faces. `direction` of
   * the `HatchingStatistics` tells the result. Default: false.
   */
  auto?: boolean | undefined;
  /** The axis that lines run across where the form decides nothing, in object space, of any length. Default: [0, 1, 0]. */
  up?: readonly [x: number, y: number, z: number] | undefined;
  /**
   * The direction in object space from which the object is mostly seen, of any length. Few singular points, around which lines turn,
   * are placed on that side. Default: [0, 0, 1], or [0, −1, 0] where up is z. [0, 0, 0] means no preferred direction.
   */
  front?: readonly [x: number, y: number, z: number] | undefined;
  /**
   * The angle between lines and those that cross them, in radians, above 0 and below π. Default: π/3; `applyHatching` takes that of
   * the material.
   */
  crossAngle?: number | undefined;
  /** The scale of relief that does not turn lines, as a share of the bounding radius, above 0. Default: 0.08. */
  smoothing?: number | undefined;
  /** The distance over which directions spread to where the form has none, as a share of the bounding radius, above 0. Default: 0.3. */
  reach?: number | undefined;
}

const NAMES = { auto: true, up: true, front: true, crossAngle: true, smoothing: true, reach: true } satisfies Record<
  keyof HatchingFormOptions,
  true
>;

/**
 * The request for a form field; null if none is requested.
 *
 * @throws TypeError or RangeError that names the wrong option
 */
export function formRequest(
  caller: string,
  form: boolean | 'auto' | HatchingFormOptions | undefined,
): FormRequest | null {
  if (form === undefined || form === false) return null;
  if (form === true || form === 'auto') return { ...FORM_DEFAULTS, isChosen: form === 'auto' };
  checkNames(caller, 'options of form', form, NAMES);
  const { auto = false, up, front, crossAngle, smoothing, reach } = form;
  for (const [name, vector] of Object.entries({ up, front })) {
    if (vector === undefined || (vector.length === 3 && vector.every(Number.isFinite))) continue;
    throw new TypeError(`${caller}: form.${name} must be an array of three finite numbers, or left out.`);
  }
  checkRange(caller, 'crossAngle', crossAngle, Math.PI, 'an angle in radians between 0 and π');
  for (const [name, share] of Object.entries({ smoothing, reach }))
    checkRange(caller, name, share, Infinity, 'a share of the bounding radius above 0');
  if (typeof auto !== 'boolean') {
    throw new TypeError(`${caller}: form.auto is ${String(auto)}. Pass true or false, or leave the option out.`);
  }
  return {
    isChosen: auto,
    up: up ?? FORM_DEFAULTS.up,
    front,
    crossAngle: crossAngle ?? FORM_DEFAULTS.crossAngle,
    smoothing: smoothing ?? FORM_DEFAULTS.smoothing,
    reach: reach ?? FORM_DEFAULTS.reach,
  };
}

/** The angle between lines and those that cross them, in radians, under these options. */
export const crossAngleOf = ({ crossAngle = FORM_DEFAULTS.crossAngle }: HatchingFormOptions): number => crossAngle;

function checkRange(caller: string, name: string, value: number | undefined, below: number, wanted: string): void {
  if (value === undefined || (value > 0 && value < below)) return;
  throw new RangeError(`${caller}: form.${name} is ${value}. Pass ${wanted}, or leave the option out.`);
}
