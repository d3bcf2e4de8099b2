import type { HatchingFacts, HatchingMeasure } from './HatchingProperty.js';
import { HATCHING_FACTS } from './hatchingFacts.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from './hatchingProperties.js';
import { spelledOut } from './presetParameters.js';
import { type HatchingLook, holds, isUsedBy, propertyOf, techniqueOf, valueIn } from './queries.js';

const NAMES = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const factsOf = (name: HatchingPropertyName): HatchingFacts => HATCHING_FACTS[name] ?? {};

/** Whether a property counts for a look: its technique reads it, and so do its medium and what else it depends on. */
export function counts(given: HatchingLook, name: HatchingPropertyName): boolean {
  const look = spelledOut(given);
  if (!isUsedBy(techniqueOf(look), propertyOf(name))) return false;
  const { when = {} } = factsOf(name);
  return [when].flat().some((condition) => holds(look, condition));
}

/**
 * What a number or a vector measures in a look; undefined for other properties, and for one that is a mean of two measures, as far as
 * `sizedOnScreen` says.
 */
export function measureOf(look: HatchingLook, name: HatchingPropertyName): HatchingMeasure | undefined {
  const { measure, measureOnScreen = measure } = factsOf(name);
  const onScreen = Number(valueIn(spelledOut(look), 'sizedOnScreen'));
  if (measure === measureOnScreen || onScreen === 0) return measure;
  return onScreen === 1 ? measureOnScreen : undefined;
}

/**
 * How a property goes with the size of a picture: 1 if it is measured in CSS pixels, 0 if it is not, and for one that is as far as
 * `sizedOnScreen` says, that. In a picture twice as wide it is 2 to this power as large.
 */
export function pixelPower(look: HatchingLook, name: HatchingPropertyName): number {
  const { measure, measureOnScreen } = factsOf(name);
  if (measure === 'pixels') return 1;
  return measureOnScreen === 'pixels' ? Number(valueIn(spelledOut(look), 'sizedOnScreen')) : 0;
}

/**
 * The sizes that are numbers in a look, and measured in CSS pixels, for a larger or smaller picture that shows the same. Another pixel
 * ratio of the renderer needs none of this.
 *
 * @param factor the width of that picture, divided by that of the one that the sizes are for, both at the same pixel ratio
 */
export function scaledSizes<Look extends HatchingLook>(given: Look, factor: number): Partial<Look> {
  const look = spelledOut(given);
  const sizes: Partial<Record<HatchingPropertyName, number>> = {};
  for (const name of NAMES) {
    const value = look[name];
    const power = pixelPower(look, name);
    if (typeof value !== 'number' || power === 0) continue;
    const { range } = propertyOf(name) as { range?: { from?: number } };
    sizes[name] = Math.max(value * factor ** power, range?.from ?? 0);
  }
  return sizes as Partial<Look>;
}
