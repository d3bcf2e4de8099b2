import { type ApplyHatchingOptions, type PresetName, presets } from 'three-hatching';

/** A preset, or what `applyHatching` makes where none is named. */
export type LookName = PresetName | 'default';

/** The options of `applyHatching` for a look. */
export const lookOptions = (look: LookName): ApplyHatchingOptions => (look === 'default' ? {} : { preset: look });

/** All looks that users meet without options of their own. */
export const lookNames = (): LookName[] => ['default', ...(Object.keys(presets) as PresetName[])];
