import type { Mutation } from '../Mutation.js';

export const links: readonly Mutation[] = [
  {
    name: 'a variant that was chosen is not in the link',
    file: 'src/viewer/settings/shareLink.ts',
    find: "const CHOICES = ['variant', 'clip'] as const;",
    replace: "const CHOICES = ['clip'] as const;",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'includes the variant and the clip of a file, as numbers counted from 1',
    },
  },
  {
    name: 'the camera of a file fills the page and not the sheet on it',
    file: 'src/viewer/sceneSetup/LensCamera.ts',
    find: 'const [wide, high] = this.ownSheet;',
    replace: 'const [wide, high] = [1, 1];',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/sceneSetup/LensCamera.test.ts',
      title: 'shows all of its picture on a sheet in the middle of the page',
    },
  },
  {
    name: 'the element frames what is not seen, too',
    file: 'src/element/Drawing.ts',
    find: 'if (!one || isClear(one)) continue;',
    replace: 'if (!one) continue;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/element/Drawing.test.ts',
      title: 'a model fills the picture with its visible parts',
    },
  },
  {
    name: 'the target of the camera is its position',
    file: 'src/viewer/settings/CameraView.ts',
    find: '{ position: [x, y, z], target: [tx, ty, tz] }',
    replace: '{ position: [tx, ty, tz], target: [tx, ty, tz] }',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'restores a view to the last bit of single precision, from the fewest digits possible',
    },
  },
  {
    name: 'addresses without encryption are asked for',
    file: 'src/viewer/settings/shareLink.ts',
    find: "address.protocol !== 'https:' ||",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'carries a model by its address, over HTTPS alone',
    },
  },
  {
    name: 'names and passwords stay in addresses',
    file: 'src/viewer/settings/shareLink.ts',
    find: "address.username = '';",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'drops name and password of a URL, and rejects invalid hosts',
    },
  },
  {
    name: 'a camera is told in single digits',
    file: 'src/viewer/settings/shareLink.ts',
    find: 'if (Math.fround(short) === single) return short;',
    replace: 'return short;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'restores a view to the last bit of single precision, from the fewest digits possible',
    },
  },
  {
    name: 'numbers of a setting are clamped to the wrong end',
    file: 'src/viewer/settings/settings.ts',
    find: 'Math.min(max, Math.max(min, number))',
    replace: 'Math.max(max, Math.min(min, number))',
    caughtBy: { layer: 'unit', file: 'tests/unit/viewer/settings/acceptSetting.test.ts', title: 'lightAzimuth … -180' },
  },
  {
    name: 'odd numbers of a hand lose their sign',
    file: 'src/viewer/settings/handLink.ts',
    find: '-(value + 1) / 2',
    replace: '(value + 1) / 2',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/handLink.test.ts',
      title:
        'a hand comes back from its text: numbers to a thousandth, strokes and widths within a tenth of a millimetre',
    },
  },
  {
    name: 'strokes of a hand begin where the last one ended',
    file: 'src/viewer/settings/handLink.ts',
    find: 'if (k === 0) [start[0], start[1]] = [x, y];\n      points',
    replace: 'points',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/handLink.test.ts',
      title:
        'a hand comes back from its text: numbers to a thousandth, strokes and widths within a tenth of a millimetre',
    },
  },
  {
    name: 'boldness narrows lines',
    file: 'src/viewer/settings/lookOf.ts',
    find: 'settings.strokeWidth * size',
    replace: 'settings.strokeWidth / size',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/withBoldnessAndDensity.test.ts',
      title: 'boldness scales widths and spacings alike, and nothing else',
    },
  },
  {
    name: 'density brightens',
    file: 'src/viewer/settings/lookOf.ts',
    find: 'settings.lightStrength / cover',
    replace: 'settings.lightStrength * cover',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/withBoldnessAndDensity.test.ts',
      title: 'dense strokes cover more, as in less light; nothing else changes',
    },
  },
  {
    name: 'a background of hatching is asked of nodes',
    file: 'src/viewer/settings/lookOf.ts',
    find: "  ['background', ['on'], 'a hatched background'],\n",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/lackOfNodes.test.ts',
      title: "they lack something of … { background: 'on' }",
    },
  },
  {
    name: 'a link forgets its technique',
    file: 'src/viewer/settings/shareLink.ts',
    find: "value === SETTINGS[key].default && key !== 'technique'",
    replace: 'value === SETTINGS[key].default',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/shareLink.test.ts',
      title: 'with nothing but defaults is not the first view',
    },
  },
  {
    name: 'one view more than there are digits is read',
    file: 'src/viewer/settings/CameraView.ts',
    find: 'MAX_VIEWS = 9',
    replace: 'MAX_VIEWS = 10',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/savedViews.test.ts',
      title: 'no more views are read than there are keys for',
    },
  },
  {
    name: 'a view forgets the second light',
    file: 'src/viewer/settings/CameraView.ts',
    find: "  'secondElevation',\n",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/savedViews.test.ts',
      title: 'a view keeps where both lights are',
    },
  },
];
