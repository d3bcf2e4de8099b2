import type { BufferGeometry, Object3D } from 'three';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import type { VertexLayout } from '../shaders/shaderConventions.js';
import { deforms } from './canDeform.js';

/** The layout in which a material will read the vertices of a mesh, if the device can draw it. */
export function vertexLayoutOf(geometry: BufferGeometry, object: Object3D): VertexLayout {
  if (!pulledVerticesOf(geometry)) return 'corner';
  return deforms(geometry, object) ? 'deforming' : 'pull';
}
