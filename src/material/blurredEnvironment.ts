import {
  CubeReflectionMapping,
  CubeRefractionMapping,
  type CubeTexture,
  EquirectangularReflectionMapping,
  EquirectangularRefractionMapping,
  PMREMGenerator,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';

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
  if (!isCube(texture) && !isEquirectangular(texture)) return null;
  const { generator, blurred } = environmentsOf(renderer);
  const known = blurred.get(texture);
  const hasChanged = texture.isRenderTargetTexture && known?.texture.pmremVersion !== texture.pmremVersion;
  if (known && !hasChanged) return known.texture;
  if (!isLoaded(texture)) return null;
  const made = isCube(texture) ? generator.fromCubemap(texture, known) : generator.fromEquirectangular(texture, known);
  made.texture.pmremVersion = texture.pmremVersion;
  if (!known) {
    blurred.set(texture, made);
    disposeWith(texture, made, renderer);
  }
  return made.texture;
}

/** Whether a texture has loaded, so that `blurredEnvironment` gives light. */
export const lightsAlready = (texture: Texture): boolean =>
  isBlurred(texture) || ((isCube(texture) || isEquirectangular(texture)) && isLoaded(texture));

/** `CubeUVReflectionMapping`, a constant that three.js exports only before 0.187. */
const ATLAS_MAPPING = 306;

const isBlurred = ({ mapping, isPMREMTexture }: Texture): boolean =>
  isPMREMTexture === true || (mapping as number) === ATLAS_MAPPING;

const isCube = (texture: Texture): texture is CubeTexture =>
  texture.mapping === CubeReflectionMapping || texture.mapping === CubeRefractionMapping;

const isEquirectangular = ({ mapping }: Texture): boolean =>
  mapping === EquirectangularReflectionMapping || mapping === EquirectangularRefractionMapping;

function isLoaded(texture: Texture): boolean {
  const image: unknown = texture.image;
  if (isCube(texture)) return Array.isArray(image) && [0, 1, 2, 3, 4, 5].every((face) => image[face] !== undefined);
  return image !== null && image !== undefined && (image as { height: number }).height > 0;
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
