import type { BufferGeometry, Camera, Mesh, Object3D, ShaderMaterial, Texture, WebGLRenderer } from 'three';
import type { VertexLayout } from '../deformation/canDeform.js';
import { canDeform, deforms } from '../deformation/canDeform.js';
import { glslDeformations } from '../deformation/PrePass.js';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/**
 * Sets the uniforms of a material that is about to draw `object`: the vertex textures of the layout `pull`, as deformed in
 * the present pose. Returns the layout in which the vertex shader finds the adjacency.
 */
function bindVertices(
  renderer: WebGLRenderer,
  camera: Camera,
  geometry: BufferGeometry,
  object: Object3D,
  material: ShaderMaterial,
): VertexLayout {
  const vertices = pulledVerticesOf(geometry);
  if (!vertices) return 'corner';
  bind(material, 'triangleVertices', vertices.triangleVertices);
  bind(material, 'restPositions', vertices.positions);
  bind(material, 'pullRowShift', vertices.rowShift);
  if (!deforms(geometry, object) || !canDeform(renderer, object)) return 'pull';

  const deformation = glslDeformations.of(renderer, camera, object as Mesh, geometry, vertices, material);
  bind(material, 'deformedPositions', deformation.positions);
  bind(material, 'deformedNormals', deformation.normals);
  bind(material, 'deformedTurns', deformation.turns);
  return 'deforming';
}

/** Builds the pre-pass program that a mesh will need, if any. */
function compilePrePass(renderer: WebGLRenderer, mesh: Mesh): void {
  const { geometry } = mesh;
  const vertices = pulledVerticesOf(geometry);
  if (!vertices || !deforms(geometry, mesh) || !canDeform(renderer, mesh)) return;
  glslDeformations.compile(renderer, mesh, geometry, vertices);
}

/**
 * Sets a uniform that differs between meshes, and has it uploaded: by default three.js uploads uniforms once for all meshes of a
 * material.
 */
function bind(material: ShaderMaterial, name: string, value: Texture | number): void {
  const uniform = material.uniforms[name];
  if (uniform.value === value) return;
  uniform.value = value;
  material.uniformsNeedUpdate = true;
}

/** The techniques whose strokes lie in triangles: `triangle` and `adjacency`. */
export const part: MaterialPart = {
  surface,
  files: import.meta.glob(['./techniques/{triangle,adjacency}/*', './perTriangle/*'], {
    base: '../../../shaders',
    query: '?raw',
    import: 'default',
    eager: true,
  }),
  bindMesh: bindVertices,
  compile: compilePrePass,
};
