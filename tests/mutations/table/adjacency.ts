import type { Mutation } from '../Mutation.js';

export const adjacency: readonly Mutation[] = [
  {
    name: 'a twin is one corner off',
    file: 'src/mesh/adjacency/pairEdges.ts',
    find: 'twins[corner] = other;\n      twins[other] = corner;',
    replace: 'twins[corner] = other + 1;\n      twins[other] = corner;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/adjacency/buildTriangleAdjacency.test.ts',
      title: "'T-junction'",
    },
  },
  {
    name: '−0 and 0 are two positions',
    file: 'src/mesh/weldPositions.ts',
    find: 'bits === NEGATIVE_ZERO_BITS ? 0 : bits',
    replace: 'bits',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/weldPositions.test.ts',
      title: 'agrees with a brute-force search',
    },
  },
  {
    name: 'backward half-edges are not turned around',
    file: 'src/mesh/adjacency/matchNonManifoldEdge.ts',
    find: 'isForward ? angle : (angle + Math.PI) % TWO_PI',
    replace: 'angle',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/adjacency/buildTriangleAdjacency.test.ts',
      title: "'three triangles on one edge'",
    },
  },
  {
    name: 'the farthest pair at a crowded edge comes first',
    file: 'src/mesh/adjacency/matchNonManifoldEdge.ts',
    find: 'a.gap < b.gap ||',
    replace: 'a.gap > b.gap ||',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/adjacency/buildTriangleAdjacency.test.ts',
      title: "'three triangles on one edge'",
    },
  },
  {
    name: 'borders are joined however long the side that they swallow',
    file: 'src/mesh/adjacency/joinBorders.ts',
    find: '> rounding) kept.add',
    replace: '> Infinity) kept.add',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/adjacency/joinBorders.test.ts',
      title: 'stay apart where a triangle would collapse, unless its side is mere rounding',
    },
  },
  {
    name: 'windings that contradict each other stay twins',
    file: 'src/mesh/adjacency/buildTriangleAdjacency.ts',
    find: 'canonicalCorners[corner] === canonicalCorners[twin]',
    replace: 'canonicalCorners[corner] === twin',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/adjacency/consistentTwins.test.ts',
      title: 'are separated if they are not, and the given twins stay unchanged',
    },
  },
];
