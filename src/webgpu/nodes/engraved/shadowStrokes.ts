/** The twin of shaders/techniques/engraved/shadowStrokes.glsl: families of a shadow, which lean the other way, across the first and across those of its darks. */
import type { Medium } from '../../../look/hatchingProperties.js';
import type { Value } from '../base/values.js';
import type { HatchingParameters } from './Hatching.js';
import { contrasted, families } from './hatchLayer.js';

export const shadowLayer = (h: HatchingParameters, tone: Value, medium: Medium): Value =>
  contrasted(tone, families(h, null, tone, { medium, isOther: true }));
