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
import { cornerLayout } from '../../bake/cornerLayout.js';
import { hatchNormal } from '../../bake/hatchNormal.js';
import { identityOf } from '../../geometry/identityOf.js';
import { pulledVerticesOf } from '../../geometry/PulledVertices.js';
import { isStale } from '../../geometry/staleGeometry.js';
import type { VertexLayout } from '../shaders/shaderConventions.js';
import { compileDeformation, deformationOf } from './deformationOf.js';

/** Identities of geometries whose problem was reported. */
const warnedGeometries = new WeakSet<object>();
const warnedStale = new WeakSet<object>();

/** Reports a problem of a geometry, once per geometry. */
function warnOnce(geometry: BufferGeometry, problem: string): void {
  const identity = identityOf(geometry);
  if (warnedGeometries.has(identity)) return;
  warnedGeometries.add(identity);
  console.error(`HatchingMaterial: geometry "${geometry.name || geometry.uuid}" ${problem}`);
}

/**
 * Sets the uniforms of a material that is about to draw `object`: the vertex textures of the layout `pull`, as deformed in
 * the present pose. Returns the layout in which the vertex shader finds the adjacency. Reports problems of a geometry once.
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
      warnOnce(geometry, describeLack(geometry));
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
  bind(material, 'pullRowShift', vertices.rowShift);
  if (!isDeforming || !canDeform(renderer, geometry, object)) return 'pull';

  const deformation = deformationOf(renderer, camera, object as Mesh, geometry, vertices, material);
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
  compileDeformation(renderer, mesh, geometry, vertices);
}

/** The layout in which a material will find the vertices of a mesh, if the device can draw it. */
export function vertexLayoutOf(geometry: BufferGeometry, object: Object3D): VertexLayout {
  if (!pulledVerticesOf(geometry)) return 'corner';
  return deforms(geometry, object) ? 'deforming' : 'pull';
}

/** What is missing from a geometry without adjacency, and what to do. */
function describeLack({ attributes, userData }: BufferGeometry): string {
  if (attributes[hatchNormal.name] === undefined) {
    return "has no triangle adjacency and cannot be hatched; draw the result of await prepareHatchingGeometry(geometry, { adjacency: true }) instead, or use the technique 'anchored'.";
  }
  const history =
    userData.hatching?.layout === 'indexed'
      ? 'was prepared without triangle adjacency.'
      : "has lost its triangle adjacency: that of the layout 'pull' is not kept when geometries are merged, exported or serialised.";
  return `${history} Prepare it with { adjacency: true }, or use the technique 'anchored'.`;
}

/** Warns, once per geometry, if it has been changed since the bake. */
export function warnIfStale(geometry: BufferGeometry): void {
  if (!isStale(geometry) || warnedStale.has(identityOf(geometry))) return;
  warnedStale.add(identityOf(geometry));
  const remedy =
    geometry.userData.hatching.layout === 'indexed'
      ? "A shift of all by the same vector does no harm. Otherwise prepare it again, or call geometry.deleteAttribute('hatchNormal') to draw it with its own normals."
      : 'Move the mesh instead of the geometry, or change the geometry before prepareHatchingGeometry.';
  console.warn(
    `HatchingMaterial: the positions of geometry "${geometry.name || geometry.uuid}" have changed since it was prepared; its neighbours and stroke normals have not. ${remedy}`,
  );
}

/** Whether a skin or morph targets can move the vertices away from the rest pose. */
export const deforms = ({ morphAttributes }: BufferGeometry, object: Object3D): boolean =>
  'isSkinnedMesh' in object || morphAttributes.position !== undefined || morphAttributes.normal !== undefined;

export function canDeform(renderer: WebGLRenderer, geometry: BufferGeometry, object: Object3D): boolean {
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
function bind(material: ShaderMaterial, name: string, value: Texture | number): void {
  const uniform = material.uniforms[name];
  if (uniform.value === value) return;
  uniform.value = value;
  material.uniformsNeedUpdate = true;
}
