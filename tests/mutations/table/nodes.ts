import type { Mutation } from '../Mutation.js';

export const nodes: readonly Mutation[] = [
  {
    name: 'nodes leave tone curves of points out',
    file: 'src/webgpu/nodes/chunks/tone.ts',
    find: "kind === 'points' ? tabledTone(tone) : tone",
    replace: 'tone',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'hatching … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'colours of nodes darken by their luminance',
    file: 'src/webgpu/nodes/chunks/tone.ts',
    find: 'lightness(clamp(dot(colorFilter.xyz, color), 0, 1))',
    replace: 'clamp(dot(colorFilter.xyz, color), 0, 1)',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'hatching … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'families of nodes cross from black alone',
    file: 'src/webgpu/nodes/lines/hatchLayer.ts',
    find: 'takenOf(tone, crossFrom, kept)',
    replace: 'takenOf(tone, float(1), kept)',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'engraving … in scenes of the reference: nodes draw what GLSL draws',
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
  {
    name: 'a focus of nodes is everywhere',
    file: 'src/webgpu/nodes/chunks/fading.ts',
    find: 'float(1), focused)',
    replace: 'float(1), float(1))',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'engraving … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'skies of nodes weigh twice',
    file: 'src/webgpu/nodes/base/lights.ts',
    find: '.mul(difference).mul(0.5)',
    replace: '.mul(difference)',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/outlines.spec.ts' },
  },
  {
    name: 'a toon of nodes has a step more',
    file: 'src/webgpu/nodes/chunks/tone.ts',
    find: 'toneSteps.sub(1)',
    replace: 'toneSteps',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/surfaces.spec.ts' },
  },
  {
    name: 'dots of nodes are the larger of two sizes',
    file: 'src/webgpu/nodes/strokes/stipple.ts',
    find: 'min(onObject, onScreen)',
    replace: 'max(onObject, onScreen)',
    caughtBy: {
      layer: 'webgpu',
      file: 'tests/webgpu/reference.spec.ts',
      title: 'stipple … in scenes of the reference: nodes draw what GLSL draws',
    },
  },
  {
    name: 'morph targets of nodes stay as they are',
    file: 'src/material/three/posing.ts',
    find: '    this.morphTargetInfluences = mesh.morphTargetInfluences;\n',
    replace: '',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/posed.spec.ts' },
  },
  {
    name: 'outlines of nodes are as pale on a canvas as linear light makes them',
    file: 'src/webgpu/outlines/HatchingOutlineNodeMaterial.ts',
    find: 'isClear ? 1 / (lightOf(inkGrey) - light) : 0',
    replace: '0',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/onCanvas.spec.ts' },
  },
  {
    name: 'outlines of nodes are wide in the light',
    file: 'src/webgpu/nodes/outlines/shade.ts',
    find: 'mix(shadeWeights.x, shadeWeights.y, share)',
    replace: 'mix(shadeWeights.y, shadeWeights.x, share)',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/outlines.spec.ts' },
  },
  {
    name: 'inner contours of nodes weigh as outer ones',
    file: 'src/webgpu/nodes/outlines/piece.ts',
    find: 'max(innerContours.mul(ofContour), whole)',
    replace: 'max(ofContour, whole)',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/outlines.spec.ts' },
  },
  {
    name: 'ink of nodes that multiplies lies on white',
    file: 'src/webgpu/nodes/chunks/ink.ts',
    find: 'isMultiplied ? ground.mul(ink) : ink',
    replace: 'ink',
    caughtBy: { layer: 'webgpu', file: 'tests/webgpu/surfaces.spec.ts' },
  },
];
