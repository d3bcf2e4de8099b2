import type { Mutation } from '../Mutation.js';

export const exposure: readonly Mutation[] = [
  {
    name: 'a bowl is a room',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'upwards > LEVEL ? occluded : 0',
    replace: 'occluded',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/openOcclusion.test.ts',
      title: 'is 0 in a bowl, on a table in the open, and for a body whose underside is hidden',
    },
  },
  {
    name: 'all hollows may be solid dark',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'openOcclusion: ofRoom + (1 - ofRoom) * ofHollows',
    replace: 'openOcclusion: ofRoom',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/openOcclusion.test.ts',
      title: 'hardly any of it stays darker than a shallow hollow',
    },
  },
  {
    name: 'folds of a body are niches',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'isWall && occluded < HIDDEN',
    replace: 'occluded < HIDDEN',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/openOcclusion.test.ts',
      title: 'fewer are enough where they have large walls, and walls that nothing is seen of do not count',
    },
  },
  {
    name: 'hollows in rooms count from the open sky on, as lines',
    file: 'src/look/relativeOcclusion.ts',
    find: 'occluded - open',
    replace: 'occluded',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/openOcclusion.test.ts',
      title: 'is nothing up to that of the open parts, and all where nothing of the sky is seen',
    },
  },
  {
    name: 'the least contrast is the most',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'Math.min(contrast, MAX_CONTRAST)',
    replace: 'Math.max(contrast, MAX_CONTRAST)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitExposure.test.ts',
      title: 'all around, and no others, are blown up by no more than four',
    },
  },
  {
    name: 'darks are lifted',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'if (!(contrast > 1))',
    replace: 'if (!(contrast > 0))',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title: 'darks are not lifted: of more contrast than asked, only the brights are fitted',
    },
  },
  {
    name: 'what is nearly black becomes white',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'Math.max(MIN_WHITE, lightness.quantile(WHITE))',
    replace: 'lightness.quantile(WHITE)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title: 'the lightest colours are white, but not those that are nearly black',
    },
  },
  {
    name: 'a compensation leaves what is added',
    file: 'src/material/exposure/writeFit.ts',
    find: '.set(scale, offset).multiplyScalar(exposureCompensation)',
    replace: '.set(scale * exposureCompensation, offset)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title:
        'a material takes a fit with its compensation, colours divided by what is white, and a share of the plan of values',
    },
  },
  {
    name: 'the light half of a scene is not left blank',
    file: 'src/material/exposure/planValues.ts',
    find: 'clamp01((share - PAPER) / (1 - PAPER))',
    replace: 'clamp01(share)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/planValues.test.ts',
      title: 'leaves the light colours of a car of 45 blank, and makes only the darkest dark',
    },
  },
  {
    name: 'masses of a scene are not told apart',
    file: 'src/material/exposure/planValues.ts',
    find: 'lighter.darkness + wanted',
    replace: 'lighter.darkness',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/planValues.test.ts',
      title: 'draws a fox of orange, white and dark brown with blank white, light orange and dark legs',
    },
  },
  {
    name: 'a small light part darkens all others',
    file: 'src/material/exposure/planValues.ts',
    find: 'Math.min(1, value.before / LIGHTS)',
    replace: '1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/planValues.test.ts',
      title: 'leaves nearly all blank that is darker than a small light part alone, and rises with its share',
    },
  },
  {
    name: 'undersides count in the plan of values as what lies above them does',
    file: 'src/material/exposure/ExposureFit.ts',
    find: '0.5 + 0.5 * y',
    replace: '1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitExposure.test.ts',
      title: 'of undersides hardly count in the plan of values',
    },
  },
  {
    name: 'no filter is taken for colours of one lightness',
    file: 'src/material/exposure/planValues.ts',
    find: '<= LOST) return plain;',
    replace: '<= 1) return plain;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/planValues.test.ts',
      title: 'tells stripes of another hue and the same lightness apart',
    },
  },
  {
    name: 'all of a mesh with several materials has the colour of the first',
    file: 'src/material/exposure/ExposureFit.ts',
    find: 'materials[groups[i]]',
    replace: 'materials[0]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitExposure.test.ts',
      title: 'count by the material of each group, and not where triangles are in no group',
    },
  },
  {
    name: 'many small parts keep tones of their own',
    file: 'src/material/exposure/planTones.ts',
    find: 'if (surface.isSmall)',
    replace: 'if (false)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitExposure.test.ts',
      title: 'that are many and small have the mean tone of those beside them, and few keep their own',
    },
  },
  {
    name: 'colours are darkened by their white',
    file: 'src/material/exposure/writeFit.ts',
    find: '1 / white',
    replace: 'white',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title:
        'a material takes a fit with its compensation, colours divided by what is white, and a share of the plan of values',
    },
  },
];
