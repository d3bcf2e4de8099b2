import type { Mutation } from '../Mutation.js';

export const tone: readonly Mutation[] = [
  {
    name: 'the perceptual curve is upside down',
    file: 'src/vector/shading/tone.ts',
    find: '1 - lightness(1 - tone)',
    replace: 'lightness(tone)',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/shading/tone.test.ts', title: ', with every curve' },
  },
  {
    name: 'steps of tone are cut, not rounded',
    file: 'src/vector/shading/tone.ts',
    find: 'tone * last + 0.5',
    replace: 'tone * last',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/shading/tone.test.ts', title: ', with every curve' },
  },
  {
    name: 'hollows darken lamps as much as skies',
    file: 'src/vector/shading/tone.ts',
    find: 'occlusion * occluded * smoothstep(0, CAVITY, occluded)',
    replace: 'occlusion * occluded',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/tone.test.ts',
      title: 'takes all of its share of the sky, and of lamps only where much of the sky is hidden',
    },
  },
  {
    name: 'a curve overshoots between its points',
    file: 'src/material/fitToneCurve.ts',
    find: '(a + b) / (a / before + b / after)',
    replace: '(before + after) / 2',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/fitToneCurve.test.ts',
      title: 'never leaves the range between two neighbouring points',
    },
  },
  {
    name: 'a curve has its spans begin at their ends',
    file: 'src/material/fitToneCurve.ts',
    find: '[points[i][0], 1 / width]',
    replace: '[points[i + 1][0], 1 / width]',
    caughtBy: { layer: 'unit', file: 'tests/unit/material/fitToneCurve.test.ts', title: 'has no corner at its points' },
  },
  {
    name: 'lines that are born take all the room',
    file: 'src/vector/shading/ruledLines.ts',
    find: 'rank === top - 1 ? 2 ** top - powerOf2(octave)',
    replace: 'rank === top - 1 ? powerOf2(octave)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/lineAnswers.test.ts',
      title: 'roomOf',
    },
  },
  {
    name: 'strokes of a pen begin as thick as they are',
    file: 'src/vector/shading/penStrokes.ts',
    find: '(1 - rest * rest)',
    replace: '(1 - rest)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/lineAnswers.test.ts',
      title: 'strokeAt: width and offset',
    },
  },
  {
    name: 'the curve of points has no cubes',
    file: 'src/material/toneCurveTable.ts',
    find: '(cubics[3 * i + 1] + t * cubics[3 * i + 2])',
    replace: 'cubics[3 * i + 1]',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title: 'hatching equals the double-precision reference: …tone curve of points',
    },
  },
  {
    name: 'colours darken by their luminance',
    file: 'shaders/chunks/localDarkness.glsl',
    find: 'float light = lightness(y.x)',
    replace: 'float light = y.x',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title: 'hatching equals the double-precision reference: …local tone, in a shadow that crosses',
    },
  },
  {
    name: 'shaders keep details of maps that are finer than strokes',
    file: 'shaders/chunks/localColor.glsl',
    find: 'texture2D(map, vMapUv, mapBlur)',
    replace: 'texture2D(map, vMapUv)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/localTone.spec.ts',
      title: 'a plan of values leaves out details of a map that are finer than strokes, and keeps coarser ones',
    },
  },
  {
    name: 'drawings as lines keep details of maps that are finer than lines',
    file: 'src/vector/paint/ColourReader.ts',
    find: 'coarse[3] < OPAQUE_TEXEL ? map : coarse',
    replace: 'map',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/coarseMaps.test.ts',
      title: 'has no details that are finer than lines can show',
    },
  },
  {
    name: 'metal mirrors a room upside down',
    file: 'shaders/chunks/metal.glsl',
    find: 'smoothstep(-HORIZON, HORIZON, above)',
    replace: 'smoothstep(-HORIZON, HORIZON, -above)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/metal.spec.ts',
      title: 'metal mirrors a room as the reference on the processor: …engraving',
    },
  },
  {
    name: 'drawings as lines mirror no room in metal',
    file: 'src/vector/ToneReader.ts',
    find: 'const share = look.mirrored;',
    replace: 'const share = 0;',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/vector.spec.ts',
      title: 'a torus of smooth metal is drawn as on the canvas',
    },
  },
  {
    name: 'steps of tone are cut in shaders',
    file: 'shaders/chunks/tone.glsl',
    find: 'floor(tone * last + 0.5)',
    replace: 'floor(tone * last)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title: 'hatching equals the double-precision reference: …toon…, point light, moved object',
    },
  },
];
