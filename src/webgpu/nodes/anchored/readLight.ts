/** Counterpart of shaders/techniques/anchored/readLight.glsl: strokes that follow the light. */
import type { Light } from 'three';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import { strokeDirection } from '../base/strokeDirection.js';
import { tsl, type Value } from '../base/values.js';
import { lightBitangent } from '../chunks/lightOrientation.js';
import type { StrokeAxes } from './StrokeAxes.js';

const { cross } = tsl;

/** @param n unit normal, object space */
export function readStrokeAxes(
  n: Value,
  lights: readonly Light[],
  viewToAnchor: Value,
  receivedShadows: readonly ReceivedShadow[],
): StrokeAxes {
  const { bitangent, crossing } = lightBitangent(n, lights, viewToAnchor, receivedShadows);
  const tangent = cross(bitangent, n).toVar();
  const { x, y } = strokeDirection;
  return {
    uAxis: tangent.mul(x).sub(bitangent.mul(y)).toVar(),
    vAxis: tangent.mul(y).add(bitangent.mul(x)).toVar(),
    crossing,
  };
}
