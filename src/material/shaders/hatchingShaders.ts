import { ShaderLib } from 'three';
import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { lightChunks, shadowChunks } from './lightKinds.js';
import { resolveIncludes } from './resolveIncludes.js';
import {
  conventionsChunk,
  cornerAttributesChunk,
  environmentLayout,
  mapTransformsChunk,
  packingChunk,
} from './shaderConventions.js';
import { shadowDepthChunk, shadowMapsChunk } from './shadowMaps.js';

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
const ABSENT = { dryMedium: '', 'technique/stipple': '' };

// Shaders are resolved on first use, so that a page that never hatches does no work, and a bundler may leave this out.
const made = new Map<HatchingTechnique, Map<ShaderFiles, Shaders>>();
const NONE: ShaderFiles = {};

/**
 * The shaders of a technique.
 *
 * @param further the files of the part that the technique or the medium needs
 */
export function hatchingShaders(technique: HatchingTechnique, further = NONE): Shaders {
  const known = made.get(technique) ?? new Map<ShaderFiles, Shaders>();
  made.set(technique, known);
  let shaders = known.get(further);
  if (!shaders) {
    const chunks: Record<string, string> = {
      ...ABSENT,
      ...sharedChunks(),
      ...namedChunks({ ...files, ...further }, technique),
    };
    chunks['environment/layout'] = chunks[`environment/${environmentLayout()}`];
    shaders = {
      vertexShader: resolveIncludes(chunks['hatching.vert'], chunks),
      fragmentShader: resolveIncludes(chunks['hatching.frag'], chunks),
    };
    known.set(further, shaders);
  }
  return shaders;
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

/** Chunks by the names they are included by: `tone` for chunks/tone.glsl, `technique/read` for techniques/<technique>/read.glsl. */
const namedChunks = (files: ShaderFiles, technique: HatchingTechnique): Record<string, string> =>
  Object.fromEntries(
    Object.entries(files).map(([path, text]) => [
      path
        .replace('./', '')
        .replace(`techniques/${technique}/`, 'technique/')
        .replace('chunks/', '')
        .replace('.glsl', ''),
      text,
    ]),
  );
