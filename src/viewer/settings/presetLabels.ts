import { type PresetName, presets } from '../../scene/presets.js';

/** Names of the library's presets, in its order. */
export const PRESET_NAMES = Object.keys(presets) as PresetName[];

/** Turns `crossHatching` into `Cross-hatching`. */
const labelOf = (name: string): string =>
  `${name[0].toUpperCase()}${name.slice(1).replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** Labels of the presets by name. */
export const PRESET_LABELS = Object.fromEntries(PRESET_NAMES.map((name) => [name, labelOf(name)])) as Record<
  PresetName,
  string
>;
