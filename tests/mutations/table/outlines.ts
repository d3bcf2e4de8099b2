import type { Mutation } from '../Mutation.js';

export const outlines: readonly Mutation[] = [
  {
    name: 'surfaces in contact count as neither before nor behind each other',
    file: 'src/mesh/intersections/sideOf.ts',
    find: 'return shift * (pairSign',
    replace: 'return 0 * shift * (pairSign',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/intersections/findIntersections.test.ts',
      title: 'grids whose vertices lie on each other’s edges and planes',
    },
  },
  {
    name: 'panels that nearly touch have lines',
    file: 'src/mesh/intersections/joinSegments.ts',
    find: 'sine < LEAST_SINE',
    replace: 'sine < 0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/intersections/findIntersections.test.ts',
      title: 'sheets that nearly touch, flat and curved',
    },
  },
  {
    name: 'lines where meshes meet stay where one of them has moved',
    file: 'src/material/outlines/MeetingLines.ts',
    find: 'difference <= ROUNDING * largest',
    replace: 'difference <= largest',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/outlines/intersections.test.ts',
      title: 'they stay while meshes move together',
    },
  },
  {
    name: 'creases are at least as flat as their angle',
    file: 'src/mesh/features/findFeatureEdges.ts',
    find: '<= creaseCosine',
    replace: '>= creaseCosine',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/features/findFeatureEdges.test.ts',
      title: 'with a featureAngle of',
    },
  },
  {
    name: 'borders between materials are missed',
    file: 'src/mesh/features/findFeatureEdges.ts',
    find: 'triangleGroups[triangle] !== triangleGroups[other]',
    replace: 'triangleGroups[triangle] === triangleGroups[other]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/features/findFeatureEdges.test.ts',
      title: 'have a material border between them, on flat and on sharp edges',
    },
  },
  {
    name: 'a list of contours outlives its reach',
    file: 'src/material/outlines/ContourList.ts',
    find: '(isSearchedInWorker ? 0.5 : 1) * this.reach',
    replace: '2 * this.reach',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/outlines/ContourList.test.ts',
      title: 'by direction alone with an orthographic camera, wherever it is',
    },
  },
  {
    name: 'instances are searched from the eye of their mesh',
    file: 'src/material/outlines/InstanceList.ts',
    find: 'place.applyMatrix3(inverse);',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/outlines/InstanceList.test.ts',
      title: 'is every primitive of an instance around the eye, flat or not',
    },
  },
  {
    name: 'widths of outlines forget the pixel ratio',
    file: 'src/material/outlines/outlineUniforms.ts',
    find: 'u[name].value *= pixelRatio',
    replace: 'u[name].value *= 1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/outlines/HatchingOutlineMaterial.test.ts',
      title: 'sizes are in CSS pixels, … pixels of the renderer each, and nothing else is',
    },
  },
  {
    name: 'weights of shade are exchanged',
    file: 'src/material/outlines/outlineUniforms.ts',
    find: '.set(weights.lit, weights.shade)',
    replace: '.set(weights.shade, weights.lit)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/outlines/HatchingOutlineMaterial.test.ts',
      title: 'those in the light and in the shade reach one uniform',
    },
  },
  {
    name: 'millimetres are inches',
    file: 'src/material/outlines/outlineProperties.ts',
    find: '/ MILLIMETRES_PER_INCH;',
    replace: '* MILLIMETRES_PER_INCH;',
    caughtBy: { layer: 'unit', file: 'tests/unit/material/outlines/millimetresToPixels.test.ts', title: 'pixels' },
  },
  {
    name: 'accents are as strong far away',
    file: 'src/vector/shading/outlines.ts',
    find: 'Math.max(accent, nearness * smoothstep',
    replace: 'Math.max(accent, smoothstep',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/shading/outlines.test.ts',
      title: 'the search ends at the own surface, and at the rim of the picture',
    },
  },
  {
    name: 'outlines are twice as wide',
    file: 'shaders/outlines/width.glsl',
    find: 'return 0.5 * outlineWidth',
    replace: 'return outlineWidth',
    caughtBy: { layer: 'gpu', file: 'tests/gpu/outlines.spec.ts', title: 'outlines on a sphere are as wide as asked' },
  },
  {
    name: 'every edge is a contour',
    file: 'src/mesh/features/contourCandidates.ts',
    find: 'if (isSeen) list[count++] = edge;',
    replace: 'list[count++] = edge;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/features/contourCandidates.test.ts',
      title: 'feature edges are listed, and edges between a side that faces the eye and one that faces away',
    },
  },
  {
    name: 'outlines show through what lies before them',
    file: 'shaders/outlines/hierarchy.glsl',
    find: '>= -vTolerance;',
    replace: '>= -1e9;',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/hiddenOutlines.spec.ts',
      title: 'no outline shows through',
    },
  },
  {
    name: 'the back of a smooth surface has no contours',
    file: 'shaders/outlines/contour.glsl',
    find: 'piece.start.bend + piece.end.bend < 0.0',
    replace: 'false',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/twoSides.spec.ts',
      title: 'a bowl…, turned inside out: …outlines',
    },
  },
  {
    name: 'the shade of an edge is that of the side which the other hides',
    file: 'shaders/outlines/featureEdge.glsl',
    find: '!(showsBack && isConcave)',
    replace: 'true',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/twoSides.spec.ts',
      title: 'a box without a lid…, turned inside out: …outlines',
    },
  },
  {
    name: 'the back of a smooth surface has no contours, as lines',
    file: 'src/vector/outlines/outlinePieces.ts',
    find: 'ends[0].bend + ends[1].bend < 0 ? -1 : 1',
    replace: 'ends[0].bend + ends[1].bend < 0 ? 1 : 1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/svg/twoSides.test.ts',
      title: 'outlines of a bowl… are the same when it is turned inside out',
    },
  },
];
