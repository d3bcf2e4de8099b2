import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { type HatchingPreset, type PresetName, presets } from './presets.js';

/**
 * The options of `applyHatching` for a preset, with those of yours over it: parameters of the material and of the lines one by
 * one, everything else as a whole. `lines: false` leaves the lines of the preset out, `lines: true` keeps them.
 *
 * @param preset its name, or a preset of your own
 * @throws RangeError if there is no preset of this name
 */
export function withPreset(
  preset: PresetName | HatchingPreset,
  { preset: _preset, ...options }: ApplyHatchingOptions = {},
): ApplyHatchingOptions {
  const { material, lines, tonalArtMap } = presetOf(preset);
  const { material: own = {}, lines: ownLines = true } = options;
  return {
    ...options,
    material: typeof own === 'function' ? (...args) => ({ ...material, ...own(...args) }) : { ...material, ...own },
    lines: typeof ownLines === 'object' && ownLines !== null ? { ...lines, ...ownLines } : ownLines && lines,
    // A preset without a map needs none; with another technique it may, and gets the usual one.
    tonalArtMap: options.tonalArtMap === undefined ? (tonalArtMap ?? undefined) : options.tonalArtMap,
  };
}

function presetOf(preset: PresetName | HatchingPreset): HatchingPreset {
  if (typeof preset === 'object' && preset !== null) return preset;
  if (Object.hasOwn(presets, preset)) return presets[preset];
  throw new RangeError(
    `applyHatching: there is no preset "${preset}". Use one of ${Object.keys(presets).join(', ')}, or pass a preset of your own.`,
  );
}
