import type { DrawnMaterial } from './FirstDraw.js';

/** Whether a material is blank paper on purpose: by a tone curve that is 0 everywhere, as a surface has that only hides lines behind it. */
export const printsNothing = ({ toneCurve }: DrawnMaterial): boolean =>
  Array.isArray(toneCurve) && toneCurve.every(([, ink]: readonly number[]) => ink === 0);
