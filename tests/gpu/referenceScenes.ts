import { mat4 } from 'gl-matrix';
import type { ReferenceLight, ReferenceMaterial } from '../reference/hatchingReference.js';
import type { PlainMesh } from '../reference/meshes.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';

/** Placements, cameras, lights and a material that the comparisons with the reference share. */

export const identity = [...mat4.create()];
export const rotated = [...mat4.fromRotation(mat4.create(), 0.9, [1, 2, -0.5])!];
export const placed = [
  ...mat4.scale(
    mat4.create(),
    mat4.translate(mat4.create(), rotated as unknown as mat4, [0.1, -0.15, 0.2]),
    [0.8, 0.8, 0.8],
  ),
];
export const mirrored = [...mat4.scale(mat4.create(), rotated as unknown as mat4, [-1, 1, 1])];
export const squashed = [...mat4.scale(mat4.create(), rotated as unknown as mat4, [1.2, 0.6, 0.9])];

/** A wall, and how it stands when it is seen at 80° to its normal. */
export const wall: PlainMesh = {
  positions: [-1.6, -1.6, 0, 1.6, -1.6, 0, 1.6, 1.6, 0, -1.6, 1.6, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  indices: [0, 1, 2, 0, 2, 3],
};
export const leaning = [...mat4.fromXRotation(mat4.create(), -1.64)];

/** The mesh, shifted along each axis from the origin of its space, with the placement that brings it back. */
export const moved = (mesh: PlainMesh, by: number): PlainMesh => ({
  ...mesh,
  positions: mesh.positions.map((x) => x + by),
});
export const movedBack = (by: number) => [...mat4.fromTranslation(mat4.create(), [-by, -by, -by])];

export const eye: Vec3 = [0.9, 0.8, 3];
export const perspective = {
  view: [...mat4.lookAt(mat4.create(), eye, [0, 0, 0], [0, 1, 0])],
  projection: [...mat4.perspective(mat4.create(), 0.75, 1, 0.1, 20)],
};
export const orthographic = {
  view: perspective.view,
  projection: [...mat4.ortho(mat4.create(), -1.2, 1.2, -1.2, 1.2, 0.1, 20)],
};

export const white = (intensity: number): Vec3 => [intensity, intensity, intensity];
export const directional: ReferenceLight = { type: 'directional', color: white(Math.PI), position: [1, 1.5, 2] };
/** Far enough off for something to stand between. */
export const blocked: ReferenceLight = { ...directional, position: [3, 4.5, 6], isBlocked: true };
export const point: ReferenceLight = {
  type: 'point',
  color: white(9),
  position: [1.2, 1.1, 1.7],
  distance: 6,
  decay: 2,
};
export const spot: ReferenceLight = {
  type: 'spot',
  color: white(5),
  position: [-0.8, 1.4, 2],
  target: [0.1, 0, 0],
  angle: 0.45,
  penumbra: 0.6,
  decay: 0,
};
export const fadingSpot: ReferenceLight = { ...spot, color: white(14), distance: 5, decay: 1.5 };
/** Two equally strong lights from very different directions. */
export const crossed: ReferenceLight[] = [
  { type: 'directional', color: white(1.4), position: [2, 0.3, 1.2] },
  { type: 'directional', color: white(1.4), position: [-0.2, 2, 1] },
];
export const ambient: ReferenceLight = { type: 'ambient', color: white(0.5) };
export const hemisphere: ReferenceLight = {
  type: 'hemisphere',
  color: [0.9, 1.2, 1.6],
  groundColor: [0.4, 0.3, 0.2],
  position: [0.1, 1, 0.2],
};
export const redSide: ReferenceLight = { type: 'directional', color: [2, 0.3, 0.2], position: [-2, 0.4, 1] };

export const defaults: ReferenceMaterial = {
  technique: 'adjacency',
  toneModel: 'lambert',
  toneSteps: 4,
  shininess: 30,
  toneNormal: 'face',
  tilesPerObjectUnit: 1.7,
  strokeAngle: -0.4,
  strokeOffset: [0.13, 0.37],
  blendAngle: Math.PI / 2,
  toneCurve: 'linear',
  reflectedLight: 0,
  strokeLayers: 'single',
  crossFrom: 0.52,
  crossAngle: Math.PI / 3,
  sharpInk: false,
  levelRule: 'derivatives',
  inkBlend: 'cover',
  ink: [0, 0, 0],
  paper: [1, 1, 1],
  color: [1, 1, 1],
  colorHatching: 0,
  colorFill: 1,
};
