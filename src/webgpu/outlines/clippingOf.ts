import type { Object3D } from 'three';
import type { ClippingGroup, Renderer, WebGPURenderer } from 'three/webgpu';
import { clippingOfFrame } from '../../material/three/clipping.js';

type Clipping = Parameters<Renderer['renderObject']>[7];

/** The clipping planes of a group, with those of its ancestors. */
function clippingIn(group: Object3D | null, ofScene: Clipping): Clipping {
  if (!group || !ofScene) return ofScene;
  const outer = clippingIn(group.parent, ofScene);
  const isClipping = 'isClippingGroup' in group && (group as ClippingGroup).enabled;
  return outer && isClipping ? outer.getGroupContext(group as ClippingGroup) : outer;
}

/** The clipping planes of an object in the current frame: three.js does not pass them to objects that it draws once more. */
export function clippingOf(object: Object3D, renderer: WebGPURenderer): Clipping {
  return clippingIn(object.parent, clippingOfFrame<Clipping>(renderer) ?? null);
}
