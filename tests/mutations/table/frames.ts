import type { Mutation } from '../Mutation.js';

export const frames: readonly Mutation[] = [
  {
    name: 'B points away from the light',
    file: 'shaders/chunks/lightOrientation.glsl',
    find: 'vec3 projected = l - n * dot(l, n);',
    replace: 'vec3 projected = n * dot(l, n) - l;',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/material.spec.ts',
      title: 'equals the double-precision reference: …torus…directional…adjacency…smooth…map',
    },
  },
  {
    name: 'T runs the other way',
    file: 'shaders/perTriangle/strokeCoordinates.glsl',
    find: 'cross(n, vertex)',
    replace: 'cross(vertex, n)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/material.spec.ts',
      title: 'equals the double-precision reference: …torus…directional…adjacency…smooth…map',
    },
  },
];
