import { type ApplyHatchingOptions, type HatchingMaterialParameters, type PresetName, presets } from 'three-hatching';
import { type ExampleHandName, exampleHand } from 'three-hatching/hands';

/** A preset, a hand whose strokes the preset `pen` draws, or what `applyHatching` makes where neither is named. */
export type LookName = PresetName | 'default' | `hand ${ExampleHandName}`;

/** A broad hand, one in bundles, and one of many fine strokes. */
const HANDS = ['hand brush', 'hand reedPen', 'hand finePen'] as const;

/** The parameters of a material for a look. */
export function materialOptions(look: LookName): HatchingMaterialParameters {
  if (look === 'default') return {};
  const [, hand] = look.split(' ');
  return hand ? { preset: 'pen', hand: exampleHand(hand as ExampleHandName) } : { preset: look as PresetName };
}

/** The options of `applyHatching` for a look. */
export function lookOptions(look: LookName): ApplyHatchingOptions {
  const { preset, ...material } = materialOptions(look);
  return { ...(preset && { preset }), material };
}

/** All looks that users meet without options of their own, and strokes of hands. */
export const lookNames = (): LookName[] => ['default', ...(Object.keys(presets) as PresetName[]), ...HANDS];
