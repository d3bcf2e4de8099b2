import type { Mutation } from '../Mutation.js';

export const exports: readonly Mutation[] = [
  {
    name: 'a sheet upright lies',
    file: 'src/playground/print/printPlan.ts',
    find: 'isWide ? [long, short] : [short, long]',
    replace: 'isWide ? [short, long] : [long, short]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/printPlan.test.ts',
      title: 'measures … to a pixel, turned as suits the model',
    },
  },
  {
    name: 'strokes in print become finer than pixels',
    file: 'src/playground/print/printPlan.ts',
    find: 'Math.max(fit, strokeShare',
    replace: 'Math.min(fit, strokeShare',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/printPlan.test.ts',
      title: 'has strokes as wide as on the page, in proportion, and no finer than on a screen of as many pixels',
    },
  },
  {
    name: 'a picture is cut within a block of pixels',
    file: 'src/playground/print/printPlan.ts',
    find: 'pixels - (pixels % 2)',
    replace: 'pixels',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/printPlan.test.ts',
      title: 'is cut to the drawing, and looked at in coarse, without moving it',
    },
  },
  {
    name: 'margins of a sheet are on one side',
    file: 'src/playground/print/print.ts',
    find: '[width - 2 * margin, height - 2 * margin]',
    replace: '[width - margin, height - margin]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/svgPlan.test.ts',
      title: 'margins that leave no room are refused in a sentence',
    },
  },
  {
    name: 'PNG says dots per inch as per metre',
    file: 'src/playground/print/PngWriter.ts',
    find: 'Math.round(dpi * INCHES_PER_METRE)',
    replace: 'Math.round(dpi)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/PngWriter.test.ts',
      title: 'writes what it was given, with … channels, and its size in print',
    },
  },
  {
    name: 'a near model is as far as its middle',
    file: 'src/playground/print/print.ts',
    find: 'depth - 1',
    replace: 'depth',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/print/nearestRadius.test.ts',
      title: 'within the model the nearest place is at the near plane',
    },
  },
  {
    name: 'videos have odd sides',
    file: 'src/playground/video/videoPlan.ts',
    find: '2 * Math.round(pixels / 2)',
    replace: 'Math.round(pixels)',
    caughtBy: { layer: 'unit', file: 'tests/unit/playground/video/videoPlan.test.ts', title: 'has even sides: … page' },
  },
  {
    name: 'the last frame of a video repeats the first',
    file: 'src/playground/video/videoPlan.ts',
    find: 'const share = frame / frames;',
    replace: 'const share = frame / (frames - 1);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/video/videoPlan.test.ts',
      title: 'begins where the page is, and ends where it began, without a jump: … swing',
    },
  },
  {
    name: 'a clip is played a part of a time',
    file: 'src/playground/video/videoPlan.ts',
    find: 'Math.max(1, Math.round((seconds * speed) / duration))',
    replace: 'Math.max(1, (seconds * speed) / duration)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/video/videoPlan.test.ts',
      title: 'begins where the page is, and ends where it began, without a jump: … clip',
    },
  },
  {
    name: 'code leaves names unescaped',
    file: 'src/playground/code/codeForms.ts',
    find: '/[&<>"]/g',
    replace: '/[&<>]/g',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/code/pageSample.test.ts',
      title: 'keeps names of files to themselves',
    },
  },
  {
    name: 'code for a scene has the scale of the page',
    file: 'src/playground/code/lookSample.ts',
    find: '(tilesPerObjectUnit / radius)',
    replace: '(tilesPerObjectUnit * radius)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/code/codeSample.test.ts',
      title: 'hatches a loaded scene as the page does, its surfaces … spelled out',
    },
  },
];
