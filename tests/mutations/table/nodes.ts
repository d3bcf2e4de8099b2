import type { Mutation } from '../Mutation.js';

export const nodes: readonly Mutation[] = [
  {
    name: 'the spline of nodes has no cubes',
    file: 'src/webgpu/nodes/chunks/toneCurve.ts',
    find: 'b.add(t.mul(c))',
    replace: 'b',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'anchored … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'colours of nodes darken by their luminance',
    file: 'src/webgpu/nodes/chunks/localColor.ts',
    find: 'colorExposure.mul(lightness(clamp(lightLuminance(color), 0, 1)))',
    replace: 'colorExposure.mul(clamp(lightLuminance(color), 0, 1))',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'anchored … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'families of nodes cross from black alone',
    file: 'src/webgpu/nodes/techniques/engraved/hatchLayer.ts',
    find: 'takenOf(tone, crossFrom, kept)',
    replace: 'takenOf(tone, float(1), kept)',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'engraved … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'outlines of nodes show through what lies before them',
    file: 'src/webgpu/nodes/outlines/hierarchy.ts',
    find: 'gap.greaterThanEqual(spine.tolerance.negate())',
    replace: 'gap.greaterThanEqual(-1e9)',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/outlines.spec.ts',
    },
  },
];
