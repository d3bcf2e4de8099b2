import { ShaderChunk } from 'three';

/**
 * The parts of three's chunk that are replaced, each with the file of shaders/shadowMaps that replaces it. Each part occurs in it once.
 */
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
 * three's shadow map functions with another filter. three rotates its samples by noise that is fixed to the screen, which in strokes
 * would be a ragged edge that crawls when the camera moves. Parts with other text are kept, as in versions before 0.182 and in chunks
 * that an application has replaced.
 */
export function shadowMapsChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  const steady = REPLACEMENTS.reduce((text, [pattern, name]) => text.replace(pattern, included(name)), source);
  if (steady === source) return source;
  return `#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)${included('steadyKernel')}#endif\n${steady}`;
}

/**
 * How depth is read from shadow maps: this depends on the installed three.js, and on the type of the maps, which it defines when it
 * compiles. Versions before 0.182 pack depths, and lay out the cubes of point lights flat: for these no depth is read.
 */
export function shadowDepthChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  const isPacked = source.includes('unpackRGBAToDepth');
  const types = isPacked
    ? `#ifdef SHADOWMAP_TYPE_VSM
#define SHADOW_MOMENTS(texel) unpackRGBATo2Half(texel)
#else
#define SHADOW_DEPTH(texel) unpackRGBAToDepth(texel)
#endif`
    : `#ifdef SHADOWMAP_TYPE_VSM
#define SHADOW_MOMENTS(texel) texel.rg
#else
#define SHADOW_DEPTH(texel) texel.r
#endif
#ifdef SHADOWMAP_TYPE_PCF
#define SHADOW_MAPS_COMPARE
#define CUBE_SHADOW_MAP samplerCubeShadow
#elif defined(SHADOWMAP_TYPE_BASIC)
#define CUBE_SHADOW_MAP samplerCube
#endif`;
  return `${types}${included('depth')}`;
}

const included = (name: string): string => `\n#include "shadowMaps/${name}"\n`;
