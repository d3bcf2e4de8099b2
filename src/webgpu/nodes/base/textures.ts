import type { IUniform, Material, Texture } from 'three';
import { type TextureValue, threeNodes } from './values.js';

/** A material with uniforms named as in GLSL. */
type WithUniforms = Material & { uniforms?: Record<string, IUniform> };

/**
 * A node for a texture uniform of the material that is being drawn.
 *
 * @param blank placeholder, of the format that the texture has. Each node needs its own: three.js 0.186 merges nodes that hold the same
 *   texture while a shader is built into one uniform
 */
export const hatchingTexture = (name: string, blank: Texture): TextureValue =>
  threeNodes
    .uniformTexture(blank)
    .onObjectUpdate(
      ({ material }) => (material as WithUniforms | null)?.uniforms?.[name]?.value ?? blank,
    ) as unknown as TextureValue;
