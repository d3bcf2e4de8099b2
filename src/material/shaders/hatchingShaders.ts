import type { HatchingTechnique } from '../facts/hatchingProperties.js';
import { environmentLayout } from './environmentLayout.js';
import { lightChunks } from './lightKinds.js';
import { resolveIncludes } from './resolveIncludes.js';
import { conventionsChunk, cornerAttributesChunk, mapTransformsChunk, packingChunk } from './shaderConventions.js';
import { shadowMapsChunk } from './shadowMaps.js';

/** The text of a program's two stages. Our includes are resolved; three resolves its own when it compiles. */
export interface Shaders {
  vertexShader: string;
  fragmentShader: string;
}

/** Every file of shaders/ but those of outlines, as text. */
const files: Readonly<Record<string, string>> = import.meta.glob(['./**', '!./outlines/**'], {
  base: '../../../shaders',
  query: '?raw',
  import: 'default',
  eager: true,
});

// Shaders are resolved when first asked for, so that a page that never hatches does not pay, and a bundler may leave this out.
const made = new Map<string, Shaders>();

/** The shaders of a technique. */
export const hatchingShaders = (technique: HatchingTechnique): Shaders => shadersFrom('hatching', technique);

/** The shaders of the pre-pass that deforms vertices. */
export const deformationShaders = (): Shaders => shadersFrom('deformation');

function shadersFrom(name: string, technique?: HatchingTechnique): Shaders {
  const key = `${name} ${technique}`;
  let shaders = made.get(key);
  if (!shaders) {
    const chunks = chunksFor(technique);
    shaders = {
      vertexShader: resolveIncludes(files[`./${name}.vert`], chunks),
      fragmentShader: resolveIncludes(files[`./${name}.frag`], chunks),
    };
    made.set(key, shaders);
  }
  return shaders;
}

/** Chunks by the names they are included by: `tone` for chunks/tone.glsl, `technique/read` for techniques/<technique>/read.glsl. */
function chunksFor(technique?: HatchingTechnique): Record<string, string> {
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    cornerAttributes: cornerAttributesChunk(),
    mapTransforms: mapTransformsChunk(),
    packing: packingChunk(),
    shadowMaps: shadowMapsChunk(),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    const name = path
      .replace('./', '')
      .replace(`techniques/${technique}/`, 'technique/')
      .replace('chunks/', '')
      .replace('.glsl', '');
    // Chunks of other techniques are left out.
    if (!name.startsWith('techniques/')) chunks[name] = text;
  }
  chunks['environment/layout'] = chunks[`environment/${environmentLayout()}`];
  return chunks;
}
