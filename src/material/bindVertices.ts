import type {
  BufferGeometry,
  Camera,
  InstancedMesh,
  Mesh,
  Object3D,
  ShaderMaterial,
  Texture,
  WebGLRenderer,
} from 'three';
import { cornerLayout } from '../bake/cornerLayout.js';
import { identityOf } from '../geometry/identityOf.js';
import { pulledVerticesOf } from '../geometry/PulledVertices.js';
import { deformationOf } from './deformationOf.js';
import type { VertexLayout } from './shaderConventions.js';

/** Identities of geometries. */
const warnedGeometries = new WeakSet<object>();

/** Reports a problem of a geometry, once per geometry. */
function warnOnce(geometry: BufferGeometry, problem: string): void {
  const identity = identityOf(geometry);
  if (warnedGeometries.has(identity)) return;
  warnedGeometries.add(identity);
  console.error(`HatchingMaterial: geometry "${geometry.name || geometry.uuid}" ${problem}`);
}

/**
 * Sets the uniforms of a material that is about to draw `object`: the vertex textures of the layout `pull`, deformed to the
 * present pose. Returns the layout in which the vertex shader finds the adjacency. Reports problems of a geometry once.
 */
export function bindVertices(
  renderer: WebGLRenderer,
  camera: Camera,
  geometry: BufferGeometry,
  object: Object3D,
  material: ShaderMaterial,
): VertexLayout {
  const vertices = pulledVerticesOf(geometry);
  const isDeforming = deforms(geometry, object);
  if (!vertices) {
    if (geometry.attributes[cornerLayout[0].name] === undefined) {
      warnOnce(
        geometry,
        'has no triangle adjacency and cannot be hatched; draw the result of await prepareHatchingGeometry(geometry) instead.',
      );
    } else if (isDeforming) {
      warnOnce(
        geometry,
        "is lit and hatched as at rest: its layout 'corner' knows no other pose. Prepare it with the layout 'pull' or 'auto'.",
      );
    }
    return 'corner';
  }
  bind(material, 'triangleVertices', vertices.triangleVertices);
  bind(material, 'restPositions', vertices.positions);
  if (!isDeforming || !canDeform(renderer, geometry, object)) return 'pull';

  const deformation = deformationOf(renderer, object as Mesh, geometry, vertices);
  deformation.update(camera, object as Mesh, material);
  bind(material, 'deformedPositions', deformation.positions);
  bind(material, 'deformedNormals', deformation.normals);
  bind(material, 'deformedTurns', deformation.turns);
  return 'deforming';
}

/** Builds the program of the pre-pass that a mesh will need, if any. */
export function compilePrePass(renderer: WebGLRenderer, mesh: Mesh): void {
  const { geometry } = mesh;
  const vertices = pulledVerticesOf(geometry);
  if (!vertices || !deforms(geometry, mesh) || !canDeform(renderer, geometry, mesh)) return;
  deformationOf(renderer, mesh, geometry, vertices).compile(mesh);
}

/** The layout in which a material will find the vertices of a mesh, if the device can draw it. */
export function vertexLayoutOf(geometry: BufferGeometry, object: Object3D): VertexLayout {
  if (!pulledVerticesOf(geometry)) return 'corner';
  return deforms(geometry, object) ? 'deforming' : 'pull';
}

/** Whether a skin or morph targets can move the vertices away from the rest pose. */
export const deforms = ({ morphAttributes }: BufferGeometry, object: Object3D): boolean =>
  'isSkinnedMesh' in object || morphAttributes.position !== undefined || morphAttributes.normal !== undefined;

function canDeform(renderer: WebGLRenderer, geometry: BufferGeometry, object: Object3D): boolean {
  if (!renderer.extensions.has('EXT_color_buffer_float')) {
    warnOnce(
      geometry,
      "is lit and hatched as at rest: this device cannot draw into float textures (EXT_color_buffer_float). Use the technique 'anchored', which has no need to.",
    );
    return false;
  }
  if ('isInstancedMesh' in object && (object as InstancedMesh).morphTexture !== null) {
    warnOnce(
      geometry,
      "is lit and hatched as at rest: the instances of an InstancedMesh cannot have morph targets each of their own. Use the technique 'anchored', or meshes.",
    );
    return false;
  }
  return true;
}

/** Sets a uniform that differs between meshes. By default three.js uploads uniforms once for all meshes of a material. */
function bind(material: ShaderMaterial, name: string, texture: Texture): void {
  const uniform = material.uniforms[name];
  if (uniform.value === texture) return;
  uniform.value = texture;
  material.uniformsNeedUpdate = true;
}
