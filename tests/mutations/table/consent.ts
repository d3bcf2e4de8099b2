import type { Mutation } from '../Mutation.js';

export const consent: readonly Mutation[] = [
  {
    name: 'Escape agrees',
    file: 'src/playground/loading/ask.ts',
    find: "dialog.returnValue === 'yes'",
    replace: "dialog.returnValue !== 'no'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/loading/ask.test.ts',
      title: 'only yes is yes',
    },
  },
  {
    name: 'a question about another address stays open',
    file: 'src/playground/loading/ask.ts',
    find: '  withdrawOpen();\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/loading/ask.test.ts',
      title: 'a later question takes the place of an earlier one, whose answer is no',
    },
  },
  {
    name: 'a question is withdrawn with yes',
    file: 'src/playground/loading/ask.ts',
    find: "dialog.close('no')",
    replace: "dialog.close('yes')",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/loading/ask.test.ts',
      title: 'only yes is yes',
    },
  },
  {
    name: 'a click that was on its way agrees',
    file: 'src/playground/loading/ask.ts',
    find: '  hold();\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/loading/ask.test.ts',
      title: 'a grave question cannot be accepted at once, nor right after the window returns to the front',
    },
  },
  {
    name: 'a click that brings the window to the front agrees',
    file: 'src/playground/loading/ask.ts',
    find: "addEventListener('focus', hold, { signal: end });",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/loading/ask.test.ts',
      title: 'a grave question cannot be accepted at once, nor right after the window returns to the front',
    },
  },
  {
    name: 'no is taken for yes',
    file: 'src/playground/session/LinkFollower.ts',
    find: 'if (isAgreed) modelLoader',
    replace: 'if (isAgreed !== undefined) modelLoader',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/LinkFollower.test.ts',
      title: 'a model of another site is fetched if the user agrees; if not, something else is shown',
    },
  },
  {
    name: 'an agreement counts for an address that is gone',
    file: 'src/playground/session/LinkFollower.ts',
    find: '    this.asked.drop();\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/LinkFollower.test.ts',
      title: 'an agreement is ignored once the address has changed',
    },
  },
  {
    name: 'the model goes before the user has agreed to another',
    file: 'src/playground/session/LinkFollower.ts',
    find: '{ ...next, model: session.settings.model }',
    replace: 'next',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/LinkFollower.test.ts',
      title: 'until the user has agreed, the look of a link is shown on the model that is there',
    },
  },
  {
    name: 'another window may say what was fetched',
    file: 'src/playground/fetch/fetchModel.ts',
    find: 'source !== frame.contentWindow || ',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchModel.test.ts',
      title: 'messages of other windows and sites are ignored',
    },
  },
  {
    name: 'another site may say what was fetched',
    file: 'src/playground/fetch/fetchModel.ts',
    find: ' || origin !== location.origin',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchModel.test.ts',
      title: 'messages of other windows and sites are ignored',
    },
  },
  {
    name: 'a request goes on when it is aborted',
    file: 'src/playground/fetch/fetchModel.ts',
    find: '      frame.remove();\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchModel.test.ts',
      title: 'an abort removes the frame, and with it the request',
    },
  },
  {
    name: 'a site is named with what stands before it',
    file: 'src/playground/fetch/fetchModel.ts',
    find: 'site: host }',
    replace: 'site: address }',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchModel.test.ts',
      title: 'an address is described by its file and by its host in ASCII',
    },
  },
  {
    name: 'a site may redirect to any other',
    file: 'src/playground/fetch/fetchMain.ts',
    find: '  keepTo(new URL(address).origin);\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchMain.test.ts',
      title: 'before a request, the page blocks every other site',
    },
  },
  {
    name: 'cookies go along',
    file: 'src/playground/fetch/fetchMain.ts',
    find: "credentials: 'omit'",
    replace: "credentials: 'include'",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchMain.test.ts',
      title: 'a file is fetched without cookies and referrer, and posted in parts',
    },
  },
  {
    name: 'any page may have files fetched',
    file: 'src/playground/fetch/fetchMain.ts',
    find: ' && source === parent',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/fetch/fetchMain.test.ts',
      title: 'only the page around it may ask',
    },
  },
];
