import type { Mutation } from '../Mutation.js';

export const bake: readonly Mutation[] = [
  {
    name: 'the lower half of the octahedron is folded with the wrong sign',
    file: 'src/mesh/bake/outlineLayout.ts',
    find: '(u < 0 ? -1 : 1)',
    replace: '(v < 0 ? -1 : 1)',
    caughtBy: { layer: 'unit', file: 'tests/unit/mesh/bake/octahedral.test.ts', title: 'is kept to 0.005°' },
  },
  {
    name: 'half floats are cut, not rounded',
    file: 'src/mesh/bake/packOutlines.ts',
    find: ' + 0x1000',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/bake/halfFloat.test.ts',
      title: 'rounds half up, across powers of two too',
    },
  },
  {
    name: 'the vertices across two edges change places',
    file: 'src/mesh/bake/bakeCorners.ts',
    find: 'copyPosition(vertices, beta, corners, target + 10)',
    replace: 'copyPosition(vertices, beta, corners, target + 11)',
    caughtBy: { layer: 'unit', file: 'tests/unit/mesh/bake/bakeCorners.test.ts', title: 'a fold of … true' },
  },
  {
    name: 'corners turn the other way',
    file: 'src/mesh/bake/bakeCorners.ts',
    find: 'corners[target + 3] = k',
    replace: 'corners[target + 3] = 2 - k',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/bake/bakeCorners.test.ts',
      title: 'packs six adjacency vertices per corner',
    },
  },
  {
    name: 'copies of a vertex forget the part',
    file: 'src/mesh/bake/splitVertices.ts',
    find: 'ofCorner[a] === ofCorner[b] && partOf[a] === partOf[b]',
    replace: 'ofCorner[a] === ofCorner[b]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/bake/packForm.test.ts',
      title: 'vertices are copied where a fan has several form vertices, and where a form vertex has several fans',
    },
  },
];
