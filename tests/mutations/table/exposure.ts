import type { Mutation } from '../Mutation.js';

export const exposure: readonly Mutation[] = [
  {
    name: 'the least contrast is the most',
    file: 'src/material/exposure/fitTones.ts',
    find: 'Math.min(contrast, MOST_CONTRAST)',
    replace: 'Math.max(contrast, MOST_CONTRAST)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/exposure/fitExposure.test.ts',
      title: 'all around, and no others, are blown up by no more than four',
    },
  },
];
