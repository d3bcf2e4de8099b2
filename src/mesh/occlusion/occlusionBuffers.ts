import type { OcclusionMesh, OcclusionScene } from './OcclusionScene.js';

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
