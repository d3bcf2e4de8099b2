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
  strokes: [],
  hatchImages: ['slices', 'strokes'],
  mapFiles: ['strokes', 'hatchImages'],
  worker: ['slices', 'features', 'form', 'bake', 'occlusion', 'hatchImages'],

  // With three.js.
  mistakes: [],
  tam: ['mistakes', 'strokes', 'hatchImages', 'mapFiles', 'worker'],
  'material/facts': [],
  geometry: ['mistakes', 'mesh', 'adjacency', 'features', 'form', 'bake', 'worker', 'material/facts'],
  material: ['mistakes', 'strokes', 'bake', 'tam', 'geometry', '/shaders'],
  'material/shaders': ['facts'],
  'material/deformation': ['shaders'],
  'material/parts': [
    'facts',
    'shaders',
    'deformation',
    '/src/material/HatchingMaterialProperties.ts',
    '/src/material/fieldFrameName.ts',
  ],
  'material/firstDraw': ['facts', 'deformation', 'parts'],
  outlines: ['mistakes', 'features', 'bake', 'worker', 'tam/toothMap.ts', 'geometry', 'material', '/shaders'],
  scene: [
    'mistakes',
    'slices',
    'strokes',
    'bake',
    'occlusion',
    'hatchImages',
    'worker',
    'tam',
    'geometry',
    'material',
    'outlines',
  ],
  'scene/jointForms': [],
  'index.ts': [
    'adjacency',
    'strokes',
    'hatchImages',
    'mapFiles',
    'worker',
    'tam',
    'geometry',
    'material',
    'outlines',
    'scene',
  ],
  'facts.ts': ['material', 'outlines', 'scene'],

  // For Node: the presets are data.
  command: ['slices', 'strokes', 'hatchImages', 'mapFiles', 'scene/presets.ts'],

  // These import the library by its package name.
  react: [],
  element: [],
  demo: [],
  'demo/files': [],
  'demo/files/common': [],
  'demo/files/archives': ['common'],
  'demo/files/mesh': ['common'],
  'demo/files/pictures': ['common'],
  'demo/files/repair': ['common', 'mesh'],
  'demo/files/ply': ['common', 'mesh'],
  'demo/files/draco': ['common', 'mesh'],
  'demo/files/scenes': ['common', 'mesh', 'pictures', 'repair'],
  'demo/files/obj': ['common', 'mesh', 'scenes'],
  'demo/files/stl': ['common', 'mesh', 'scenes'],
  'demo/files/gltf': ['common', 'mesh', 'pictures', 'draco', 'scenes'],
  'demo/files/moving': ['common', 'pictures', 'gltf'],
  'demo/models': ['files'],
  // By its path, the library's presets are data for Node too: tests of the figures read them there.
  'demo/settings': ['models', '/src/scene/presets.ts'],
  'demo/drawing': ['files', 'models', 'settings'],
  'demo/stage': ['files', 'models', 'settings', 'drawing'],
  'demo/stage/view': [],
  'demo/stage/light': ['view'],
  'demo/page': [],
  'demo/code': ['files', 'models', 'settings', 'stage', '/package.json'],
  'demo/kept': ['files', 'settings'],
  // The library's encoding of PNG is no part of its interface.
  'demo/print': ['settings', 'stage', '/src/mapFiles/pngChunks.ts'],
  'demo/video': ['settings', 'stage', 'print'],
  'demo/fetch': [],
  'demo/figures': ['files', 'models', 'settings', 'drawing', 'stage', 'page'],
  'demo/playground': [
    ...['files', 'models', 'settings', 'drawing', 'stage', 'page'],
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
  'demo/playground/takeAway': ['elements', 'tasks', 'loading', 'session'],
};

/** Rooms that know no three.js. */
export const WITHOUT_THREE = [
  ...['slices', 'mesh', 'adjacency', 'normals', 'features', 'form', 'bake', 'occlusion'],
  ...['strokes', 'hatchImages', 'mapFiles', 'worker', 'command'],
];
