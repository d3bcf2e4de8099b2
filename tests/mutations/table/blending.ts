import type { Mutation } from '../Mutation.js';

export const blending: readonly Mutation[] = [
  {
    name: 'α and β are exchanged',
    file: 'shaders/perTriangle/adjacencyPrimitive.glsl',
    find: 'Triangle(p.v1, p.v0, p.vAlpha)',
    replace: 'Triangle(p.v1, p.v0, p.vBeta)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/material.spec.ts',
      title: 'equals the double-precision reference: … oth map',
    },
  },
  {
    name: 'blend factors are not clamped',
    file: 'shaders/techniques/adjacency/read.glsl',
    find: 'vec4(1.0, max(blendFactors, 0.0))',
    replace: 'vec4(1.0, blendFactors)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/material.spec.ts',
      title: 'equals the double-precision reference: …torus…directional…adjacency…smooth…map',
    },
  },
  {
    name: 'a neighbour counts at the corner that it does not have',
    file: 'shaders/techniques/adjacency/emit.glsl',
    find: 'drawn.corner == 2 ? -1.0',
    replace: 'drawn.corner == 1 ? -1.0',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/material.spec.ts',
      title: 'equals the double-precision reference: …torus…directional…adjacency…smooth…map',
    },
  },
];
