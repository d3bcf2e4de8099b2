import type { BufferGeometry, InstancedMesh, Object3D, WebGLRenderer } from 'three';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';

export const VERTEX_LAYOUTS = ['corner', 'pull', 'deforming'] as const;
/** Where a vertex reads its adjacency primitive: in its attributes, in textures, or in textures that a pre-pass writes. */
export type VertexLayout = (typeof VERTEX_LAYOUTS)[number];

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

/** The layout in which a material will read the vertices of a mesh, if the device can draw it. */
export function vertexLayoutOf(geometry: BufferGeometry, object: Object3D): VertexLayout {
  if (!pulledVerticesOf(geometry)) return 'corner';
  return deforms(geometry, object) ? 'deforming' : 'pull';
}
