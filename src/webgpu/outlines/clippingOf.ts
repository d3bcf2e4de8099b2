import type { Object3D } from 'three';
import type { ClippingGroup, Renderer, WebGPURenderer } from 'three/webgpu';

type Clipping = Parameters<Renderer['renderObject']>[7];

/** The planes that clip what a group holds, within those of what holds the group. */
function clippingIn(group: Object3D | null, ofScene: Clipping): Clipping {
  if (!group || !ofScene) return ofScene;
  const outer = clippingIn(group.parent, ofScene);
  const isClipping = 'isClippingGroup' in group && (group as ClippingGroup).enabled;
  return outer && isClipping ? outer.getGroupContext(group as ClippingGroup) : outer;
}

/** What clips an object in the frame that is being drawn: three.js tells nobody who draws an object once more. */
export function clippingOf(object: Object3D, renderer: WebGPURenderer): Clipping {
  // The name is three's own, and no part of its documented interface. Without it nothing is clipped.
  const { _currentRenderContext: frame } = renderer as unknown as {
    _currentRenderContext?: { clippingContext: Clipping };
  };
  return clippingIn(object.parent, frame?.clippingContext ?? null);
}
