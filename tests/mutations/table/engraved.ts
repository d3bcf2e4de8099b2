import type { Mutation } from '../Mutation.js';

export const engraved: readonly Mutation[] = [
  {
    name: 'young lines are as wide as old ones',
    file: 'shaders/techniques/engraved/ruledLines.glsl',
    find: '0.5 * (pixels - spacing)',
    replace: '0.5 * spacing',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravedReference.spec.ts',
      title: 'engraved equals the double-precision reference: …tangent to a light from above',
    },
  },
  {
    name: 'families cross from black alone',
    file: 'shaders/techniques/engraved/hatchLayer.glsl',
    find: 'takenOf(tone, crossFrom)',
    replace: 'takenOf(tone, 1.0)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravedReference.spec.ts',
      title: 'engraved equals the double-precision reference: …crossing at right angles from light tones on',
    },
  },
  {
    name: 'lines across the first lean the other way',
    file: 'shaders/techniques/engraved/readCut.glsl',
    find: 'lean.x * h.value + lean.y * dot(h.point, side)',
    replace: 'lean.x * h.value - lean.y * dot(h.point, side)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravedReference.spec.ts',
      title: 'engraved equals the double-precision reference: …crossing at right angles from light tones on',
    },
  },
];
