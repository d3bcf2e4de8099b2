/**
 * Clips outlines within a ClippingGroup by their spines, as shaders/outlines/surroundings.glsl does. three.js' own node would clip by the
 * triangle that covers the piece.
 */
import type { Vector4 } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { spinePosition } from './fragments.js';

const { Discard, dot, vec4 } = tsl;
const { cameraWorldMatrix, renderGroup, uniformArray } = threeNodes;

const planesOf = uniformArray as unknown as (planes: Vector4[]) => { setGroup(group: object): Value };

interface WithClipping {
  /** The planes of the enclosing groups, in view space; missing in three.js' declaration. */
  readonly clippingContext: { readonly unionPlanes: Vector4[]; readonly intersectionPlanes: Vector4[] } | null;
}

/** Whether a position lies beyond each plane. */
function beyond(place: Value, planes: Vector4[]): Value[] {
  const all = planesOf(planes).setGroup(renderGroup);
  return planes.map((_, i) => {
    const plane = all.element(i);
    return dot(place, plane.xyz).greaterThan(plane.w);
  });
}

/** Discards clipped fragments. To be called once the position on the spine is known. */
export function clipSpine(builder: NodeBuilder): void {
  const { camera, clippingContext } = builder as NodeBuilder & WithClipping;
  if (!clippingContext) return;
  const { unionPlanes, intersectionPlanes } = clippingContext;
  // With several cameras the planes are in world space.
  const toWorld = cameraWorldMatrix as unknown as Value;
  const place = camera && 'isArrayCamera' in camera ? toWorld.mul(vec4(spinePosition, 1)).xyz : spinePosition;
  if (unionPlanes.length > 0) Discard(beyond(place, unionPlanes).reduce((one, other) => one.or(other)));
  if (intersectionPlanes.length > 0) Discard(beyond(place, intersectionPlanes).reduce((one, other) => one.and(other)));
}
