import type { Mutation } from '../Mutation.js';

export const occlusion: readonly Mutation[] = [
  {
    name: 'the corners of a wide ground share the view of the bulk',
    file: 'src/mesh/occlusion/startOcclusion.ts',
    find: 'FARTHER = 1.5',
    replace: 'FARTHER = 1500',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: 'a wide ground does not blur the objects on it',
    },
  },
  {
    name: 'samples at a border lie in the wall',
    file: 'src/mesh/occlusion/startOcclusion.ts',
    find: ' + INWARD * inward[i]',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: 'turned inside out show their backs',
    },
  },
  {
    name: 'large triangles are measured at their corners alone',
    file: 'src/mesh/occlusion/samplesWithin.ts',
    find: 'LARGE = 0.04',
    replace: 'LARGE = 4000',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: 'under a roof is dark, although its corners reach beyond',
    },
  },
  {
    name: 'rods with buried ends are black',
    file: 'src/mesh/occlusion/addDirections.ts',
    find: 'Math.max(0, (own - BURIED) / (1 - BURIED))',
    replace: '0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: 'whose ends lie in balls is lit, since it is seen between them',
    },
  },
  {
    name: 'mirrored meshes are dark outside',
    file: 'src/mesh/occlusion/startOcclusion.ts',
    find: 'sign * Math.sign(',
    replace: 'Math.sign(',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: 'turned inside out show their backs',
    },
  },
  {
    name: 'no map is turned about its direction',
    file: 'src/mesh/parallelProjection.ts',
    find: '2 * Math.PI * fraction(0.5 + (index + 1) / RATIO ** 3)',
    replace: '0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/mapAxes.test.ts',
      title: 'maps are rotated about their directions by evenly distributed angles',
    },
  },
  {
    name: 'directions lie about the horizon',
    file: 'src/mesh/parallelProjection.ts',
    find: 'const height = fraction(0.5 + (index + 1) / RATIO);',
    replace: 'const height = fraction(0.5 + (index + 1) / RATIO) ** 2;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/mapAxes.test.ts',
      title: 'directions are evenly spread over the upper half of the sphere',
    },
  },
  {
    name: 'the back of a surface has the hollows of its front',
    file: 'src/mesh/occlusion/startOcclusion.ts',
    find: 'front.normals.map((value) => -value)',
    replace: 'front.normals',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/occlusion/occlusion.test.ts',
      title: '… outside and inside each have their own',
    },
  },
  {
    name: 'the front is drawn with the hollows of the back',
    file: 'shaders/chunks/occlude.glsl',
    find: 'gl_FrontFacing ? vOcclusion.x : vOcclusion.y',
    replace: 'gl_FrontFacing ? vOcclusion.y : vOcclusion.x',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/occlusion.spec.ts',
      title: 'a bowl is as bright as the sky that the side sees which is seen: …',
    },
  },
  {
    name: 'a sheet that is lit on its back lies in its own shadow',
    file: 'shaders/chunks/turnShadows.glsl',
    find: 'gl_FrontFacing ? vec3(0.0) : 2.0 *',
    replace: '0.0 *',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/twoSides.spec.ts',
      title: '… turned inside out: …',
    },
  },
];
