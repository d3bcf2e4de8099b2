/** Known in three.js 0.170 to 0.187: how it lays out and keeps blurred environments. */
import {
  type Camera,
  CubeReflectionMapping,
  CubeRefractionMapping,
  type CubeTexture,
  EquirectangularReflectionMapping,
  EquirectangularRefractionMapping,
  type IUniform,
  Matrix4,
  type Object3D,
  PMREMGenerator,
  type Scene,
  ShaderChunk,
  type Texture,
  type Vector4,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { expectChunk } from './chunks.js';

/** The layout of a blurred environment: an atlas before 0.187, a cube from 0.187 on; null if it is neither. */
export function environmentLayout(): 'atlas' | 'cube' | null {
  if ('cube_uv_reflection_fragment' in ShaderChunk) return 'atlas';
  const chunk = 'envmap_physical_pars_fragment';
  return expectChunk(chunk, ShaderChunk[chunk].includes('ENVMAP_MAX_LOD')) ? 'cube' : null;
}

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
  const layout = environmentLayout();
  const texture = scene.environment && layout ? blurredEnvironment(renderer, scene.environment) : null;
  uniforms.environment.value = texture;
  uniforms.environmentIntensity.value = scene.environmentIntensity;
  if (!texture) return false;
  // The inverse of the image's rotation, which is its transpose, turns directions into the space of the image.
  uniforms.environmentRotation.value
    .setFromMatrix4(rotation.makeRotationFromEuler(scene.environmentRotation))
    .transpose();
  if (layout === 'atlas') {
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

/** The blurred environments of one graphics context. */
interface Environments {
  generator: PMREMGenerator;
  blurred: WeakMap<Texture, ReturnType<PMREMGenerator['fromCubemap']>>;
}

/**
 * Keyed by `renderer.properties`, which three.js replaces when a lost context is restored; the textures of that context are lost with
 * it.
 */
const environments = new WeakMap<object, Environments>();

/**
 * The environment blurred by three's PMREMGenerator, which three.js runs for its own materials only. It is made on first use and freed
 * with the texture; null while the texture is loading. A texture that is blurred already is returned as it is.
 */
export function blurredEnvironment(renderer: WebGLRenderer, texture: Texture): Texture | null {
  if (isBlurred(texture)) return texture;
  if (!isCube(texture) && !SPHERES.includes(texture.mapping)) return null;
  const { generator, blurred } = environmentsOf(renderer);
  const known = blurred.get(texture);
  const hasChanged = texture.isRenderTargetTexture && known?.texture.pmremVersion !== texture.pmremVersion;
  if (known && !hasChanged) return known.texture;
  if (!canBeBlurred(texture)) return null;
  const made = isCube(texture) ? generator.fromCubemap(texture, known) : generator.fromEquirectangular(texture, known);
  made.texture.pmremVersion = texture.pmremVersion;
  if (!known) {
    blurred.set(texture, made);
    disposeWith(texture, made, renderer);
  }
  return made.texture;
}

/** Whether a texture has loaded, so that `blurredEnvironment` gives light. */
const lightsAlready = (texture: Texture): boolean => isBlurred(texture) || canBeBlurred(texture);

/** `CubeUVReflectionMapping`, a constant that three.js exports only before 0.187. */
const ATLAS_MAPPING = 306;

const isBlurred = ({ mapping, isPMREMTexture }: Texture): boolean =>
  isPMREMTexture === true || (mapping as number) === ATLAS_MAPPING;

const CUBES: readonly number[] = [CubeReflectionMapping, CubeRefractionMapping];
const SPHERES: readonly number[] = [EquirectangularReflectionMapping, EquirectangularRefractionMapping];

const isCube = (texture: Texture): texture is CubeTexture => CUBES.includes(texture.mapping);

/** Whether a texture is of a kind that can be blurred, and has loaded. */
function canBeBlurred(texture: Texture): boolean {
  const image: unknown = texture.image;
  if (isCube(texture)) return Array.isArray(image) && [0, 1, 2, 3, 4, 5].every((face) => image[face] !== undefined);
  return SPHERES.includes(texture.mapping) && ((image as { height?: number } | null)?.height ?? 0) > 0;
}

function environmentsOf(renderer: WebGLRenderer): Environments {
  let known = environments.get(renderer.properties);
  if (!known) {
    known = { generator: new PMREMGenerator(renderer), blurred: new WeakMap() };
    environments.set(renderer.properties, known);
  }
  return known;
}

function disposeWith(texture: Texture, target: WebGLRenderTarget, renderer: WebGLRenderer): void {
  const context = renderer.properties;
  const dispose = (): void => {
    texture.removeEventListener('dispose', dispose);
    environments.get(context)?.blurred.delete(texture);
    // Render targets of a lost context no longer exist.
    if (renderer.properties === context) target.dispose();
  };
  texture.addEventListener('dispose', dispose);
}
