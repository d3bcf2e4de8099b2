import type { PropertyRow } from './PropertyRow.js';
import { CHECKING } from './rows/checking.js';
import { COLOUR } from './rows/colour.js';
import { COMPOSITION } from './rows/composition.js';
import { DRY_MEDIA } from './rows/dryMedia.js';
import { PER_TRIANGLE } from './rows/perTriangle.js';
import { SHADOW } from './rows/shadow.js';
import { STROKES } from './rows/strokes.js';
import { SURFACE } from './rows/surface.js';
import { TONE } from './rows/tone.js';

/**
 * Every property of `HatchingMaterial`, of its `composition` and `perTriangle`, and of `HatchingShadowMaterial`. `npm run properties` writes from it the fields with their documentation, what the
 * material needs to know of them at run time, and the table in docs/material.md.
 */
export const PROPERTIES = {
  ...STROKES,
  ...DRY_MEDIA,
  ...TONE,
  ...SURFACE,
  ...COLOUR,
  ...CHECKING,
  ...COMPOSITION,
  ...PER_TRIANGLE,
  ...SHADOW,
} as const satisfies Record<string, PropertyRow>;
