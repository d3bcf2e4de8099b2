/** The twin of shaders/chunks/shadows.glsl: tells the light of a lamp from its shadow. three's nodes multiply the two, with filters of their own. */
import {
  BackSide,
  BasicShadowMap,
  type BufferGeometry,
  type DepthTexture,
  type Light,
  type LightShadow,
  type Material,
  PCFShadowMap,
  type ShadowMapType,
  type Texture,
  VSMShadowMap,
} from 'three';
import type { NodeBuilder } from 'three/webgpu';
import type { ToldLight } from '../base/ToldLight.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { bilinearCube } from '../shadowMaps/bilinearCube.js';
import { bilinearFlat } from '../shadowMaps/bilinearFlat.js';
import type { ShadowMap } from '../shadowMaps/depth.js';
import { type ShadowValues, shadowValuesFor } from '../shadowMaps/ShadowValues.js';
import { steadyCube } from '../shadowMaps/steadyCube.js';
import { steadyFlat } from '../shadowMaps/steadyFlat.js';
import { lightLuminance } from './lightLuminance.js';
import { tellSoftShadow } from './softShadows.js';

const { lightShadowMatrix } = threeNodes;
const { cameraViewMatrix, mix, normalize, normalLocal, positionWorld, transformNormalToView, varying } = tsl;
const { vec3, vec4 } = tsl;

/** A light of three's that casts shadows, as its node has it when a material is built. */
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

/** Whether anything may be told of shadows: whether any fall on the object. */
export const hasShadows = (builder: NodeBuilder, lights: readonly Light[]): boolean =>
  rendererOf(builder).shadowMap.enabled &&
  (builder.object as { receiveShadow?: boolean }).receiveShadow === true &&
  lights.some(({ castShadow }) => castShadow);

/** The map of a light as far as it is known here how three.js has drawn it; null where an application has put something else in its place. */
function mapOf(builder: NodeBuilder, { light, shadowNode }: ShadowedLight): ShadowMap | null {
  const { shadowMap, logarithmicDepthBuffer, reversedDepthBuffer } = rendererOf(builder);
  const { receivedShadowNode, receivedShadowPositionNode } = builder.material as unknown as Record<string, unknown>;
  const { filterNode } = light.shadow as { filterNode?: unknown };
  const isOfApplication = receivedShadowNode || receivedShadowPositionNode || filterNode;
  if (!shadowNode.isShadowNode || isOfApplication || shadowMap.transmitted || logarithmicDepthBuffer) return null;
  const hasMoments = shadowMap.type === VSMShadowMap && !('isPointLight' in light);
  const texture = hasMoments ? shadowNode.vsmShadowMapHorizontal?.texture : shadowNode.shadowMap?.depthTexture;
  return texture && !('isArrayTexture' in texture && texture.isArrayTexture)
    ? { texture, hasMoments, isReversed: reversedDepthBuffer }
    : null;
}

type Filter = (map: ShadowMap, coord: Value, values: ShadowValues) => Value;

/** Filters that do not crawl under strokes, for flat maps and for cubes; VSM has no noise and keeps three's own. */
const FILTERS: Readonly<Partial<Record<ShadowMapType, readonly [flat: Filter, cube: Filter]>>> = {
  [BasicShadowMap]: [bilinearFlat, bilinearCube],
  [PCFShadowMap]: [steadyFlat, steadyCube],
};

/** The normal that a place is moved along on its way to a map, as it lies between vertices, not of unit length. World space. */
const shadowNormal = /* @__PURE__ */ varying(
  vec4(normalize(transformNormalToView(normalLocal)), 0).mul(cameraViewMatrix).xyz,
);

/** The place that is looked up in a map. */
function shadowPosition({ geometry, material }: NodeBuilder, { normalBias }: ShadowValues): Value {
  if (!(geometry as BufferGeometry).hasAttribute('normal')) return positionWorld;
  const moved = shadowNormal.mul(normalBias);
  return (material as Material).side === BackSide ? positionWorld.sub(moved) : positionWorld.add(moved);
}

/** How much of a light passes its shadow map. */
function filtered(builder: NodeBuilder, lit: ShadowedLight, map: ShadowMap | null): Value {
  const { light, shadowNode } = lit;
  const filters = FILTERS[rendererOf(builder).shadowMap.type];
  // A user's shadow may have a colour.
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

/** @param dissolves whether shadows are all that is drawn, whose edges widen and whose tone dissolves */
export function tellShadow(
  builder: NodeBuilder,
  lit: ShadowedLight,
  dissolves: boolean,
): Omit<ToldLight, 'isShadowed'> {
  const { light, shadowNode } = lit;
  // three.js makes the map as it builds its own node, and draws it for all nodes that were built.
  shadowNode.build(builder);
  const map = mapOf(builder, lit);
  const own = (): Value => filtered(builder, lit, map);
  if (!dissolves || !map) return { light, shadow: own().toVar(), toneLeft: null };
  return { light, ...tellSoftShadow(light, map, own) };
}
