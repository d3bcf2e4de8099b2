/** The rooms that the playground and the command share. */
const SHARED = ['/src/files', '/src/settings', '/src/drawing', '/src/staging'];

/**
 * The rooms of `src`, lowest first, and which other rooms each may import. A name means the room beside it; a path that starts with `/` lies
 * in the project's root. A room inside of a room may import what its surroundings may, and nothing of the files around it.
 */
export const ROOMS = {
  // Pure: typed arrays in, typed arrays out.
  slices: [],
  mesh: ['slices'],
  adjacency: ['slices', 'mesh'],
  normals: ['slices', 'mesh', 'adjacency'],
  features: ['slices', 'mesh', 'adjacency', 'normals'],
  form: ['slices', 'mesh', 'adjacency', 'normals', 'features'],
  bake: ['slices', 'mesh', 'adjacency', 'normals', 'features', 'form'],
  occlusion: ['slices', 'mesh'],
  detail: ['slices'],
  lighting: [],
  hand: [],
  scan: ['slices', 'hand'],
  strokes: ['hand'],
  hatchImages: ['slices', 'hand', 'strokes'],
  mapFiles: ['strokes', 'hatchImages'],
  worker: ['slices', 'features', 'form', 'bake', 'occlusion', 'detail', 'hatchImages'],

  handTasks: ['hand', 'scan', 'worker'],

  // With three.js.
  mistakes: [],
  tam: ['mistakes', 'slices', 'hand', 'strokes', 'hatchImages', 'mapFiles', 'worker'],
  'material/facts': [],
  engraving: ['material/facts'],
  // The numbers that shaders have as defines.
  'engraving/constants': [],
  vector: ['slices', 'engraving'],
  geometry: ['mistakes', 'mesh', 'adjacency', 'features', 'form', 'bake', 'worker', 'material/facts'],
  material: ['mistakes', 'strokes', 'bake', 'tam', 'geometry', '/shaders'],
  'material/shaders': ['facts', '/src/engraving/constants'],
  'material/deformation': ['shaders'],
  'material/emphasis': [
    'facts',
    '/src/material/HatchingMaterialProperties.ts',
    '/src/material/FrameStamp.ts',
    '/src/material/pictureOffset.ts',
  ],
  'material/exposure': [
    'facts',
    '/src/engraving/surroundings.ts',
    '/src/material/HatchingMaterialProperties.ts',
    '/src/material/fitToneCurve.ts',
    '/src/material/FrameStamp.ts',
  ],
  'material/parts': [
    'facts',
    'shaders',
    'deformation',
    'exposure',
    '/src/engraving/constants',
    '/src/material/HatchingMaterialProperties.ts',
    '/src/material/fieldFrameName.ts',
    '/src/material/MeshUniforms.ts',
  ],
  'material/pictures': [],
  'material/firstDraw': ['facts', 'deformation', 'exposure', 'parts'],
  outlines: [
    'mistakes',
    'mesh/corners.ts',
    'features',
    'bake',
    'worker',
    'engraving',
    'tam/toothMap.ts',
    'geometry',
    'material',
    '/shaders',
  ],
  background: ['mistakes', 'bake', 'engraving/constants', 'material', '/shaders'],
  scene: [
    'mistakes',
    'slices',
    'strokes',
    'bake',
    'occlusion',
    'detail',
    'hatchImages',
    'worker',
    'tam',
    'geometry',
    'material',
    'outlines',
    'lighting',
  ],
  'scene/detail': ['/src/scene/MeshLook.ts', '/src/scene/surfaceMeshes.ts'],
  'scene/displacing': ['/src/scene/geometryPlans.ts', '/src/scene/surfaceMeshes.ts'],
  'scene/jointForms': [],
  'scene/making': [
    'jointForms',
    ...['displaceMeshes', 'geometryPlans', 'MaterialReplacer', 'planMeshes', 'wantedMap'].map(
      (name) => `/src/scene/${name}.ts`,
    ),
  ],
  'scene/occlusion': ['/src/scene/HatchedScene.ts'],
  'scene/outlining': ['/src/scene/MeshLook.ts', '/src/scene/surfaceMeshes.ts'],
  'scene/flattering': ['/src/scene/assertTree.ts', '/src/scene/surfaceMeshes.ts'],
  // No GLSL: neither the shaders nor what puts them together.
  webgpu: [
    ...['mistakes', 'slices', 'bake', 'worker', 'features', 'strokes', 'tam', 'geometry', 'engraving'],
    ...['material', 'outlines', 'scene'],
  ],
  'webgpu/nodes': [],
  'webgpu/nodes/base': [],
  'webgpu/nodes/shadowMaps': ['base'],
  'webgpu/nodes/perTriangle': ['base'],
  'webgpu/nodes/chunks': ['base', 'shadowMaps'],
  'webgpu/nodes/outlines': ['base', 'chunks', 'perTriangle'],
  'webgpu/nodes/perFragment': ['base', 'chunks'],
  'webgpu/nodes/techniques': [],
  'webgpu/nodes/techniques/anchored': [
    '/src/webgpu/nodes/base',
    '/src/webgpu/nodes/chunks',
    '/src/webgpu/nodes/perFragment',
  ],
  'webgpu/nodes/techniques/engraved': [
    '/src/webgpu/nodes/base',
    '/src/webgpu/nodes/chunks',
    '/src/webgpu/nodes/perFragment',
  ],
  'webgpu/deformation': ['nodes'],
  'webgpu/outlines': ['nodes', 'deformation'],
  svg: [
    ...['slices', 'features', 'bake', 'worker', 'mistakes', 'tam/stippleMap.ts', 'tam/patternSizes.ts', 'geometry'],
    ...['engraving', 'vector', 'material', 'outlines', 'background'],
  ],
  'index.ts': [
    'adjacency',
    'scan',
    'handTasks',
    'engraving',
    'hand',
    'strokes',
    'hatchImages',
    'mapFiles',
    'worker',
    'tam',
    'geometry',
    'material',
    'outlines',
    'background',
    'scene',
  ],
  'facts.ts': ['material', 'outlines', 'background', 'scene'],

  // Shared by the playground and the command. These import the library by its package name.
  files: [],
  'files/common': [],
  'files/archives': ['common'],
  'files/mesh': ['common'],
  'files/pictures': ['common'],
  'files/repair': ['common', 'mesh'],
  'files/ply': ['common', 'mesh'],
  'files/draco': ['common', 'mesh'],
  'files/off': ['common', 'mesh', 'ply'],
  'files/scenes': ['common', 'archives', 'mesh', 'pictures', 'repair'],
  'files/obj': ['common', 'mesh', 'scenes'],
  'files/stl': ['common', 'mesh', 'scenes'],
  'files/gltf': ['common', 'mesh', 'pictures', 'draco', 'scenes'],
  // The library's simplification is no part of its interface.
  'files/simplify': ['mesh', '/src/detail'],
  'files/moving': ['common', 'mesh', 'pictures', 'gltf'],
  // By its path, the library's presets are data for Node too: tests of the figures read them there. Its check of hands is no part of its interface.
  settings: ['scene/presets.ts', 'hand'],
  drawing: ['files', 'settings'],
  staging: ['files', 'settings', 'drawing'],

  // For Node: the presets are data.
  command: [
    '/package.json',
    'slices',
    'hand',
    'strokes',
    'hatchImages',
    'mapFiles',
    'scene/presets.ts',
    'svg/sheetSizes.ts',
    'files/common',
    'files/readingTime.ts',
  ],
  // What draws models imports the library by its package name, and three.js: it is loaded when it is asked for.
  // The library's rows of PNG, its sheets and what loads its simplifier are no part of its interface.
  'command/draw': [
    ...['/src/command', '/src/mapFiles/pngRows.ts', '/src/svg/sheetSizes.ts', '/src/detail/loadSimplifier.ts'],
    ...SHARED,
  ],

  // These import the library by its package name. The numbers by chance that strokes are placed by are no part of its interface.
  hands: ['strokes/random.ts'],
  react: [],
  element: [],
  demo: [],
  // The library's simplification is no part of its interface.
  'demo/files': ['/src/files', '/src/detail'],
  'demo/models': ['files', '/src/files', '/src/settings', '/src/drawing'],
  // The library's check of hands is no part of its interface.
  'demo/drawing': ['/src/files', '/src/settings', '/src/drawing', '/src/hand'],
  'demo/stage': [...SHARED, 'drawing'],
  'demo/stage/view': [],
  'demo/stage/light': ['view'],
  'demo/page': [],
  'demo/code': [...SHARED, 'files', 'models', 'stage', '/package.json'],
  'demo/kept': [...SHARED, 'files'],
  // The library's encoding of PNG and its sheets are no part of its interface.
  'demo/print': [...SHARED, 'stage', '/src/mapFiles/pngChunks.ts', '/src/svg/sheetSizes.ts'],
  'demo/video': [...SHARED, 'stage', 'print'],
  'demo/fetch': [],
  'demo/figures': [...SHARED, 'files', 'models', 'drawing', 'stage', 'page'],
  'demo/playground': [
    ...[...SHARED, 'files', 'models', 'drawing', 'stage', 'page'],
    ...['code', 'kept', 'print', 'video', 'fetch'],
  ],
  'demo/playground/elements': [],
  'demo/playground/tasks': [],
  'demo/playground/loading': ['elements', 'tasks'],
  'demo/playground/shelf': ['elements', 'tasks'],
  'demo/playground/session': ['elements', 'tasks', 'loading', 'shelf'],
  'demo/playground/overlay': ['elements', 'tasks', 'session'],
  'demo/playground/panel': ['elements', 'tasks', 'shelf', 'session'],
  'demo/playground/dialogs': ['elements', 'tasks', 'session'],
  'demo/playground/exports': ['elements', 'tasks', 'loading', 'session'],
  'demo/playground/hand': ['elements', 'tasks', 'loading', 'session', 'exports'],
};

/** Rooms that know no three.js. */
export const WITHOUT_THREE = [
  ...['slices', 'mesh', 'adjacency', 'normals', 'features', 'form', 'bake', 'occlusion', 'detail', 'lighting'],
  ...['hand', 'scan', 'strokes', 'hatchImages', 'mapFiles', 'worker', 'handTasks', 'command', 'engraving', 'vector'],
];
