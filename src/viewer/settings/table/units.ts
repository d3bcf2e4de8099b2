import { MathUtils } from 'three';
import type { HatchingPropertyName } from 'three-hatching';
import { HATCHING_FACTS, type HatchingMeasure } from 'three-hatching/facts';

/** How the page shows a numeric material property. */
export interface Unit {
  name: string;
  /** Default step of its slider. */
  step: number;
  toProperty(setting: number): number;
  toSetting(property: number): number;
}

/** Rounds off the error of floating point: 55 % instead of 55.00000000000001 %. */
const rounded = (value: number): number => Number(value.toFixed(6));

const asIs = (name: string, step: number): Unit => ({
  name,
  step,
  toProperty: (setting) => setting,
  toSetting: (value) => value,
});

const PERCENT: Unit = {
  name: '%',
  step: 1,
  toProperty: (setting) => setting / 100,
  toSetting: (value) => rounded(100 * value),
};

/** Units by the measure of a property. */
export const UNITS: Readonly<Record<HatchingMeasure, Unit>> = {
  pixels: asIs('px', 0.1),
  gridPixels: asIs('px', 0.1),
  radians: {
    name: '°',
    step: 1,
    toProperty: MathUtils.degToRad,
    toSetting: (value) => rounded(MathUtils.radToDeg(value)),
  },
  tiles: asIs('tiles', 0.01),
  tileParts: asIs('/256 tile', 0.1),
  tilesPerUnit: asIs('tiles', 0.1),
  share: PERCENT,
  depths: PERCENT,
  worldUnits: asIs('radii', 0.01),
  tone: PERCENT,
  factor: asIs('', 0.1),
  count: asIs('', 1),
  exponent: asIs('', 1),
};

/** The unit of a property on the page. Properties that can be sized on the screen are shown in pixels. */
export function unitOf(property: HatchingPropertyName): Unit {
  const { measure, measureOnScreen = measure } = HATCHING_FACTS[property] ?? {};
  if (measureOnScreen === undefined) throw new Error(`unitOf: ${property} is no number.`);
  return UNITS[measureOnScreen];
}
