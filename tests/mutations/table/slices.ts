import type { Mutation } from '../Mutation.js';

export const slices: readonly Mutation[] = [
  {
    name: 'a task that is aborted keeps what it holds',
    file: 'src/mesh/runSliced.ts',
    find: '    task.return(undefined as never);\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/runSliced.test.ts',
      title: 'errors of the task and of the callback reject',
    },
  },
  {
    name: 'progress is reported though it does not rise',
    file: 'src/mesh/runSliced.ts',
    find: 'value > reported',
    replace: 'value >= reported',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/runSliced.test.ts',
      title: 'progress is reported once per slice and rises strictly',
    },
  },
  {
    name: 'a phase begins where the task does',
    file: 'src/mesh/phases.ts',
    find: 'yield from + (to - from) * step.value',
    replace: 'yield to * step.value',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/bake/bakeIndexed.test.ts',
      title: 'progress rises and ends at 1',
    },
  },
];
