import type { Samples } from './ExposureFit.js';
import { planTones } from './planTones.js';
import { planValues } from './planValues.js';
import type { ValuePlan } from './ToneFit.js';
import type { Color } from './WeightedColors.js';

/** Plans the values of a scene: the curve from its colours to darkness, and the tones of many small parts. */
export function planScene(colors: readonly Color[], samples: Samples): ValuePlan {
  const curve = planValues(colors);
  return { ...curve, tones: planTones(curve, samples) };
}
