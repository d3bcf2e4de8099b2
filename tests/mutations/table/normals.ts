import type { Mutation } from '../Mutation.js';

export const normals: readonly Mutation[] = [
  {
    name: 'a fan ends at the first border',
    file: 'src/normals/buildFans.ts',
    find: 'twin = twins[previousCorner(twin)];',
    replace: 'break;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/normals/buildFans.test.ts',
      title: 'a fan is what edges with twins connect around a vertex',
    },
  },
  {
    name: 'normals diffuse for twice the time',
    file: 'src/normals/smoothFanNormals.ts',
    find: 'radius ** 2 / 4',
    replace: 'radius ** 2 / 2',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/normals/hatchNormals.test.ts',
      title: 'a wave is flattened as heat flow says, whatever the triangles',
    },
  },
];
