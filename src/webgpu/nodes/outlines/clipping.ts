/**
 * Clips outlines where three's ClippingGroup clips surfaces: each piece by its spine, as shaders/outlines/surroundings.glsl has it. three's own
 * node asks where the triangle lies that covers the piece.
 */
import type { Vector4 } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { spinePosition } from './fragments.js';

const { Discard, dot, vec4 } = tsl;
const { cameraWorldMatrix, renderGroup, uniformArray } = threeNodes;

const planesOf = uniformArray as unknown as (planes: Vector4[]) => { setGroup(group: object): Value };

interface WithClipping {
  /** The planes of the groups that an object lies in, in view space; three's declaration leaves it out. */
  readonly clippingContext: { readonly unionPlanes: Vector4[]; readonly intersectionPlanes: Vector4[] } | null;
}

/** Whether a place lies beyond each plane. */
function beyond(place: Value, planes: Vector4[]): Value[] {
  const all = planesOf(planes).setGroup(renderGroup);
  return planes.map((_, i) => {
    const plane = all.element(i);
    return dot(place, plane.xyz).greaterThan(plane.w);
  });
}

/** Discards what is clipped of a fragment. To be called where its place on the spine is known. */
export function clipSpine(builder: NodeBuilder): void {
  const { camera, clippingContext } = builder as NodeBuilder & WithClipping;
  if (!clippingContext) return;
  const { unionPlanes, intersectionPlanes } = clippingContext;
  // Of several cameras the planes are in world space.
  const toWorld = cameraWorldMatrix as unknown as Value;
  const place = camera && 'isArrayCamera' in camera ? toWorld.mul(vec4(spinePosition, 1)).xyz : spinePosition;
  if (unionPlanes.length > 0) Discard(beyond(place, unionPlanes).reduce((one, other) => one.or(other)));
  if (intersectionPlanes.length > 0) Discard(beyond(place, intersectionPlanes).reduce((one, other) => one.and(other)));
}
