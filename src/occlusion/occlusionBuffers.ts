import type { OcclusionMesh, OcclusionScene } from './OcclusionScene.js';

/** The buffers of meshes that a bake starts with. */
export const occlusionMeshBuffers = ({ meshes }: { meshes: OcclusionMesh[] }): ArrayBuffer[] =>
  meshes.flatMap(({ positions, indices, normals }) => [
    positions.buffer,
    indices.buffer,
    ...(normals ? [normals.buffer] : []),
  ]);

/** The buffers of a bake's state. */
export const occlusionSceneBuffers = (scene: OcclusionScene): ArrayBuffer[] => [
  scene.positions.buffer,
  scene.indices.buffer,
  scene.samplePositions.buffer,
  scene.sampleNormals.buffer,
  scene.sums.buffer,
  ...scene.views.map(({ samples }) => samples.buffer),
  ...scene.sampleOf.map(({ buffer }) => buffer),
];
