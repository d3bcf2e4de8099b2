import { type PresetName, presets } from '../../scene/presets.js';

/** The presets of the library, in its order. */
export const PRESET_NAMES = Object.keys(presets) as PresetName[];

/** `crossHatching` as `Cross-hatching`. */
const labelOf = (name: string): string =>
  `${name[0].toUpperCase()}${name.slice(1).replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** The presets, as the pages name them. */
export const PRESET_LABELS = Object.fromEntries(PRESET_NAMES.map((name) => [name, labelOf(name)])) as Record<
  PresetName,
  string
>;
