import type { Mutation } from '../Mutation.js';

export const repair: readonly Mutation[] = [
  {
    name: 'vertices are renumbered from 1',
    file: 'src/viewer/files/mesh/cleanMesh.ts',
    find: 'renumbered[vertex] - 1),',
    replace: 'renumbered[vertex]),',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/cleanMesh.test.ts',
      title: 'a vertex without a triangle',
    },
  },
  {
    name: 'duplicates in two colours are one',
    file: 'src/viewer/files/mesh/dropDuplicates.ts',
    find: '...(colors ? [{ bits: bits(colors), size: 3 }] : []),',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/dropDuplicates.test.ts',
      title: 'triangles that differ in colours, texture coordinates or pictures are kept',
    },
  },
  {
    name: 'colours that are not numbers become black',
    file: 'src/viewer/files/scenes/repairGeometry.ts',
    find: "name === 'color' ? WHITE : 0",
    replace: '0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/scenes/repairGeometry.test.ts',
      title: 'every mesh of a scene is repaired, also its weights',
    },
  },
  {
    name: 'whole morph targets take zero',
    file: 'src/viewer/files/scenes/repairGeometry.ts',
    find: 'base?.getComponent(vertex, component) ?? 0',
    replace: '0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/scenes/repairGeometry.test.ts',
      title: 'a NaN in a morph target leaves the vertex in place',
    },
  },
  {
    name: 'a corner that is not a number is kept',
    file: 'src/viewer/files/mesh/cleanMesh.ts',
    find: 'Number.isFinite(positions[3 * vertex + 2]);',
    replace: 'true;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/cleanMesh.test.ts',
      title: 'a vertex of no depth',
    },
  },
  {
    name: 'a few duplicates are left out, too',
    file: 'src/viewer/files/mesh/dropDuplicates.ts',
    find: 'found.dropped.length <= HARMLESS_SHARE * total',
    replace: 'found.dropped.length <= 0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/dropDuplicates.test.ts',
      title: 'a few duplicates, as scans have, stay: the mesh is as it was',
    },
  },
];
