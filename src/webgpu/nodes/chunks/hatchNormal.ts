/** Counterpart of shaders/chunks/hatchNormal.glsl. */
import type { BufferGeometry } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { tsl, type Value } from '../base/values.js';

const { attribute, dot, normalGeometry, select, vec4 } = tsl;

/**
 * xyz: the normal smoothed to the scale of a stroke, zero if the geometry has none. w: minus the baked occlusion, 1 if the geometry has no
 * such attribute.
 */
export const hatchNormal = ({ geometry }: NodeBuilder): Value =>
  (geometry as BufferGeometry).hasAttribute('hatchNormal') ? attribute('hatchNormal', 'vec4') : vec4(0, 0, 0, 1);

/** The smoothed normal, or the geometry's own where it was not prepared. */
export function strokeNormalOf(builder: NodeBuilder): Value {
  const smoothed = hatchNormal(builder).xyz.toVar();
  return select(dot(smoothed, smoothed).greaterThan(0.25), smoothed, normalGeometry);
}
