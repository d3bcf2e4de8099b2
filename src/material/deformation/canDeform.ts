import type { BufferGeometry, InstancedMesh, Object3D, WebGLRenderer } from 'three';

/** Whether a skin or morph targets can move vertices away from the rest pose. */
export const deforms = ({ morphAttributes }: BufferGeometry, object: Object3D): boolean =>
  'isSkinnedMesh' in object || morphAttributes.position !== undefined || morphAttributes.normal !== undefined;

/** Whether the device can draw into float textures, the render targets of the pre-pass. */
export const hasFloatTargets = ({ extensions }: WebGLRenderer): boolean => extensions.has('EXT_color_buffer_float');

/** Whether each instance has morph targets of its own, which the pre-pass does not support. */
export const morphsEachInstance = (object: Object3D): boolean =>
  'isInstancedMesh' in object && (object as InstancedMesh).morphTexture !== null;

/** Whether the pre-pass can deform the vertices of an object; otherwise its mesh is hatched in the rest pose. */
export const canDeform = (renderer: WebGLRenderer, object: Object3D): boolean =>
  hasFloatTargets(renderer) && !morphsEachInstance(object);
