import { BACKGROUND_CONSTANTS } from '../look/constants/backgroundConstants.js';
import { LOT_FACTORS } from '../look/constants/lotConstants.js';
import { definesOf } from './shaders/definesOf.js';
import type { Shaders } from './shaders/hatchingShaders.js';
import { lightChunks } from './shaders/lightKinds.js';
import { resolveIncludes } from './shaders/resolveIncludes.js';
import { conventionsChunk } from './shaders/shaderConventions.js';

/** The shader files of backgrounds, and the chunks that they share with materials, as text. */
const files: Readonly<Record<string, string>> = import.meta.glob(
  ['../../shaders/background/*', '../../shaders/chunks/{lightLuminance,lineCoverage,meanLight}.glsl'],
  { query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of backgrounds. Their includes are resolved by the first call. */
export function backgroundShaders(): Shaders {
  if (made) return made;
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    'background/constants': [definesOf(BACKGROUND_CONSTANTS), definesOf(LOT_FACTORS, 'u')].join('\n'),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    chunks[path.replace('../../shaders/', '').replace('chunks/', '').replace('.glsl', '')] = text;
  }
  made = {
    vertexShader: resolveIncludes(chunks['background/background.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['background/background.frag'], chunks),
  };
  return made;
}
