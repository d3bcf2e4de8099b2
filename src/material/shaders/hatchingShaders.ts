import { ShaderLib } from 'three';
import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { needsAdjacency } from '../../look/queries.js';
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
    './{hatching,plain}.*',
    './{chunks,environment,shadowMaps}/*',
    '!./chunks/{dryMedium,tooth,lineCoverage,meanLight}.glsl',
    './perFragment/*',
    '!./perFragment/screenGradient.glsl',
    './techniques/anchored/*',
    '!./techniques/anchored/{stipple,dots}.glsl',
  ],
  { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
);

/** Chunks of media, included by name, that are empty with other media. */
const ABSENT: Readonly<Record<string, string>> = { dryMedium: '', 'technique/stipple': '' };

// Shaders are resolved on first use, so that a page that never hatches does no work, and a bundler may leave this out.
const made = new Map<ShaderFiles, Partial<Record<HatchingTechnique, Shaders>>>();
const NONE: ShaderFiles = {};

/**
 * The shaders of a technique.
 *
 * @param further the files of the part that the technique or the medium needs
 */
export function hatchingShaders(technique: HatchingTechnique, further = NONE): Shaders {
  const known = made.get(further) ?? {};
  made.set(further, known);
  known[technique] ??= shadersOf(technique, { ...files, ...further });
  return known[technique];
}

function shadersOf(technique: HatchingTechnique, all: ShaderFiles): Shaders {
  const chunks = { ...ABSENT, ...sharedChunks(), ...namedChunks(all, technique) };
  chunks['environment/layout'] = chunks[`environment/${environmentLayout() ?? 'cube'}`];
  return {
    vertexShader: resolveIncludes(chunks['hatching.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['hatching.frag'], chunks),
  };
}

/** The shaders of plain paper, drawn while the code of a technique loads. */
export const plainShaders = (): Shaders => ({
  vertexShader: ShaderLib.basic.vertexShader,
  fragmentShader: files['./plain.frag'],
});

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
 * Chunks by the names they are included by: `tone` for chunks/tone.glsl, `technique/read` for techniques/<technique>/read.glsl. A technique
 * that lacks a file has that of all techniques per triangle or per fragment, which come before it in the alphabet.
 */
function namedChunks(files: ShaderFiles, technique: HatchingTechnique): Record<string, string> {
  const common = needsAdjacency({ technique }) ? 'perTriangle' : 'perFragment';
  const named: Record<string, string> = {};
  for (const [path, text] of Object.entries(files)) {
    const name = path.slice(2).replace('chunks/', '').replace('.glsl', '');
    named[name] = named[name.replace(common, 'technique').replace(`techniques/${technique}`, 'technique')] = text;
  }
  return named;
}
