/**
 * Counterpart of shaders/techniques/engraved/shadowStrokes.glsl: families of lines in shadows, leaning back across the first family and
 * across those of its darks.
 */
import type { Medium } from '../../../look/hatchingProperties.js';
import type { Value } from '../base/values.js';
import type { HatchingParameters } from './Hatching.js';
import { contrasted, families } from './hatchLayer.js';

export const shadowLayer = (h: HatchingParameters, tone: Value, medium: Medium): Value =>
  contrasted(tone, families(h, null, tone, { medium, isOther: true }));
