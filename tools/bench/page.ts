import { HatchingMaterial } from 'three-hatching';

/** The page that measures: loads what one benchmark needs, and nothing else. */
const measures = {
  frames: async () => (await import('./frame/measureFrames.js')).measureFrames,
  nodes: async () => (await import('./nodes/measureNodes.js')).measureNodes,
  describeAdapter: async () => (await import('./nodes/describeAdapter.js')).describeAdapter,
  lookNames: async () => (await import('./presets/lookOptions.js')).lookNames,
  presets: async () => (await import('./presets/measurePresets.js')).measurePresets,
  game: async () => (await import('./presets/measureGame.js')).measureGame,
  detail: async () => (await import('./detail/measureDetail.js')).measureDetail,
  lines: async () => (await import('./lines/measureLines.js')).measureLines,
  many: async () => (await import('./many/measureMany.js')).measureMany,
  manyFrames: async () => (await import('./many/measureMany.js')).drawMany,
  media: async () => (await import('./media/measureMedia.js')).measureMedia,
  occlusion: async () => (await import('./occlusion/measureOcclusion.js')).measureOcclusion,
  lineFields: async () => (await import('./lineFields/measureLineFields.js')).measureLineFields,
  shadows: async () => (await import('./shadows/measureShadows.js')).measureShadows,
  bake: async () => (await import('./bake/measureBake.js')).measureBake,
  wholeBake: async () => (await import('./bake/measureWholeBake.js')).measureWholeBake,
  form: async () => (await import('./form/measureForm.js')).measureForm,
  firstPicture: async () => (await import('./firstPicture/measureFirstPicture.js')).measureFirstPicture,
  upload: async () => (await import('./upload/measureUpload.js')).measureUpload,
  memory: async () => (await import('./memory/measureMemory.js')).measureMemory,
  memoryFrames: async () => (await import('./memory/measureMemory.js')).drawFrames,
  vector: async () => (await import('./vector/measureVector.js')).measureVector,
  map: async () => (await import('./tam/measureMap.js')).measureMap,
  comparedFrames: async () => (await import('./compare/compareFrames.js')).compareFrames,
  comparedLooks: async () => (await import('./compare/compareLooks.js')).compareLooks,
  comparedSurfaces: async () => (await import('./compare/compareSurfaces.js')).compareSurfaces,
  comparedBakes: async () => (await import('./compare/compareBakes.js')).compareBakes,
  comparedMaps: async () => (await import('./compare/compareMaps.js')).compareMaps,
};

async function measure(name: keyof typeof measures, ...args: unknown[]): Promise<unknown> {
  await HatchingMaterial.preload();
  const run = (await measures[name]()) as (...args: unknown[]) => unknown;
  return run(...args);
}

Object.assign(window, { measure });
