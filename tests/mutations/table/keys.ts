import type { Mutation } from '../Mutation.js';

const file = 'tests/unit/playground/pageKeys.test.ts';
const isShortcut = 'a letter is a shortcut outside of fields and lists, without a modifier, and under no dialog';
const steps = 'Undo and Redo have the keys of every system, but not in text fields or under a dialog';

export const keys: readonly Mutation[] = [
  {
    name: 'shortcuts of the browser are those of the page',
    file: 'src/playground/pageKeys.ts',
    find: 'ctrlKey || metaKey || altKey ||',
    replace: 'altKey ||',
    caughtBy: { layer: 'unit', file, title: isShortcut },
  },
  {
    name: 'letters in lists are shortcuts',
    file: 'src/playground/pageKeys.ts',
    find: ', select, textarea',
    replace: ', textarea',
    caughtBy: { layer: 'unit', file, title: isShortcut },
  },
  {
    name: 'a page has shortcuts under an open dialog',
    file: 'src/playground/pageKeys.ts',
    find: '!takesLetters && !isDialogOpen()',
    replace: '!takesLetters',
    caughtBy: { layer: 'unit', file, title: isShortcut },
  },
  {
    name: 'digits show the next view',
    file: 'src/playground/pageKeys.ts',
    find: 'Number(event.key) - 1',
    replace: 'Number(event.key)',
    caughtBy: {
      layer: 'unit',
      file,
      title: 'each key does what it is for, and digits show the views that they number',
    },
  },
  {
    name: 'Escape closes two things',
    file: 'src/playground/pageKeys.ts',
    find: "event.key === 'Escape' && !isDialogOpen()",
    replace: "event.key === 'Escape'",
    caughtBy: { layer: 'unit', file, title: 'Escape closes an open dialog alone' },
  },
  {
    name: 'Undo in a field undoes the drawing',
    file: 'src/playground/pageKeys.ts',
    find: 'altKey || isTyping ||',
    replace: 'altKey ||',
    caughtBy: { layer: 'unit', file, title: steps },
  },
  {
    name: 'with Shift Undo is Undo',
    file: 'src/playground/pageKeys.ts',
    find: "shiftKey ? 'redo' : 'undo'",
    replace: "'undo'",
    caughtBy: { layer: 'unit', file, title: steps },
  },
];
