import type { Shaders } from '../material/shaders/hatchingShaders.js';
import { lightChunks } from '../material/shaders/lightKinds.js';
import { resolveIncludes } from '../material/shaders/resolveIncludes.js';
import { conventionsChunk } from '../material/shaders/shaderConventions.js';
import { lineConventionsChunk } from './lineConventions.js';

/** The shader files of lines, and the chunks that they share with `HatchingMaterial`, as text. */
const files: Readonly<Record<string, string>> = import.meta.glob(
  [
    '../../shaders/lines/*',
    '../../shaders/chunks/{lightLuminance,lineCoverage,normalDistribution,tooth}.glsl',
    '../../shaders/perTriangle/turns.glsl',
  ],
  { query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of lines. Their includes are resolved by the first call. */
export function lineShaders(): Shaders {
  if (made) return made;
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    'lines/conventions': lineConventionsChunk(),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    chunks[path.replace('../../shaders/', '').replace('chunks/', '').replace('.glsl', '')] = text;
  }
  made = {
    vertexShader: resolveIncludes(chunks['lines/lines.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['lines/lines.frag'], chunks),
  };
  return made;
}
