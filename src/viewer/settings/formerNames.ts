import type { SettingKey } from './settings.js';

/** What older links and looks call settings that have another name now. */
const FORMER_KEYS: Partial<Record<SettingKey, string>> = {
  sizedOnScreen: 'screenConstancy',
  tilesPerUnit: 'strokeScale',
  highlightTone: 'keepHighlight',
  blendAngle: 'creaseAngle',
  outlines: 'lines',
  outlineWidth: 'lineWidth',
  outlineContours: 'lineContours',
  outlineBorders: 'lineBorders',
  outlineCreases: 'lineCreases',
  outlineSuggestive: 'lineSuggestive',
  outlineShade: 'lineShade',
  outlineHand: 'lineHand',
};

/** What they call values, and what those are called now. */
const FORMER_VALUES: Partial<Record<SettingKey, Record<string, string>>> = {
  strokeLayers: { 1: 'single', 2: 'lights' },
};

/**
 * The value of a setting as it is called now, from what was stored under this name or an older one; undefined if nothing was.
 *
 * @param stored returns what was stored under a name
 */
export function storedValue<Value>(
  key: SettingKey,
  stored: (name: string) => Value | undefined,
): Value | string | undefined {
  // A woodcut was a switch of its own.
  if (key === 'medium' && stored('carved') === 'yes') return 'woodcut';
  const value = stored(key) ?? stored(FORMER_KEYS[key] ?? key);
  return FORMER_VALUES[key]?.[String(value)] ?? value;
}
