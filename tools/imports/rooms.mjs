/**
 * The rooms of `src`, lowest first, and which others each may import; inside of a room files import each other as they please. What begins
 * with `/` lies in the project's root. `offers.mjs` has the files of each room that others may import.
 *
 * @type {Readonly<Record<string, readonly string[]>>}
 */
export const ROOMS = {
  // Pure: typed arrays and plain data in and out, no three.js.
  mesh: [],
  strokes: ['mesh'],
  worker: ['mesh', 'strokes'],
  look: [],

  // The library, with three.js.
  material: ['mesh', 'strokes', 'worker', 'look', '/shaders'],
  scene: ['mesh', 'strokes', 'worker', 'look', 'material'],
  vector: ['mesh', 'strokes', 'worker', 'look', 'material'],
  webgpu: ['mesh', 'strokes', 'look', 'material', 'scene'],
  'index.ts': ['mesh', 'strokes', 'worker', 'look', 'material', 'scene'],
  'development.ts': ['material', 'index.ts'],
  'facts.ts': ['look', 'material', 'scene'],

  // These import the library by its package name, as users do; their other imports are no part of its interface.
  react: [],
  element: [],
  viewer: ['mesh', 'strokes', 'scene'],
  command: ['mesh', 'strokes', 'scene', 'vector', 'viewer', '/package.json'],
  playground: ['mesh', 'strokes', 'vector', 'viewer', '/package.json'],
};

/** Folders that know no three.js, and those within that do. */
export const WITHOUT_THREE = ['mesh', 'strokes', 'worker', 'look', 'vector', 'command'];
export const WITH_THREE = ['vector/svg', 'command/draw'];
