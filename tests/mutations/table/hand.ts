import type { Mutation } from '../Mutation.js';

export const hand: readonly Mutation[] = [
  {
    name: 'strokes drawn backwards bend to the wrong side',
    file: 'src/strokes/hand/learnHand.ts',
    find: ' * Math.sign(Math.cos(stroke.angle - angle))',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/hand/learnHand.test.ts',
      title: 'does not depend on the direction or order of strokes',
    },
  },
  {
    name: 'the spread of lengths is that of squares',
    file: 'src/strokes/hand/learnHand.ts',
    find: 'Math.sqrt(deviations / Math.max(1, measures.length - 1)) / length',
    replace: 'deviations / Math.max(1, measures.length - 1) / length',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/hand/learnHand.test.ts',
      title: 'learns spreads from many random strokes',
    },
  },
  {
    name: 'crossing begins a tone early',
    file: 'src/strokes/hand/learnHand.ts',
    find: 'light: 0.125, middle: 0.375, dark: 0.625',
    replace: 'light: 0.125, middle: 0.125, dark: 0.375',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/hand/learnHand.test.ts',
      title: 'learns a second layer at … degrees',
    },
  },
  {
    name: 'strokes of a hand end along the axis across which they are counted',
    file: 'shaders/chunks/handStrokes.glsl',
    find: 'cells.places - cells.askew * ((x - line) * period)',
    replace: 'cells.places',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'strokes end straight across their rows',
    },
  },
  {
    name: 'strokes of a hand are half as long as drawn',
    file: 'shaders/chunks/handStrokes.glsl',
    find: 'float size = handReach.w',
    replace: 'float size = 0.5 * handReach.w',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'strokes of a hand are whole, and make the tone',
    },
  },
  {
    name: 'rows of a hand are drawn together to no bundles',
    file: 'shaders/chunks/handStrokes.glsl',
    find: 'if (handRows.y > 0.0) {',
    replace: 'if (false) {',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'strokes of a hand with clustering stand in bundles',
    },
  },
  {
    name: 'strokes of a hand that run beside each other lie end to end',
    file: 'shaders/chunks/handStrokes.glsl',
    find: 'row.late = isSecond ? handLanes.y : 0.0;',
    replace: 'row.late = 0.0;',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'strokes of a hand run beside the next one of their row by its overlap',
    },
  },
  {
    name: 'strokes of a hand lie on their rows in vector files',
    file: 'src/vector/shading/handStrokes.ts',
    find: 'row.way * (aside + offset) * spacing',
    replace: 'row.way * aside * spacing',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/handStrokes.test.ts',
      title: 'a row in full tone is one whole stroke of the hand after the other, as far apart as cells',
    },
  },
  {
    name: 'the second layer of a hand crosses to the same side whatever the sign of its angle',
    file: 'src/material/parts/handRows.ts',
    find: '(crossingAngle * Math.PI) / 180',
    replace: '(Math.abs(crossingAngle) * Math.PI) / 180',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'the second layer of a hand is turned from the first as on the sheet',
    },
  },
  {
    name: 'hard edges of shadows cut the strokes of a hand',
    file: 'shaders/chunks/handStrokes.glsl',
    find: '(at - t) * step',
    replace: '0.0 * step',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/handStrokes.spec.ts',
      title: 'strokes of a hand end at the hard edge of …, and are not cut to flecks',
    },
  },
  {
    name: 'hard edges of shadows cut the strokes of a hand in vector files',
    file: 'src/vector/shading/handStrokes.ts',
    find: 'row.way * size * length * (at - inFull), step)',
    replace: '0, step)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/handStrokes.test.ts',
      title:
        'strokes at the hard edge of a shadow are whole or lose a sixth at the edge, and no strokes are in the light',
    },
  },
];
