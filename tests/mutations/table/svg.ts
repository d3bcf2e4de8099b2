import type { Mutation } from '../Mutation.js';

export const svg: readonly Mutation[] = [
  {
    name: 'numbers of a path lose their minus sign',
    file: 'src/vector/paths/pathData.ts',
    find: "/^(-?)0\\./, '$1.'",
    replace: "/^(-?)0\\./, '.'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'path data comes back as the points it was written from, to hundredths of a millimetre',
    },
  },
  {
    name: 'a path is simplified without its widths',
    file: 'src/vector/paths/simplify.ts',
    find: 'for (const side of [2, 3])',
    replace: 'for (const side of [] as number[])',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'leaves out points, keeps both ends, and strays by no more than asked in place and width',
    },
  },
  {
    name: 'both sides of a stroke are as wide as the left one',
    file: 'src/vector/paths/strokeOutline.ts',
    find: 'points[o] + ty * points[o + 3] * mitre',
    replace: 'points[o] + ty * points[o + 2] * mitre',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/paths.test.ts', title: 'covers as much as its widths say' },
  },
  {
    name: 'a reversed path begins where it began',
    file: 'src/vector/order/orderPaths.ts',
    find: 'place = isReversed ? start : end;',
    replace: 'place = end;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'takes each path once, and a far shorter way',
    },
  },
  {
    name: 'a ray meets its own triangle',
    file: 'src/vector/Bvh.ts',
    find: '|| order[i] === except',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/Bvh.test.ts',
      title: 'what hides a place from an eye at the far end, and what shades it',
    },
  },
];
