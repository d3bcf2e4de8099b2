import type { Mutation } from '../Mutation.js';

export const files: readonly Mutation[] = [
  {
    name: 'columns of PLY begin a row late',
    file: 'src/files/ply/plyBlocks.ts',
    find: 'let offset = numbers.at;',
    replace: 'let offset = numbers.at + rowBytes;',
    caughtBy: { layer: 'unit', file: 'tests/unit/files/ply/readPly.test.ts', title: 'data that begin as a line does' },
  },
  {
    name: 'a PLY list of shorts counts in bytes',
    file: 'src/files/ply/plyHeader.ts',
    find: "ushort: 'uint16'",
    replace: "ushort: 'uint8'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/ply/readPly.test.ts',
      title: 'elements in any order, with lists and values of their own, and vertices as doubles far away',
    },
  },
  {
    name: 'loops of STL of four corners lose one triangle',
    file: 'src/files/stl/readAsciiStl.ts',
    find: 'corner + 3 <= loop.length',
    replace: 'corner + 3 < loop.length',
    caughtBy: { layer: 'unit', file: 'tests/unit/files/stl/readStl.test.ts', title: 'numbers in every notation' },
  },
  {
    name: 'bytes after a binary STL make it text',
    file: 'src/files/stl/readStl.ts',
    find: 'bytes.slice(0, length)',
    replace: 'bytes.slice()',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/stl/readStl.test.ts',
      title: 'binary files may begin with "solid" and go on after their triangles',
    },
  },
  {
    name: '3DS keeps the normals of the loader',
    file: 'src/files/scenes/read3ds.ts',
    find: 'root?.traverse(withoutNormals);',
    replace: '',
    caughtBy: { layer: 'unit', file: 'tests/unit/files/scenes/readScene.test.ts', title: 'edges of 3DS stay sharp' },
  },
  {
    name: 'FBX 6 as text is let through',
    file: 'src/files/scenes/readFbx.ts',
    find: 'ascii: 7000',
    replace: 'ascii: 6000',
    caughtBy: { layer: 'unit', file: 'tests/unit/files/scenes/readScene.test.ts', title: 'a.fbx' },
  },
  {
    name: 'Collada is read without its scene',
    file: 'src/files/scenes/readCollada.ts',
    find: '?.scene',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/scenes/readScene.test.ts',
      title: 'what stands in for a page is taken away again',
    },
  },
  {
    name: 'the sky of VRML is part of the model',
    file: 'src/files/scenes/withoutBackground.ts',
    find: 'object.visible = false',
    replace: 'object.visible = true',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/scenes/readScene.test.ts',
      title: 'is drawn with its colours, whatever it is called',
    },
  },
  {
    name: 'the lower side of a model points up',
    file: 'src/files/mesh/findUpAxis.ts',
    find: 'above > 1.1 * below',
    replace: 'below > 1.1 * above',
    caughtBy: { layer: 'unit', file: 'tests/unit/files/mesh/findUpAxis.test.ts', title: 'by the flat side below' },
  },
  {
    name: 'edges in one direction close a mesh',
    file: 'src/files/mesh/isClosed.ts',
    find: '- scatter(b ^ Math.imul(a, 3))) | 0',
    replace: '+ scatter(b ^ Math.imul(a, 3))) | 0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/mesh/isClosed.test.ts',
      title: 'two tetrahedra with an edge in common … is closed',
    },
  },
  {
    name: 'a file of no triangles is read',
    file: 'src/files/mesh/checkTriangleCount.ts',
    find: '!(triangles > 0)',
    replace: '!(triangles >= 0)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/files/mesh/checkTriangleCount.test.ts',
      title: 'three million triangles are let through, and those that a gigabyte cannot hold are not',
    },
  },
  {
    name: 'simplified meshes lose their last vertex',
    file: 'src/files/simplify/simplifyMesh.ts',
    find: 'numbers[vertex] - 1)',
    replace: 'numbers[vertex])',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/demo/files/simplifyMesh.test.ts',
      title: 'a simpler mesh lies as near as it says, keeps its colours and has no vertex to spare',
    },
  },
];
