import { type Camera, type IUniform, Vector3, type WebGLRenderer } from 'three';
import { isUsedBy, propertyOf } from '../facts/lookFacts.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { SceneExtent } from './SceneExtent.js';
import { automaticDepthFade } from './seenDepths.js';

type Uniforms = Record<string, IUniform>;

/** What says how much weight the drawing has where: a HatchingMaterial. */
export type EmphasisLook = Pick<HatchingMaterialProperties, 'technique' | 'depthFade' | 'depthNear' | 'depthFar'> & {
  readonly extent: SceneExtent | null;
};

/** The uniforms of shaders/chunks/emphasis.glsl. */
export const createEmphasisUniforms = (): Uniforms => ({
  depthFading: { value: new Vector3(0, 1, 0) },
});

/**
 * Writes the uniforms of a frame. Allocates nothing.
 *
 * @param look null where nothing is said of it: then all has its full weight
 * @param camera left out before the first frame
 */
export function writeEmphasis(look: EmphasisLook | null, u: Uniforms, renderer?: WebGLRenderer, camera?: Camera): void {
  const fading = u.depthFading.value as Vector3;
  if (!look || look.depthFade === 0 || !isUsedBy(look.technique, propertyOf('depthFade'))) {
    fading.set(0, 1, 0);
    return;
  }
  const seen = renderer && camera && look.extent?.depthsFrom(renderer, camera);
  const { depthFade, depthNear, depthFar } = look;
  const strength = depthFade !== 'auto' ? depthFade : seen ? automaticDepthFade(seen, camera) : 0;
  const start = seen?.front ?? 0;
  const unit = seen ? seen.back - seen.front : 1;
  const near = start + unit * depthNear;
  // A fade without a length is an edge.
  fading.set(near, Math.max(start + unit * depthFar, near + 1e-6), strength);
}
