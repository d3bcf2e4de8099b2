import type { Mutation } from '../Mutation.js';

export const form: readonly Mutation[] = [
  {
    name: 'shapes with a form are drawn by the light',
    file: 'src/mesh/form/bakeForm.ts',
    find: "flatShare < FLAT_FACED_SHARE ? 'form' : 'light'",
    replace: "flatShare > FLAT_FACED_SHARE ? 'form' : 'light'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/form/chooseDirection.test.ts',
      title: 'nothing … has flat faces',
    },
  },
  {
    name: 'jumps of both families have one multiple',
    file: 'src/mesh/form/phase/solvePhase.ts',
    find: 'MULTIPLES = [4, 2]',
    replace: 'MULTIPLES = [4, 4]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/form/phase/roundJumps.test.ts',
      title: 'a few that are left are rounded to the nearest',
    },
  },
  {
    name: 'jumps are rounded one by one',
    file: 'src/mesh/form/phase/solvePhase.ts',
    find: 'given[i] - jumpForce(part, moves, i) * part.inverses[part.nodes.length + i]',
    replace: 'given[i]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/form/phase/roundJumps.test.ts',
      title:
        'to multiples of 4, and of 2 for lines that cross; of two jumps that are held to each other, one up and the other down',
    },
  },
];
