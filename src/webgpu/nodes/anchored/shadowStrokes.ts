/** Counterpart of shaders/techniques/anchored/shadowStrokes.glsl: a layer for shadows, across the strokes of the light. */
import type { Value } from '../base/values.js';
import type { HatchLayer } from './hatch.js';
import { turnedLayer } from './layers.js';
import type { HatchingParameters } from './read.js';

export const shadowLayer = (h: HatchingParameters, tone: Value, hatchLayer: HatchLayer): Value =>
  hatchLayer(turnedLayer(h, 3, [0, 1]), tone);
