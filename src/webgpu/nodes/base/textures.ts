import type { IUniform, Material, Texture } from 'three';
import { type TextureValue, threeNodes } from './values.js';

/** A material with uniforms named as in GLSL. */
type WithUniforms = Material & { uniforms?: Record<string, IUniform> };

/**
 * A node for a texture uniform of the material that is being drawn.
 *
 * @param blank stands in where there is none, and says what format those are of. Of its own: three.js 0.186 takes nodes that hold one
 *   texture while a shader is built for the same uniform
 */
export const hatchingTexture = (name: string, blank: Texture): TextureValue =>
  threeNodes
    .uniformTexture(blank)
    .onObjectUpdate(
      ({ material }) => (material as WithUniforms | null)?.uniforms?.[name]?.value ?? blank,
    ) as unknown as TextureValue;
