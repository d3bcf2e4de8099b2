import type { DirectionInDegrees } from './DrawingOptions.js';
import { UsageError } from './UsageError.js';
import { numberOf } from './values.js';

/** Directions by name. From the direction of the view `iso`, all three axes of the model are equally long. */
const NAMED: Readonly<Record<string, DirectionInDegrees>> = {
  front: { azimuth: 0, elevation: 0 },
  back: { azimuth: 180, elevation: 0 },
  left: { azimuth: -90, elevation: 0 },
  right: { azimuth: 90, elevation: 0 },
  top: { azimuth: 0, elevation: 90 },
  bottom: { azimuth: 0, elevation: -90 },
  iso: { azimuth: 45, elevation: (180 / Math.PI) * Math.atan(Math.SQRT1_2) },
};

const NAMES = Object.keys(NAMED);

/**
 * A direction after an option: a name, or degrees around the model and above it.
 *
 * @throws UsageError if it is neither
 */
export function directionOf(option: string, text: string | undefined): DirectionInDegrees | undefined {
  if (text === undefined) return undefined;
  const plain = text.trim().toLowerCase();
  if (NAMES.includes(plain)) return NAMED[plain];
  const [azimuth, elevation, ...rest] = plain.split(/[\s,]+/).map(numberOf);
  const isThere = rest.length === 0 && Math.abs(azimuth) <= 360 && Math.abs(elevation) <= 90;
  if (isThere) return { azimuth, elevation };
  throw new UsageError(
    `--${option} is "${text}", but must be two numbers in quotes, as "25 8": degrees around the model, from -360 to 360, and degrees above it, from -90 to 90; or ${NAMES.slice(0, -1).join(', ')} or ${NAMES.at(-1)}.`,
  );
}
