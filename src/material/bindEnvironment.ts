import { type Camera, type IUniform, Matrix4, type Scene, type Vector4, type WebGLRenderer } from 'three';
import { blurredEnvironment } from './blurredEnvironment.js';
import { environmentLayout } from './environmentLayout.js';

const rotation = /* @__PURE__ */ new Matrix4();

/**
 * Sets the uniforms of the scene's environment, which three.js hands to its own materials alone.
 *
 * @returns whether there is one to be lit by
 */
export function bindEnvironment(
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  uniforms: Record<string, IUniform>,
): boolean {
  const texture = scene.environment ? blurredEnvironment(renderer, scene.environment) : null;
  uniforms.environment.value = texture;
  uniforms.environmentIntensity.value = scene.environmentIntensity;
  if (!texture) return false;
  // Transposed, a rotation is inverted: the image turns, so directions turn back.
  uniforms.environmentRotation.value
    .setFromMatrix4(rotation.makeRotationFromEuler(scene.environmentRotation))
    .transpose();
  if (environmentLayout() === 'atlas') {
    // As three's WebGLProgram has it: three cubes' faces side by side, of 112 texels at least.
    const { height } = texture.image as { height: number };
    const finest = Math.log2(height) - 2;
    uniforms.environmentAtlas.value.set(1 / (3 * Math.max(2 ** finest, 112)), 1 / height, finest);
  }
  // What has just been blurred leaves the whole target as the viewport; the cameras of an ArrayCamera have a part each.
  const { viewport } = camera as Camera & { viewport?: Vector4 };
  if (viewport) renderer.state.viewport(viewport);
  return true;
}
