import type { Mutation } from '../Mutation.js';

export const normals: readonly Mutation[] = [
  {
    name: 'a fan ends at the first border',
    file: 'src/mesh/normals/fans.ts',
    find: 'twin = twins[previousCorner(twin)];',
    replace: 'break;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/normals/buildFans.test.ts',
      title: 'a fan is the set of corners connected by edges with twins around a vertex',
    },
  },
  {
    name: 'normals diffuse for twice the time',
    file: 'src/mesh/normals/smoothFanNormals.ts',
    find: 'radius ** 2 / 4',
    replace: 'radius ** 2 / 2',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/normals/hatchNormals.test.ts',
      title: 'a wave is flattened as by heat flow, whatever the triangles',
    },
  },
  {
    name: 'an edge without a twin counts for its start alone',
    file: 'src/mesh/normals/fans.ts',
    find: 'if (twins[corner] === NO_TWIN) sizes[ofCorner[nextCorner(corner)]]++;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/normals/sortFans.test.ts',
      title: 'one of … comes last, with its own number',
    },
  },
  {
    name: 'a fan ends where the walk began, not at a border',
    file: 'src/mesh/normals/fans.ts',
    find: 'corner = twin === NO_TWIN ? first : nextCorner(twin);',
    replace: 'corner = twin === NO_TWIN ? first : previousCorner(twin);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/normals/buildFans.test.ts',
      title: 'a fan is the set of corners connected by edges with twins around a vertex',
    },
  },
];
