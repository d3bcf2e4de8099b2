import type { BufferGeometry, InstancedMesh, Object3D, WebGLRenderer } from 'three';

/** Whether a skin or morph targets can move the vertices away from the rest pose. */
export const deforms = ({ morphAttributes }: BufferGeometry, object: Object3D): boolean =>
  'isSkinnedMesh' in object || morphAttributes.position !== undefined || morphAttributes.normal !== undefined;

/** Whether the device can draw into float textures, where the pre-pass writes the vertices in their present pose. */
export const hasFloatTargets = ({ extensions }: WebGLRenderer): boolean => extensions.has('EXT_color_buffer_float');

/** Whether instances have morph targets each of their own, which the pre-pass of their mesh does not know. */
export const morphsEachInstance = (object: Object3D): boolean =>
  'isInstancedMesh' in object && (object as InstancedMesh).morphTexture !== null;

/** Whether neighbours of vertices can be known in the present pose; otherwise a mesh is hatched as at rest. */
export const canDeform = (renderer: WebGLRenderer, object: Object3D): boolean =>
  hasFloatTargets(renderer) && !morphsEachInstance(object);
