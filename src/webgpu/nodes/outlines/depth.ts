import { isOrthographic } from '../base/isOrthographic.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { onSpine } from './fragments.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { vEnd, vStart } from './varyings.js';

const { Fn, cameraFar, cameraNear, float, mix, select } = tsl;

const { viewZToLogarithmicDepth, viewZToOrthographicDepth } = threeNodes;

const depthOf = { logarithmic: viewZToLogarithmicDepth, orthographic: viewZToOrthographicDepth } as unknown as Record<
  'logarithmic' | 'orthographic',
  (z: Value, near: Value, far: Value) => Value
>;

/** The depth of a fragment for a logarithmic depth buffer; otherwise that of the triangle is right. */
export const logarithmicDepth = (defines: OutlineDefines): Value =>
  Fn(() => {
    const { t } = onSpine(defines);
    const share = mix(float(1).div(vStart.w), float(1).div(vEnd.w), t);
    const z = select(isOrthographic(), mix(vStart.w, vEnd.w, t), float(1).div(share))
      .negate()
      .toVar();
    return select(
      isOrthographic(),
      depthOf.orthographic(z, cameraNear, cameraFar),
      depthOf.logarithmic(z, cameraNear, cameraFar),
    );
  })();
