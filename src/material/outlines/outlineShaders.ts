import type { Shaders } from '../shaders/hatchingShaders.js';
import { lightChunks } from '../shaders/lightKinds.js';
import { resolveIncludes } from '../shaders/resolveIncludes.js';
import { conventionsChunk } from '../shaders/shaderConventions.js';
import { toothConstantsChunk } from '../shaders/toothConstants.js';
import { outlineConventionsChunk } from './outlineConventions.js';

/** The shader files of outlines, and the chunks that they share with `HatchingMaterial`, as text. */
const files: Readonly<Record<string, string>> = import.meta.glob(
  [
    '../../../shaders/outlines/*',
    '../../../shaders/chunks/{emphasis,lightLuminance,lineCoverage,meanLight,normalDistribution,tooth}.glsl',
    '../../../shaders/perTriangle/turns.glsl',
  ],
  { query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of outlines. Their includes are resolved by the first call. */
export function outlineShaders(): Shaders {
  if (made) return made;
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    'outlines/conventions': outlineConventionsChunk(),
    toothConstants: toothConstantsChunk(),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    chunks[path.replace('../../../shaders/', '').replace('chunks/', '').replace('.glsl', '')] = text;
  }
  made = {
    vertexShader: resolveIncludes(chunks['outlines/outlines.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['outlines/outlines.frag'], chunks),
  };
  return made;
}
