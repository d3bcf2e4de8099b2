import { type IUniform, UniformsLib, UniformsUtils, Vector2, Vector4 } from 'three';
import { createFadingUniforms } from '../fading/fading.js';
import { keptFromProxies } from '../hatchingUniforms.js';
import { OUTLINE_NUMBER_NAMES } from './outlineProperties.js';

/** The uniforms that may differ between outlines with the same material, and all textures (see `MeshUniforms`). */
export const OUTLINE_MESH_UNIFORMS = [
  ...['outlinePoints', 'outlinePrimitives', 'deformedNormals', 'deformedPositions', 'deformedTurns'],
  ...['candidates', 'instancePlaces', 'sceneDepth', 'toothMap'],
  ...[
    'clippingPlanes',
    'eye',
    'importance',
    'isCutOut',
    'isDrawnBefore',
    'isListed',
    'materialBorders',
    'objectScale',
    'opacity',
    'pull',
    'radius',
  ],
];

/** Creates the uniforms of an outline material: those of its properties, of the geometry and camera, and of lights and fog. */
export const createOutlineUniforms = (): Record<string, IUniform> =>
  keptFromProxies(
    UniformsUtils.merge([
      UniformsLib.lights,
      UniformsLib.fog,
      createFadingUniforms(),
      Object.fromEntries(OUTLINE_NUMBER_NAMES.map((name) => [name, { value: 0 }])),
      {
        ink: { value: null },
        opacity: { value: 1 },
        shadeWeights: { value: null },
        toothMap: { value: null },
        isDashed: { value: false },
        // Geometry and mesh.
        outlinePoints: { value: null },
        outlinePrimitives: { value: null },
        radius: { value: 1 },
        deformedNormals: { value: null },
        deformedPositions: { value: null },
        deformedTurns: { value: null },
        // Camera.
        candidates: { value: null },
        instancePlaces: { value: null },
        isCutOut: { value: false },
        isDrawnBefore: { value: false },
        isListed: { value: false },
        pull: { value: 0 },
        eye: { value: new Vector4() },
        hasSceneDepth: { value: false },
        sceneDepth: { value: null },
        nearDistance: { value: 0 },
        objectScale: { value: 1 },
        viewport: { value: new Vector4() },
        toothOffset: { value: new Vector2() },
      },
    ]),
  );
