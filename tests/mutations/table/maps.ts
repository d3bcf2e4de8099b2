import type { Mutation } from '../Mutation.js';

export const maps: readonly Mutation[] = [
  {
    name: 'the mean filter rounds up',
    file: 'src/strokes/mapFiles/pngFormat.ts',
    find: '(left + up) >> 1',
    replace: '(left + up + 1) >> 1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/mapFiles/png.test.ts',
      title: 'reads the colours of another library, on white paper (colour type',
    },
  },
  {
    name: 'the checksum leaves out the type',
    file: 'src/strokes/mapFiles/pngFormat.ts',
    find: 'bytes.subarray(4, content.length + 8)',
    replace: 'bytes.subarray(8, content.length + 8)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/mapFiles/png.test.ts',
      title: 'writes what another library reads ( … channels)',
    },
  },
  {
    name: 'transparent pixels become black',
    file: 'src/strokes/mapFiles/decodePng.ts',
    find: '(grey * alpha) / 255 + 255 - alpha',
    replace: '(grey * alpha) / 255',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/mapFiles/png.test.ts',
      title: 'reads the greys of another library (colour type',
    },
  },
  {
    name: 'greys of few bits are not spread',
    file: 'src/strokes/mapFiles/decodePng.ts',
    find: '255 / (2 ** depth - 1)',
    replace: '255 / 2 ** depth',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/mapFiles/png.test.ts',
      title: 'spreads greys of … bits from black to white',
    },
  },
  {
    name: 'the tail of the normal distribution is mirrored',
    file: 'src/strokes/tamImages/thresholds.ts',
    find: 'return -normalQuantile(1 - p)',
    replace: 'return normalQuantile(1 - p)',
    caughtBy: { layer: 'unit', file: 'tests/unit/strokes/tamImages/encodeThresholds.test.ts', title: 'Φ⁻¹(' },
  },
  {
    name: 'lost ink comes back in its own tone alone',
    file: 'src/strokes/tamImages/generateHatchImages.ts',
    find: 'darker < images.length; darker++',
    replace: 'darker < tone + 1; darker++',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/tamImages/enforceLevelNesting.test.ts',
      title: 'repairs the nesting of levels without breaking that of tones',
    },
  },
  {
    name: 'tones are compared without tolerance',
    file: 'src/strokes/tamImages/checkHatchImages.ts',
    find: 'darker[i] > lighter[i] + 1',
    replace: 'darker[i] > lighter[i]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/tamImages/checkHatchImages.test.ts',
      title: 'counts texels that grow lighter with the tone, but allows 1/255',
    },
  },
  {
    name: 'layers of a map share no tone',
    file: 'src/material/tam/TonalArtMapTexture.ts',
    find: 'Math.min(3 * layer + channel, tones - 1)',
    replace: 'Math.min(4 * layer + channel, tones - 1)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/tam/packHatchImages.test.ts',
      title: 'has both neighbours of every tone in one layer, and unpacks each image',
    },
  },
  {
    name: 'the margin of thresholds repeats the near side',
    file: 'src/material/tam/thresholds.ts',
    find: '((column - MARGIN) & mask)',
    replace: '(Math.min(Math.max(column - MARGIN, 0), mask))',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/tam/packThresholds.test.ts',
      title: 'puts levels in a row where the shader reads them, each with a margin that wraps around',
    },
  },
  {
    name: 'the coarser variance counts the last level',
    file: 'src/material/tam/thresholds.ts',
    find: 'if (index === pairs.length - 1) return;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/tam/measureThresholdMoments.test.ts',
      title: 'of a level paired with itself is its variance',
    },
  },
];
