import type { PresetName } from 'three-hatching';

/** The presets of the library, as the pages name them. */
export const PRESET_LABELS = {
  pen: 'Pen',
  crossHatching: 'Cross-hatching',
  engraving: 'Engraving',
  technical: 'Technical',
  woodcut: 'Woodcut',
  stipple: 'Stipple',
  pencil: 'Pencil',
  charcoal: 'Charcoal',
  chalk: 'Chalk',
} as const satisfies Record<PresetName, string>;

export const PRESET_NAMES = Object.keys(PRESET_LABELS) as PresetName[];
