import {
  type Camera,
  type IUniform,
  Matrix4,
  type Object3D,
  type Scene,
  type Texture,
  type Vector4,
  type WebGLRenderer,
} from 'three';
import { blurredEnvironment, lightsAlready } from './blurredEnvironment.js';
import { environmentLayout } from './shaders/shaderConventions.js';

const rotation = /* @__PURE__ */ new Matrix4();

/**
 * Sets the uniforms of the scene's environment, which three.js sets on its own materials only.
 *
 * @returns whether the scene has an environment that gives light
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
  // The inverse of the image's rotation, which is its transpose, turns directions into the space of the image.
  uniforms.environmentRotation.value
    .setFromMatrix4(rotation.makeRotationFromEuler(scene.environmentRotation))
    .transpose();
  if (environmentLayout() === 'atlas') {
    // The layout of three's WebGLProgram: the faces of three cubes lie side by side, each at least 112 texels wide.
    const { height } = texture.image as { height: number };
    const finest = Math.log2(height) - 2;
    uniforms.environmentAtlas.value.set(1 / (3 * Math.max(2 ** finest, 112)), 1 / height, finest);
  }
  // Blurring the environment has set the viewport to the whole target; each camera of an ArrayCamera has its own part of it.
  const { viewport } = camera as Camera & { viewport?: Vector4 };
  if (viewport) renderer.state.viewport(viewport);
  return true;
}

/** The environment of the scene that contains an object; null if there is none or it is still loading. */
export function environmentAround(object: Object3D): Texture | null {
  let root = object;
  while (root.parent) root = root.parent;
  const { environment } = root as Scene;
  return environment && lightsAlready(environment) ? environment : null;
}
