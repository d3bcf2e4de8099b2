import type { ToneFit } from './ToneFit.js';
import type { WeightedValues } from './WeightedValues.js';

/** Quantiles of the radiance over a surface: what counts as its lights and as its darks. */
const BRIGHT = 0.9;
const DARK = 0.1;
/** The quantile of the colours' lightness that counts as white, and the least. What is nearly black does not become white. */
const WHITE = 0.9;
const LEAST_WHITE = 0.3;
/** The dark is not drawn further from the bright than by this factor, so that a faint difference does not become a rough one. */
const MOST_CONTRAST = 4;

/**
 * Fits the light that arrives on surfaces to the light that presets are made for, so that bright parts are as bright as there. Light
 * from all around leaves no darks: what is dark there is then brought down to where it would be. Darks are never lifted.
 *
 * The lightest colours, by area, are left white, so that a scene of middle greys is not all in half tone.
 *
 * @param arriving the radiance of the surfaces, by area
 * @param wanted the radiance to which it is fitted: that of a sphere in a single light of intensity π
 * @param lightness of their colours, as far as they become tone
 */
export function fitTones(arriving: WeightedValues, wanted: WeightedValues, lightness: WeightedValues): ToneFit {
  const white = lightness.isEmpty ? 1 : Math.min(1, Math.max(LEAST_WHITE, lightness.quantile(WHITE)));
  const bright = arriving.quantile(BRIGHT);
  const wantedBright = wanted.quantile(BRIGHT);
  if (!(bright > 0)) return { scale: 1, offset: 0, white };
  const plain = wantedBright / bright;
  const range = bright - arriving.quantile(DARK);
  const contrast = (wantedBright - wanted.quantile(DARK)) / (plain * range);
  if (!(contrast > 1)) return { scale: plain, offset: 0, white };
  const scale = plain * Math.min(contrast, MOST_CONTRAST);
  return { scale, offset: wantedBright - scale * bright, white };
}
