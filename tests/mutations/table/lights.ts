import type { Mutation } from '../Mutation.js';

export const lights: readonly Mutation[] = [
  {
    name: 'a spot is whole up to its outer cone',
    file: 'src/vector/shading/radiance.ts',
    find: 'smoothstep(outer, inner, cosine)',
    replace: 'smoothstep(0, inner, cosine)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/tone.test.ts',
      title: 'halfLambert … , with every curve',
    },
  },
  {
    name: 'light falls off without an end',
    file: 'src/vector/shading/radiance.ts',
    find: '(length / distance) ** 4',
    replace: '(length / distance) ** 2',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/shading/tone.test.ts', title: 'phong … , with every curve' },
  },
  {
    name: 'planes get as much reflected light on both sides of a light',
    file: 'src/vector/shading/radiance.ts',
    find: 'Math.max(dot(normal, side), 0)',
    replace: 'Math.abs(dot(normal, side))',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/tone.test.ts',
      title: 'halfLambert … , with every curve',
    },
  },
  {
    name: 'round bodies get reflected light beside a light, as planes do',
    file: 'src/vector/LineSurface.ts',
    find: 'isPlane: hasOneToneNormal(vertices, a, b) && hasOneToneNormal(vertices, a, c)',
    replace: 'isPlane: true',
    caughtBy: { layer: 'unit', file: 'tests/unit/vector/LineSurface.test.ts', title: 'a triangle is plane' },
  },
  {
    name: 'half Lambert is not squared',
    file: 'src/vector/shading/radiance.ts',
    find: '(0.5 * cosine + 0.5) ** 2',
    replace: '0.5 * cosine + 0.5',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/tone.test.ts',
      title: 'halfLambert … , with every curve',
    },
  },
  {
    name: 'shade is told from what faces away',
    file: 'src/scene/lighting/chooseLight.ts',
    find: 'facing * openness[part] < LOOKS_HALF_AS_BRIGHT',
    replace: 'facing < LOOKS_HALF_AS_BRIGHT',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/lighting/flatteringLight.test.ts',
      title: 'baked occlusion counts as far as the material draws it',
    },
  },
  {
    name: 'a light from the right is preferred',
    file: 'src/scene/lighting/chooseLight.ts',
    find: 'azimuth > 0 ? LEFT_ADVANTAGE',
    replace: 'azimuth < 0 ? LEFT_ADVANTAGE',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/lighting/flatteringLight.test.ts',
      title: 'leaves about two fifths of a sphere in shade, from the upper front',
    },
  },
];
