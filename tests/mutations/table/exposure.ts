import type { Mutation } from '../Mutation.js';

export const exposure: readonly Mutation[] = [
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
    file: 'src/material/exposure/ToneFit.ts',
    find: '.set(fit.scale, fit.offset).multiplyScalar(exposureCompensation)',
    replace: '.set(fit.scale * exposureCompensation, fit.offset)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title: 'a material takes a fit with its compensation, and its colours are divided by what is white',
    },
  },
  {
    name: 'colours are darkened by their white',
    file: 'src/material/exposure/ToneFit.ts',
    find: '1 / fit.white',
    replace: 'fit.white',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitTones.test.ts',
      title: 'a material takes a fit with its compensation, and its colours are divided by what is white',
    },
  },
];
