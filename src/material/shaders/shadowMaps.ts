import { ShaderChunk } from 'three';

/** The parts of three's chunk that are replaced, and the file of shaders/shadowMaps that replaces each. Each part stands in it once. */
const REPLACEMENTS: readonly (readonly [RegExp, string])[] = [
  [
    /float phi = interleavedGradientNoise\([^;]*;[^\n]*\s*shadow = \(\s*texture\( shadowMap, vec3\([^;]*\) \* 0\.2;/,
    'steadyFlat',
  ],
  [/float phi = interleavedGradientNoise\([^;]*;[^#]*?bd3D[^#]*?\*=? 0\.2;/, 'steadyCube'],
  [
    /float depth = texture2D\( shadowMap, shadowCoord\.xy \)\.r;\s*#ifdef USE_REVERSED_DEPTH_BUFFER\s*shadow = step\( depth, shadowCoord\.z \);\s*#else\s*shadow = step\( shadowCoord\.z, depth \);\s*#endif/,
    'bilinearFlat',
  ],
  [
    /float depth = textureCube\( shadowMap, bd3D \)\.r;\s*#ifdef USE_REVERSED_DEPTH_BUFFER\s*depth = 1\.0 - depth;\s*#endif\s*shadow = step\( dp, depth \);/,
    'bilinearCube',
  ],
];

/**
 * three's own functions of shadow maps with another filter. three rotates its samples by noise that is fixed to the screen, which
 * strokes would show as a ragged edge that crawls under a moving camera. Parts that are written otherwise stay as they are, as in versions
 * before 0.182 and in chunks that an application has replaced.
 */
export function shadowMapsChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  const steady = REPLACEMENTS.reduce((text, [pattern, name]) => text.replace(pattern, included(name)), source);
  if (steady === source) return source;
  return `#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)${included('steadyKernel')}#endif\n${steady}`;
}

const included = (name: string): string => `\n#include "shadowMaps/${name}"\n`;
