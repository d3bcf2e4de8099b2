import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { familyOf } from '../../look/presetParameters.js';
import { packingChunk } from '../three/chunks.js';
import { environmentLayout } from '../three/environments.js';
import { lightChunks, shadowChunks } from '../three/lightKinds.js';
import { shadowDepthChunk, shadowMapsChunk } from '../three/shadowMaps.js';
import { conventionsChunk, cornerAttributesChunk, mapTransformsChunk } from './shaderConventions.js';
import { resolveIncludes } from './shaderText.js';

/** The sources of a program's two stages. The library's includes are resolved; three.js resolves its own when it compiles. */
export interface Shaders {
  vertexShader: string;
  fragmentShader: string;
}

/** The sources of files in shaders/, by their paths there. */
export type ShaderFiles = Readonly<Record<string, string>>;

/** The files that every material needs. `parts` holds those of others. */
const files: ShaderFiles = import.meta.glob(
  [
    './hatching.*',
    './{chunks,environment,shadowMaps}/*',
    '!./chunks/{dryMedia,tooth,handStrokes,handShadowStrokes,strokeShadows,lineCoverage,meanLight,metal,softShadows,shadowSearch}.glsl',
    '!./chunks/{ink,largestComponents,levelByDepth,lightOrientation,thresholdMap}.glsl',
    './perFragment/*',
    '!./perFragment/screenGradient.glsl',
  ],
  { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
);

/** Chunks of techniques and of shadows on a ground, included by name, that are empty without them. */
const ABSENT: Readonly<Record<string, string>> = {
  dryMedia: '',
  softShadows: '',
  strokeShadows: '',
  'technique/stipple': '',
  'technique/carving': '',
  'technique/steadiness': '',
};

// Shaders are resolved on first use, so that a page that never hatches does no work, and a bundler may leave this out.
const made = new Map<ShaderFiles, Partial<Record<TechniqueFolder, Shaders>>>();

/**
 * The shaders of a technique.
 *
 * @param further the files of the part that the technique needs, and of the kind of material
 */
export function hatchingShaders(technique: HatchingTechnique, further: ShaderFiles): Shaders {
  const folder = folderOf(technique);
  const known = made.get(further) ?? {};
  made.set(further, known);
  known[folder] ??= shadersOf(folder, { ...files, ...further });
  return known[folder];
}

/** A folder of shaders/techniques: that of a family, or of one of the two techniques per triangle. */
type TechniqueFolder = ReturnType<typeof folderOf>;

function folderOf(technique: HatchingTechnique) {
  const family = familyOf(technique);
  return family === 'perTriangle' ? (technique as 'triangle' | 'adjacency') : family;
}

function shadersOf(folder: TechniqueFolder, all: ShaderFiles): Shaders {
  const chunks = { ...ABSENT, ...sharedChunks(), ...namedChunks(all, folder) };
  chunks['environment/layout'] = chunks[`environment/${environmentLayout() ?? 'cube'}`];
  return {
    vertexShader: resolveIncludes(chunks['hatching.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['hatching.frag'], chunks),
  };
}

/** The chunks that depend on TypeScript constants and on the installed three.js. */
const sharedChunks = (): Record<string, string> => ({
  conventions: conventionsChunk(),
  cornerAttributes: cornerAttributesChunk(),
  mapTransforms: mapTransformsChunk(),
  packing: packingChunk(),
  shadowMaps: shadowMapsChunk(),
  shadowDepth: shadowDepthChunk(),
  ...shadowChunks(),
  ...lightChunks(),
});

/**
 * Chunks by the names they are included by: `tone` for chunks/tone.glsl, `technique/read` for techniques/<folder>/read.glsl. A folder that
 * lacks a file has that of all techniques per triangle or per fragment, which come before it in the alphabet.
 */
function namedChunks(files: ShaderFiles, folder: TechniqueFolder): Record<string, string> {
  const common = folder === 'strokes' || folder === 'lines' ? 'perFragment' : 'perTriangle';
  const named: Record<string, string> = {};
  for (const [path, text] of Object.entries(files)) {
    const name = path.slice(2).replace('chunks/', '').replace('.glsl', '');
    named[name] = named[name.replace(common, 'technique').replace(`techniques/${folder}`, 'technique')] = text;
  }
  return named;
}
