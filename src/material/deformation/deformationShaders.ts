import type { ShaderFiles, Shaders } from '../shaders/hatchingShaders.js';
import { resolveIncludes } from '../shaders/resolveIncludes.js';

const files: ShaderFiles = import.meta.glob(
  ['./deformation.*', './perTriangle/{pulledVertices,turns}.glsl', './chunks/deformVertex.glsl'],
  { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of the pre-pass that deforms vertices. Their includes are resolved by the first call. */
export function deformationShaders(): Shaders {
  if (made) return made;
  const chunks = Object.fromEntries(
    Object.entries(files).map(([path, text]) => [
      path.replace('./', '').replace('chunks/', '').replace('.glsl', ''),
      text,
    ]),
  );
  made = {
    vertexShader: resolveIncludes(chunks['deformation.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['deformation.frag'], chunks),
  };
  return made;
}
