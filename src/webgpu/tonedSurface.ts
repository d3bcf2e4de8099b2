import { LinearFilter, type Material, NearestFilter, type Texture } from 'three';
import type { NodeBuilder, NodeMaterial } from 'three/webgpu';
import { type TextureValue, threeNodes, tsl, type Value } from './nodes/base/values.js';
import { tonedColor } from './nodes/chunks/tone.js';

const { diffuseColor, varyingProperty } = tsl;
const { materialReference, texture, vertexColor } = threeNodes;

type Mapped = Material & { map?: Texture | null };

/** A node of its own for the map of the material that is being drawn. @param map the map with which the shader is built */
const mapNode = (map: Texture): TextureValue =>
  texture(map).onObjectUpdate(({ material }) => (material as Mapped | null)?.map ?? map) as unknown as TextureValue;

/** Whether coarser levels of a texture are read: no other filter has any, and three.js' nodes have no sampler for a texture that is not filtered. */
const hasLevels = ({ minFilter }: Texture): boolean => minFilter !== NearestFilter && minFilter !== LinearFilter;

/** The colour of a surface that becomes tone. It is asked for in the fragment stage, once the colour of the material is known. */
export function tonedSurface({ material, geometry, object }: NodeBuilder): Value {
  const seen = diffuseColor.xyz;
  const { colorNode, map, vertexColors } = material as NodeMaterial & Mapped;
  const isMorphed = vertexColors && geometry!.morphAttributes.color !== undefined;
  if (!map || !hasLevels(map) || colorNode || isMorphed || 'isVideoTexture' in map) return seen;
  const { instanceColor, _colorsTexture } = object as { instanceColor?: unknown; _colorsTexture?: unknown };
  const factors = [
    materialReference('color', 'color') as unknown as Value,
    vertexColors && geometry!.hasAttribute('color') && (vertexColor() as unknown as Value).xyz,
    instanceColor && varyingProperty('vec3', 'vInstanceColor'),
    _colorsTexture && (varyingProperty('vec4', 'vBatchColor') as Value).xyz,
  ].filter((factor) => !!factor) as Value[];
  return tonedColor(
    factors.reduce((product, factor) => product.mul(factor)),
    seen,
    mapNode(map),
  );
}
