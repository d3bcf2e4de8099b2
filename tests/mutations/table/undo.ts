import type { Mutation } from '../Mutation.js';

export const undo: readonly Mutation[] = [
  {
    name: 'changes of two settings become one step',
    file: 'src/viewer/settings/EditHistory.ts',
    find: 'source === this.lastSource &&',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/EditHistory.test.ts',
      title: 'quick changes by keys or the wheel are one step',
    },
  },
  {
    name: 'a press that pauses makes two steps',
    file: 'src/viewer/settings/EditHistory.ts',
    find: ': press === this.lastPress;',
    replace: ': time - this.lastTime < PAUSE_MILLISECONDS && press === this.lastPress;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/EditHistory.test.ts',
      title: 'one drag is one step, however long it pauses; the next is another, however soon it comes',
    },
  },
  {
    name: 'a look is a step before it is applied',
    file: 'src/playground/session/Session.ts',
    find: '    this.apply();\n    this.history.changed(source);',
    replace: '    this.history.changed(source);\n    this.apply();',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title: 'changes of the view caused by settings belong to the same step',
    },
  },
  {
    name: 'views of the former model stay',
    file: 'src/playground/session/Session.ts',
    find: 'if (isOther) this.views.list = ofFile;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title:
        'another model leaves the views of its file and none of the one before; the same one with more pictures keeps them',
    },
  },
  {
    name: 'an answer that was replaced is taken',
    file: 'src/playground/session/LinkFollower.ts',
    find: 'controller.signal.aborted ? undefined : result',
    replace: 'result',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/LatestRequest.test.ts',
      title: 'only the later of two requests has a result, in whatever order they end',
    },
  },
  {
    name: 'the address does not wait for the model',
    file: 'src/playground/session/DrawingStore.ts',
    find: ' || modelLoader.isLoading',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/AddressWriter.test.ts',
      title: 'nothing is written while the page shows another drawing than the settings describe',
    },
  },
  {
    name: 'changes of the last moment are lost',
    file: 'src/playground/session/DrawingStore.ts',
    find: 'if (this.timer !== undefined) this.write();',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/AddressWriter.test.ts',
      title: 'a change of the last moment is written when the page is left, and nothing if there was none',
    },
  },
  {
    name: 'a new change keeps what was undone',
    file: 'src/viewer/settings/EditHistory.ts',
    find: '    this.future.length = 0;\n    this.now = this.read();',
    replace: '    this.now = this.read();',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/EditHistory.test.ts',
      title: 'a change after Undo leaves nothing to redo',
    },
  },
  {
    name: 'a step to where the page is already is a step',
    file: 'src/viewer/settings/EditHistory.ts',
    find: 'if (this.isSame(next, present)) continue;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/settings/EditHistory.test.ts',
      title: 'steps that lead to the present state are skipped',
    },
  },
  {
    name: 'Undo leaves the views as they are',
    file: 'src/playground/session/Session.ts',
    find: '    this.views.list = kept;\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title: 'Undo brings back the views that the drawing had, and the camera from which a look was seen',
    },
  },
  {
    name: 'Undo of a look frames the model',
    file: 'src/playground/session/Session.ts',
    find: 'if (place) viewport.view.state = place;\n    else viewport.view.frame();',
    replace: 'viewport.view.frame();',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title: 'Undo brings back the views that the drawing had, and the camera from which a look was seen',
    },
  },
  {
    name: 'a kept view is no step',
    file: 'src/playground/session/DrawingState.ts',
    find: '  JSON.stringify(a.views) === JSON.stringify(b.views) &&\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title: 'Undo brings back the views that the drawing had, and the camera from which a look was seen',
    },
  },
  {
    name: 'a look is framed before it is applied',
    file: 'src/playground/session/Session.ts',
    find: '    viewport.apply(this.look);\n    if (place)',
    replace: '    if (place)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/Session.test.ts',
      title: 'a look without a camera is framed with what it has made of the drawing',
    },
  },
  {
    name: 'a second finger ends a press',
    file: 'src/playground/session/watchPresses.ts',
    find: 'if (!isPrimary) return;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/watchPresses.test.ts',
      title: 'of several fingers only the first counts',
    },
  },
  {
    name: 'all presses are one',
    file: 'src/playground/session/watchPresses.ts',
    find: 'if (next) count++;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/playground/session/watchPresses.test.ts',
      title: 'each press has a number, which is there until it ends',
    },
  },
];
