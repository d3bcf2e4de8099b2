import type { Mutation } from '../Mutation.js';

export const command: readonly Mutation[] = [
  {
    name: 'frames are numbered from 0',
    file: 'src/command/planOutputs.ts',
    find: 'String(i + 1)',
    replace: 'String(i)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/command/outputs.test.ts',
      title: 'frames are numbered with as many digits as the last one has',
    },
  },
  {
    name: 'two drawings may have one name',
    file: 'src/command/planOutputs.ts',
    find: 'if (other !== undefined)',
    replace: 'if (other === model)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/command/outputs.test.ts',
      title: 'frames are numbered with as many digits as the last one has',
    },
  },
  {
    name: 'margins may take the whole sheet',
    file: 'src/command/parseDrawing.ts',
    find: '2 * margin >= Math.min',
    replace: 'margin >= Math.min',
    caughtBy: { layer: 'unit', file: 'tests/unit/command/parseDrawing.test.ts', title: 'is refused in one sentence' },
  },
  {
    name: 'negative angles are options',
    file: 'src/command/readOptions.ts',
    find: '/^-(\\d|\\.|[xyz]$)/i',
    replace: '/^-([xyz]$)/i',
    caughtBy: { layer: 'unit', file: 'tests/unit/command/parseDrawing.test.ts', title: 'the example of the help' },
  },
  {
    name: 'hidden files match a star',
    file: 'src/command/planOutputs.ts',
    find: "(!name.startsWith('.') || step.startsWith('.'))",
    replace: 'true',
    caughtBy: { layer: 'unit', file: 'tests/unit/command/outputs.test.ts', title: '*.stl' },
  },
];
