import type { Mutation } from '../Mutation.js';

export const svg: readonly Mutation[] = [
  {
    name: 'numbers of a path lose their minus sign',
    file: 'src/vector/paths/finishPaths.ts',
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
    file: 'src/vector/paths/LinePath.ts',
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
    find: 'points[o] - x * points[o + 3]',
    replace: 'points[o] - x * points[o + 2]',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/paths.test.ts', title: 'covers as much as its widths say' },
  },
  {
    name: 'hollows become deep at once',
    file: 'src/look/constants/shadingConstants.ts',
    find: 'HOLLOW: [0.1, 0.8]',
    replace: 'HOLLOW: [0.3, 0.45]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/svg/hollows.test.ts',
      title: 'a deep hollow grows dark over at least six line spacings: … stipple',
    },
  },
  {
    name: 'gaps of lost edges are three times as long as they may be',
    file: 'src/vector/outlines/loseEdges.ts',
    find: 'LONGEST_GAP = 0.1;',
    replace: 'LONGEST_GAP = 0.3;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/svg/lostEdges.test.ts',
      title: 'a pen leaves gaps of limited length in the outline of a … boot …, and no loose piece',
    },
  },
  {
    name: 'a reversed path begins where it began',
    file: 'src/vector/paths/orderPaths.ts',
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
      title: 'hits that hide a place from an eye at the far end, and hits that shade it',
    },
  },
  {
    name: 'a drawing for a pen is filled',
    file: 'src/playground/export/saveSvg.ts',
    find: 'kind: settings.pictureSvg,',
    replace: "kind: 'print',",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/export/saveSvg.test.ts',
      title: 'a print has filled paths on its paper, and a pen has lines of its width on none',
    },
  },
  {
    name: 'a pen draws the border of the paper',
    file: 'src/playground/export/saveSvg.ts',
    find: "...(!isPen && settings.pictureGround === 'paper' &&",
    replace: "...(settings.pictureGround === 'paper' &&",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/export/saveSvg.test.ts',
      title: 'a print has filled paths on its paper, and a pen has lines of its width on none',
    },
  },
  {
    name: 'an empty file is saved',
    file: 'src/playground/export/saveSvg.ts',
    find: 'drawing.paths === 0 && !picture',
    replace: 'drawing.paths < 0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/export/saveSvg.test.ts',
      title: 'strokes of a map are left out for a pen with a message; without anything else, nothing is saved',
    },
  },
  {
    name: 'closed paths stay open',
    file: 'src/vector/paths/finishPaths.ts',
    find: "isClosed ? 'z' : ''",
    replace: "''",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'path data comes back as the points it was written from, to hundredths of a millimetre',
    },
  },
  {
    name: 'the last dash ends before the path',
    file: 'src/vector/paths/LinePath.ts',
    find: '(length - on) / (count - 1)',
    replace: '(length - on) / count',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'begin and end a path, are equally long, and lie equally far from each other',
    },
  },
  {
    name: 'dashes of a closed path end before it closes',
    file: 'src/vector/paths/LinePath.ts',
    find: 'isClosed ? [...points, ...points.slice(0, PATH_STRIDE)] : points',
    replace: 'points',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'go once around a closed path, and a short path stays whole',
    },
  },
  {
    name: 'what crosses the edge is cut at its middle',
    file: 'src/vector/paths/strokeOutline.ts',
    find: 'here / (here - there)',
    replace: '0.5',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/paths.test.ts',
      title: 'cuts where a side meets the limit, whichever way it runs',
    },
  },
];
