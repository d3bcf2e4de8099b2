import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { type HatchingPreset, type PresetName, presets } from './presets.js';

/**
 * The options of `applyHatching` for a preset, overridden by your own options. Parameters of the material and of the outlines override
 * those of the preset one by one, all other options as a whole. `outlines: false` leaves out the outlines of the preset, `outlines:
 * true` keeps them.
 *
 * @param preset the name of a preset, or a preset of your own
 * @throws RangeError if there is no preset of this name
 */
export function withPreset(
  preset: PresetName | HatchingPreset,
  { preset: _preset, ...options }: ApplyHatchingOptions = {},
): ApplyHatchingOptions {
  const { material, outlines, tonalArtMap } = presetOf(preset);
  const { material: own = {}, outlines: ownOutlines = true } = options;
  const namesMap = typeof own === 'object' && own?.tonalArtMap !== undefined;
  // A preset with `tonalArtMap: null` needs no map. If your options change its technique to one that does, it gets the default map.
  const ofPreset = tonalArtMap ?? undefined;
  return {
    ...options,
    material: typeof own === 'function' ? (...args) => ({ ...material, ...own(...args) }) : { ...material, ...own },
    outlines:
      typeof ownOutlines === 'object' && ownOutlines !== null
        ? { ...outlines, ...ownOutlines }
        : ownOutlines && outlines,
    tonalArtMap: options.tonalArtMap === undefined && !namesMap ? ofPreset : options.tonalArtMap,
  };
}

function presetOf(preset: PresetName | HatchingPreset): HatchingPreset {
  if (typeof preset === 'object' && preset !== null) return preset;
  if (Object.hasOwn(presets, preset)) return presets[preset];
  throw new RangeError(
    `applyHatching: there is no preset "${preset}". Use one of ${Object.keys(presets).join(', ')}, or pass a preset of your own.`,
  );
}
