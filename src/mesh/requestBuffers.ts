import type { JointFormsRequest } from './bake/bakeJointForms.js';
import type { SurfaceRequest } from './bake/bakeSurface.js';
import type { VertexWords } from './bake/vertexWords.js';
import type { DetailRequest } from './detail/simplifyHatched.js';
import type { ContourSearch } from './features/contourCandidates.js';
import type { OcclusionMesh, OcclusionScene } from './occlusion/OcclusionScene.js';

/**
 * The buffers that requests to the worker transfer. They are apart from the bakes, since pages need them without the code of the bakes.
 */

/** The buffers that a request for a bake transfers. */
export const bakeRequestBuffers = ({
  mesh,
  attributes = [],
}: SurfaceRequest & { attributes?: VertexWords[] }): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];

/** The buffers that a request for joint forms transfers. */
export const jointRequestBuffers = ({ parts }: JointFormsRequest): ArrayBuffer[] =>
  parts.flatMap(({ mesh }) => [mesh.positions.buffer, mesh.indices.buffer]);

/** The buffers of a search for contours, which are transferred to the worker and back. */
export const contourSearchBuffers = ({ search }: { search: ContourSearch }): ArrayBuffer[] => [
  search.positions.buffer,
  search.normals.buffer,
  search.primitives.buffer,
  search.sides.buffer,
  search.list.buffer,
];

/** The buffers that a bake of occlusion transfers at its start. */
export const occlusionMeshBuffers = ({ meshes }: { meshes: OcclusionMesh[] }): ArrayBuffer[] =>
  meshes.flatMap(({ positions, indices, normals }) => [
    positions.buffer,
    indices.buffer,
    ...(normals ? [normals.buffer] : []),
  ]);

/** The buffers of the state of a bake of occlusion, which are transferred in both directions. */
export const occlusionSceneBuffers = (scene: OcclusionScene): ArrayBuffer[] => [
  scene.positions.buffer,
  scene.indices.buffer,
  scene.samplePositions.buffer,
  scene.sampleNormals.buffer,
  scene.sums.buffer,
  ...scene.views.map(({ samples }) => samples.buffer),
  ...scene.sampleOf.map(({ buffer }) => buffer),
];

/** The buffers that a request for levels of detail transfers. */
export const detailRequestBuffers = ({
  positions,
  hatchNormals,
  uvs,
  colors,
  forms,
  indices,
}: DetailRequest): ArrayBuffer[] =>
  [positions, hatchNormals, uvs, colors, forms, indices].flatMap((array) => (array ? [array.buffer] : []));
