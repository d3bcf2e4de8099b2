import { depth, viewZToLogarithmicDepth, viewZToOrthographicDepth } from 'three/tsl';
import type { NodeBuilder } from 'three/webgpu';
import { tsl, type Value } from '../values.js';
import { onSpine } from './fragments.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { isOrthographic } from './sceneDepth.js';
import { vEnd, vStart } from './varyings.js';

const { cameraFar, cameraNear, float, mix, select } = tsl;

const write = { logarithmic: viewZToLogarithmicDepth, orthographic: viewZToOrthographicDepth } as unknown as Record<
  'logarithmic' | 'orthographic',
  (z: Value, near: Value, far: Value) => Value
>;

/** Writes the depth of a fragment where it is logarithmic: otherwise that of the triangle is right. */
export function writeSpineDepth(defines: OutlineDefines, { renderer }: NodeBuilder): void {
  if (!renderer.logarithmicDepthBuffer) return;
  const { t } = onSpine(defines);
  const away = mix(float(1).div(vStart.w), float(1).div(vEnd.w), t);
  const z = select(isOrthographic(), mix(vStart.w, vEnd.w, t), float(1).div(away))
    .negate()
    .toVar();
  const written = select(
    isOrthographic(),
    write.orthographic(z, cameraNear, cameraFar),
    write.logarithmic(z, cameraNear, cameraFar),
  );
  (depth as unknown as Value).assign(written);
}
