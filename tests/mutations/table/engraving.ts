import type { Mutation } from '../Mutation.js';

export const engraving: readonly Mutation[] = [
  {
    name: 'young lines are as wide as old ones',
    file: 'shaders/techniques/lines/ruledLines.glsl',
    find: '0.5 * (pixels - spacing)',
    replace: '0.5 * spacing',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravingLines.spec.ts',
      title: 'engraving equals the lines of vector files: …tangent to a light from above',
    },
  },
  {
    name: 'families cross from black alone',
    file: 'shaders/techniques/lines/hatchLayer.glsl',
    find: 'takenOf(tone, crossFrom)',
    replace: 'takenOf(tone, 1.0)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravingLines.spec.ts',
      title: 'engraving equals the lines of vector files: …crossing at right angles from light tones on',
    },
  },
  {
    name: 'lines across the first lean the other way',
    file: 'shaders/techniques/lines/readCut.glsl',
    find: 'lean.x * h.value + lean.y * dot(h.point, side)',
    replace: 'lean.x * h.value - lean.y * dot(h.point, side)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravingLines.spec.ts',
      title: 'engraving equals the lines of vector files: …crossing at right angles from light tones on',
    },
  },
  {
    name: 'wedges of a woodcut swell less, in shaders and vector files alike',
    file: 'src/look/constants/lineConstants.ts',
    find: 'SWELL_SHARE: 1.3',
    replace: 'SWELL_SHARE: 1.2',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/shading/lineAnswers.test.ts', title: 'cutWidth' },
  },
  {
    name: 'wedges of a woodcut swell less in vector files',
    file: 'src/vector/shading/carving.ts',
    find: 'Math.min(SWELL, SWELL_SHARE * rare)',
    replace: 'Math.min(SWELL, rare)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/engravingLines.spec.ts',
      title: 'engraving equals the lines of vector files: …carved, placed and crossed by shadow',
    },
  },
  {
    name: 'families that cross take the whole tone, in shaders and vector files alike',
    file: 'src/look/constants/shadingConstants.ts',
    find: 'KEPT_SHARE: 0.4',
    replace: 'KEPT_SHARE: 0.5',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/shading/lineAnswers.test.ts', title: 'darkness of fragments' },
  },
];
