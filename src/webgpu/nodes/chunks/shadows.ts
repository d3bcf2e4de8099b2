/**
 * Counterpart of shaders/chunks/shadows.glsl: separates a light from its shadow. three.js' nodes multiply the two, and filter shadows
 * otherwise.
 */
import {
  BackSide,
  BasicShadowMap,
  type BufferGeometry,
  type DepthTexture,
  DoubleSide,
  type Light,
  type LightShadow,
  type Material,
  PCFShadowMap,
  type ShadowMapType,
  type Texture,
  VSMShadowMap,
} from 'three';
import type { NodeBuilder } from 'three/webgpu';
import type { ReceivedShadow } from '../base/lights.js';
import { lightLuminance } from '../base/maths.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import type { ShadowMap } from './shadowFilters.js';
import {
  bilinearCube,
  bilinearFlat,
  lookupIn,
  type ShadowValues,
  shadowValuesFor,
  steadyCube,
  steadyFlat,
} from './shadowFilters.js';
import { readSoftShadow } from './softShadows.js';

const { lightShadowMatrix } = threeNodes;
const { cameraViewMatrix, frontFacing, mix, normalize, normalLocal, positionWorld, select } = tsl;
const { transformNormalToView, varying, vec3, vec4 } = tsl;

/** A three.js light that casts shadows, with its shadow node. */
export interface ShadowedLight {
  light: Light & { shadow: LightShadow };
  baseColorNode: Value;
  shadowNode: ShadowNodeLike;
}

interface ShadowNodeLike {
  isShadowNode?: boolean;
  shadowMap: { depthTexture: DepthTexture } | null;
  vsmShadowMapHorizontal: { texture: Texture } | null;
  build(builder: NodeBuilder): unknown;
  setupShadowCoord(builder: NodeBuilder, position: Value): Value;
  setupShadowFilter(builder: NodeBuilder, inputs: object): Value;
}

interface ShadowRenderer {
  shadowMap: { enabled: boolean; type: ShadowMapType; transmitted?: boolean };
  logarithmicDepthBuffer: boolean;
  reversedDepthBuffer: boolean;
}

const rendererOf = (builder: NodeBuilder): ShadowRenderer => builder.renderer as unknown as ShadowRenderer;

/** Whether the object receives any shadows. */
export const hasShadows = (builder: NodeBuilder, lights: readonly Light[]): boolean =>
  rendererOf(builder).shadowMap.enabled &&
  (builder.object as { receiveShadow?: boolean }).receiveShadow === true &&
  lights.some(({ castShadow }) => castShadow);

/** The shadow map of a light, if three.js rendered it in a known way; null for an application's own shadow node. */
function mapOf(builder: NodeBuilder, { light, shadowNode }: ShadowedLight): ShadowMap | null {
  const { shadowMap, logarithmicDepthBuffer, reversedDepthBuffer } = rendererOf(builder);
  const { receivedShadowNode, receivedShadowPositionNode } = builder.material as unknown as Record<string, unknown>;
  const { filterNode } = light.shadow as { filterNode?: unknown };
  const isOfApplication = receivedShadowNode || receivedShadowPositionNode || filterNode;
  if (!shadowNode.isShadowNode || isOfApplication || shadowMap.transmitted || logarithmicDepthBuffer) return null;
  const hasMoments = shadowMap.type === VSMShadowMap && !('isPointLight' in light);
  const texture = hasMoments ? shadowNode.vsmShadowMapHorizontal?.texture : shadowNode.shadowMap?.depthTexture;
  return texture && !('isArrayTexture' in texture && texture.isArrayTexture)
    ? { texture, hasMoments, isCube: 'isPointLight' in light, isReversed: reversedDepthBuffer }
    : null;
}

type Filter = (map: ShadowMap, coord: Value, values: ShadowValues) => Value;

/** Filters without noise, for flat maps and cubes. VSM has no noise and keeps three.js' filter. */
const FILTERS: Readonly<Partial<Record<ShadowMapType, readonly [flat: Filter, cube: Filter]>>> = {
  [BasicShadowMap]: [bilinearFlat, bilinearCube],
  [PCFShadowMap]: [steadyFlat, steadyCube],
};

/** The share of a light that passes its shadow map. */
function filtered(builder: NodeBuilder, lit: ShadowedLight, map: ShadowMap | null): Value {
  const { light, shadowNode } = lit;
  const filters = FILTERS[rendererOf(builder).shadowMap.type];
  // The shadow node of an application may have a colour.
  if (!map || map.hasMoments || !filters) return lightLuminance(vec3(shadowNode as unknown as Value));
  const values = shadowValuesFor(light.shadow);
  const matrix = lightShadowMatrix(light as never) as unknown as Value;
  const coord = shadowNode.setupShadowCoord(builder, matrix.mul(vec4(shadowPosition(builder, values), 1))).xyz.toVar();
  const filter = filters[Number('isPointLight' in light)];
  const passes = shadowNode.setupShadowFilter(builder, {
    filterFn: () => filter(map, coord, values),
    depthTexture: map.texture,
    shadowCoord: coord,
    shadow: light.shadow,
    depthLayer: 0,
  });
  return mix(1, passes, values.intensity);
}

/** The shadow of a light at a fragment, before it is set against its light. */
export type ShadowOfLight = Omit<ReceivedShadow, 'isShadowed' | 'sent'>;

/** @param dissolves whether shadows alone are drawn, with edges that widen and a tone that dissolves */
export function separateShadow(builder: NodeBuilder, lit: ShadowedLight, dissolves: boolean): ShadowOfLight {
  const { light, shadowNode } = lit;
  // Building its node makes three.js create the map and render it.
  shadowNode.build(builder);
  const map = mapOf(builder, lit);
  const own = (): Value => filtered(builder, lit, map);
  const lookup = map && lookupIn(map, light.shadow);
  if (!dissolves || !map) return { light, lookup, shadow: own().toVar(), toneLeft: null };
  return { light, lookup, ...readSoftShadow(light, map, own) };
}

/** Counterpart of shaders/chunks/turnShadows.glsl: where shadow maps are read, off the surface on the side that is seen. */

/** The normal along which shadow lookups are biased, interpolated, not of unit length. World space. */
const shadowNormal = /* @__PURE__ */ varying(
  vec4(normalize(transformNormalToView(normalLocal)), 0).mul(cameraViewMatrix).xyz,
);

/** The position for shadow lookups, world space. */
function shadowPosition({ geometry, material }: NodeBuilder, { normalBias }: ShadowValues): Value {
  if (!(geometry as BufferGeometry).hasAttribute('normal')) return positionWorld;
  const moved = shadowNormal.mul(normalBias);
  const { side } = material as Material;
  if (side === DoubleSide) return positionWorld.add(select(frontFacing, moved, moved.negate()));
  return side === BackSide ? positionWorld.sub(moved) : positionWorld.add(moved);
}
