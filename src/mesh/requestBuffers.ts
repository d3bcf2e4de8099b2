import type { JointFormsRequest } from './bake/bakeJointForms.js';
import type { SurfaceRequest } from './bake/bakeSurface.js';
import type { VertexWords } from './bake/vertexWords.js';
import type { DetailRequest } from './detail/simplifyHatched.js';
import type { ContourSearch } from './features/contourCandidates.js';
import type { OcclusionMesh, OcclusionScene } from './occlusion/OcclusionScene.js';

/**
 * The buffers of a request, which are transferred with it. This function has a file of its own because the page needs it even
 * where only the worker loads the code of the bakes.
 */
export const bakeRequestBuffers = ({
  mesh,
  attributes = [],
}: SurfaceRequest & { attributes?: VertexWords[] }): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];

/** The buffers of a request for joint forms, which are transferred with it. */
export const jointRequestBuffers = ({ parts }: JointFormsRequest): ArrayBuffer[] =>
  parts.flatMap(({ mesh }) => [mesh.positions.buffer, mesh.indices.buffer]);

/** The buffers of a search, which are transferred to the worker and back. */
export const contourSearchBuffers = ({ search }: { search: ContourSearch }): ArrayBuffer[] => [
  search.positions.buffer,
  search.normals.buffer,
  search.primitives.buffer,
  search.sides.buffer,
  search.list.buffer,
];

/** The buffers of the meshes that a bake starts with, which are transferred. */
export const occlusionMeshBuffers = ({ meshes }: { meshes: OcclusionMesh[] }): ArrayBuffer[] =>
  meshes.flatMap(({ positions, indices, normals }) => [
    positions.buffer,
    indices.buffer,
    ...(normals ? [normals.buffer] : []),
  ]);

/** The buffers of the state of a bake, which are transferred. */
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
