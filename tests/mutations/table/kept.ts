import type { Mutation } from '../Mutation.js';

export const kept: readonly Mutation[] = [
  {
    name: 'any address may be the picture of a look',
    file: 'src/playground/savedLooks/SavedLooks.ts',
    find: '/^data:image\\/(webp|png);/.test(stored) &&',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/storage/KeptLooks.test.ts',
      title: 'valid looks are read from damaged or hostile storage, with allowed values only',
    },
  },
  {
    name: 'one drawing more is kept',
    file: 'src/playground/session/KeptDrawings.ts',
    find: 'isSameModel(other) || i >= MOST - 1)',
    replace: 'isSameModel(other) || i >= MOST)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/storage/KeptDrawings.test.ts',
      title: 'are twelve at most: the oldest is deleted, with its files',
    },
  },
  {
    name: 'drawings come in the order of their age',
    file: 'src/playground/session/KeptDrawings.ts',
    find: 'b.at - a.at',
    replace: 'a.at - b.at',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/storage/KeptDrawings.test.ts',
      title: 'make room, the oldest first, where the browser has no more',
    },
  },
  {
    name: 'a full quota is an error at once',
    file: 'src/playground/session/KeptDrawings.ts',
    find: "!== 'QuotaExceededError'",
    replace: "=== 'QuotaExceededError'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/storage/KeptDrawings.test.ts',
      title: 'make room, the oldest first, where the browser has no more',
    },
  },
  {
    name: 'a deleted drawing comes back',
    file: 'src/playground/session/KeptDrawings.ts',
    find: 'if (known) await',
    replace: 'await',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/storage/KeptDrawings.test.ts',
      title: 'are changed, unless they were deleted',
    },
  },
  {
    name: 'a picture is taken while a model stands in',
    file: 'src/playground/session/KeptPicture.ts',
    find: '!viewport.shown.isPlaceholder &&',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/KeptPicture.test.ts',
      title: 'a drawing that is not final waits for a later frame, and is read once',
    },
  },
  {
    name: 'a view is framed before it is lit',
    file: 'src/playground/savedLooks/SavedViews.ts',
    find: '    viewport.apply(lookOf(settings));\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/savedLooks/SavedViews.test.ts',
      title: 'a view brings back its camera and its light, which is there before the model is framed',
    },
  },
  {
    name: 'a view is shown in any light',
    file: 'src/playground/savedLooks/SavedViews.ts',
    find: 'isLitBy(this.settings, light) && ',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/savedLooks/SavedViews.test.ts',
      title: 'a view brings back its camera and its light, which is there before the model is framed',
    },
  },
  {
    name: 'a view may have no name',
    file: 'src/playground/savedLooks/SavedViews.ts',
    find: 'plainName(name) || view.name',
    replace: 'plainName(name)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/savedLooks/SavedViews.test.ts',
      title: 'views are named, renamed and deleted; a name of nothing is none; each change makes another list',
    },
  },
  {
    name: 'a free name may be taken',
    file: 'src/playground/savedLooks/SavedViews.ts',
    find: 'if (!items.some((item) => item.name === name)) return name;',
    replace: 'return name;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/savedLooks/SavedViews.test.ts',
      title: 'a name that is free is none of those that are taken',
    },
  },
];
