import { checkNumber } from '../checkNumber.js';
import { kindOf } from '../diagnostics/assertGeometry.js';
import { HATCHING_OUTLINE_DEFAULTS, OUTLINE_WEIGHT_NAMES } from './outlineProperties.js';

/** How heavy outlines are, each 0 or more: a line of weight 1 is `outlineWidth` wide, and one of weight 0 is not drawn. */
export class OutlineWeights {
  /** Contours, along which the surface turns away from the eye. Default 1. */
  declare contours: number;
  /**
   * Contours and borders with a surface behind them, as a share of their weight in front of the paper. A surface more than half the
   * height of the view behind them counts as paper. 1 draws all alike. Default 0.5.
   */
  declare innerContours: number;
  /** Borders, where the surface ends. Default 1. */
  declare borders: number;
  /** Creases, sharp edges with both sides visible. Default 0.35. */
  declare creases: number;
  /** Edges between groups of a geometry, on meshes with several materials. Default 0.35. */
  declare materialBorders: number;
  /** Lines along which the surfaces of two parts cut each other, if `intersections` is true. Default 0.35. */
  declare intersections: number;
  /**
   * Suggestive contours, where a contour would appear if the eye moved a little (DeCarlo et al., 2003). Every triangle is tested for
   * them. Default 0; try 0.6.
   */
  declare suggestiveContours: number;
  /** A factor on the lit side, under all lights of the scene. Default 0.7. */
  declare lit: number;
  /** A factor in the shade. Default 1.7. */
  declare shade: number;

  /** @param owner the name of the material's class */
  // React Three Fiber resets a removed attribute to its default only if the constructor's `length` is 0.
  constructor(owner: string | undefined = undefined) {
    for (const name of OUTLINE_WEIGHT_NAMES) {
      let current: number = HATCHING_OUTLINE_DEFAULTS.weights[name];
      Object.defineProperty(this, name, {
        get: () => current,
        set: (value: number) => {
          current = checkWeight(name, value, owner);
        },
        enumerable: true,
      });
    }
    Object.preventExtensions(this);
  }
}

const checkWeight = (name: string, value: unknown, owner: string | undefined): number =>
  checkNumber(name, value, { from: 0 }, `${owner}.weights`);

/**
 * Sets the weights that are given and not undefined, or none of them.
 *
 * @param owner the name of the material's class
 * @throws TypeError unless `values` is an object with names of weights; RangeError if one is below 0
 */
export function setWeights(weights: OutlineWeights, values: Partial<OutlineWeights>, owner: string): void {
  if (typeof values !== 'object' || values === null) {
    throw new TypeError(`${owner}.weights: expected an object such as { creases: 0.5 }, not ${kindOf(values)}.`);
  }
  const given = Object.entries(values).filter(([, value]) => value !== undefined);
  for (const [name, value] of given) {
    if (!(name in HATCHING_OUTLINE_DEFAULTS.weights)) {
      throw new TypeError(`${owner}.weights.${name} is none of ${OUTLINE_WEIGHT_NAMES.join(', ')}.`);
    }
    checkWeight(name, value, owner);
  }
  Object.assign(weights, Object.fromEntries(given));
}
