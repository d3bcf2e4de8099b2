/** Known in three.js 0.170 to 0.187: its filter of shadow maps, and how they store depth. */
import { ShaderChunk } from 'three';
import { expectChunk } from './chunks.js';

/**
 * The parts of three's chunk that are replaced, each with the file of shaders/shadowMaps that replaces it, and what 0.182 has there
 * instead. Each part occurs once.
 */
const REPLACEMENTS: readonly (readonly [RegExp, file: string, kept?: RegExp])[] = [
  [/float phi = interleavedGradientNoise\([^;]*;[^\n]*\s*shadow = \([^;]*?vec3\([^;]*\) \* 0\.2;/, 'steadyFlat'],
  [/float phi = interleavedGradientNoise\([^;]*;[^#]*?bd3D[^#]*?\*=? 0\.2;/, 'steadyCube'],
  [
    /float depth = texture2D\( shadowMap, shadowCoord\.xy \)\.r;[^;]*;[^;]*step\( shadowCoord\.z, depth \);\s*#endif/,
    'bilinearFlat',
  ],
  [
    /float depth = textureCube\( shadowMap, bd3D \)\.r;[^(]*step\( dp, depth \);/,
    'bilinearCube',
    /step\( depth, dp \)/,
  ],
];

/** Where a cascade is read, off the surface along its normal: on the side that is seen, as `turnedShadows` does for other maps. */
const OFF_SURFACE = 'vSunShadowWorldNormal * sunLightShadow.shadowNormalBias';
const ON_SEEN_SIDE = `
#ifdef DOUBLE_SIDED
(gl_FrontFacing ? 1.0 : -1.0) *
#endif
`;

/**
 * three's shadow map functions with another filter. three rotates its samples by noise that is fixed to the screen, which in strokes
 * would be a ragged edge that crawls when the camera moves. Parts with other text are kept, as in versions before 0.182, which pack
 * depth, and in chunks that an application has replaced.
 */
export function shadowMapsChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  if (isPacked(source)) return source;
  let steady = source;
  for (const [pattern, name, kept = pattern] of REPLACEMENTS) {
    expectChunk('shadowmap_pars_fragment', pattern.test(source) || kept.test(source));
    steady = steady.replace(pattern, included(name));
  }
  if (steady === source) return source;
  expectChunk('shadowmap_pars_fragment', source.includes(OFF_SURFACE) === source.includes('SunLightShadow'));
  steady = steady.replace(OFF_SURFACE, ON_SEEN_SIDE + OFF_SURFACE);
  return `#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)${included('steadyKernel')}#endif\n${steady}`;
}

const isPacked = (source: string): boolean => source.includes('unpackRGBAToDepth');

/**
 * How depth is read from shadow maps: this depends on the installed three.js, and on the type of the maps, which it defines when it
 * compiles. Versions before 0.182 pack depths, and lay out the cubes of point lights flat: for these no depth is read.
 */
export function shadowDepthChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  const packed = isPacked(source);
  const comparison = `
#ifdef SHADOWMAP_TYPE_PCF
#define SHADOW_MAPS_COMPARE
#define CUBE_SHADOW_MAP samplerCubeShadow
#elif defined(SHADOWMAP_TYPE_BASIC)
#define CUBE_SHADOW_MAP samplerCube
#endif`;
  return `#ifdef SHADOWMAP_TYPE_VSM
#define SHADOW_MOMENTS(texel) ${packed ? 'unpackRGBATo2Half(texel)' : 'texel.rg'}
#else
#define SHADOW_DEPTH(texel) ${packed ? 'unpackRGBAToDepth(texel)' : 'texel.r'}
#endif${packed ? '' : comparison}${included('depth')}`;
}

const included = (name: string): string => `\n#include "shadowMaps/${name}"\n`;
