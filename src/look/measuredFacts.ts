import type { HatchingFacts, HatchingMeasure } from './HatchingProperty.js';
import { HATCHING_FACTS } from './hatchingFacts.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type PropertyNameOf } from './hatchingProperties.js';
import { spelledOut } from './presetParameters.js';
import { type HatchingLook, hasOwner, holds, isUsedBy, propertyOf, techniqueOf, valueIn } from './queries.js';

const NAMES = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const factsOf = (name: HatchingPropertyName): HatchingFacts => HATCHING_FACTS[name] ?? {};

/** Whether a property has an effect in a look: its technique reads it, and the properties it depends on allow it. */
export function counts(given: HatchingLook, name: HatchingPropertyName): boolean {
  const look = spelledOut(given);
  if (!hasOwner(look, propertyOf(name)) || !isUsedBy(techniqueOf(look), propertyOf(name))) return false;
  const { when = {} } = factsOf(name);
  return [when].flat().some((condition) => holds(look, condition));
}

/** The measure of a number or a vector in a look. Undefined for other properties, and where `screenSpaceShare` mixes two measures. */
export function measureOf(look: HatchingLook, name: HatchingPropertyName): HatchingMeasure | undefined {
  const { measure, measureOnScreen = measure } = factsOf(name);
  const onScreen = Number(valueIn(spelledOut(look), 'screenSpaceShare'));
  if (measure === measureOnScreen || onScreen === 0) return measure;
  return onScreen === 1 ? measureOnScreen : undefined;
}

/**
 * The exponent by which a property scales with the width of the picture: 1 if it is measured in CSS pixels, 0 if it is not, and
 * `screenSpaceShare` where that mixes both.
 */
export function pixelPower(look: HatchingLook, name: HatchingPropertyName): number {
  const { measure, measureOnScreen } = factsOf(name);
  if (measure === 'pixels') return 1;
  return measureOnScreen === 'pixels' ? Number(valueIn(spelledOut(look), 'screenSpaceShare')) : 0;
}

/**
 * The sizes of a look that are measured in CSS pixels, scaled for a larger or smaller picture of the same scene. A different pixel ratio of
 * the renderer needs no scaling.
 *
 * @param factor the width of that picture divided by the width that the sizes are meant for, at the same pixel ratio
 */
export function scaledSizes<Look extends HatchingLook>(given: Look, factor: number): Partial<Look> {
  const look = spelledOut(given);
  const sizes: Partial<Record<HatchingPropertyName, number>> = {};
  for (const name of NAMES) {
    if (propertyOf(name).owner !== undefined) continue;
    const value = look[name as PropertyNameOf<undefined>];
    const power = pixelPower(look, name);
    if (typeof value !== 'number' || power === 0) continue;
    const { range } = propertyOf(name) as { range?: { from?: number } };
    sizes[name] = Math.max(value * factor ** power, range?.from ?? 0);
  }
  return sizes as Partial<Look>;
}
