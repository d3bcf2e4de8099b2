import { readFileSync } from 'node:fs';
import { ShaderChunk } from 'three';
import { describe, expect, test } from 'vitest';
import { resolveIncludes } from '../../../../src/material/shaders/shaderText.js';
import { shadowDepthChunk, shadowMapsChunk } from '../../../../src/material/three/shadowMaps.js';

const chunkOf = (version: string) => {
  const file = readFileSync(
    `node_modules/${version}/src/renderers/shaders/ShaderChunk/shadowmap_pars_fragment.glsl.js`,
    'utf8',
  );
  return /`([\s\S]*)`/.exec(file)![1];
};

const names = ['steadyKernel', 'steadyFlat', 'steadyCube', 'bilinearFlat', 'bilinearCube'];
const files = Object.fromEntries(
  names.map((name) => [`shadowMaps/${name}`, readFileSync(`shaders/shadowMaps/${name}.glsl`, 'utf8')]),
);
const steadyOf = (source?: string) => resolveIncludes(shadowMapsChunk(source), files);

/** The bodies of the functions with a name, each from its head to the next function or the end. */
const bodiesOf = (name: string, chunk: string) =>
  chunk.split(/^\s*(?=(?:float|vec2|int) \w+\()/m).filter((part) => new RegExp(`^float ${name}\\(`).test(part));

describe('the filter of shadow maps', () => {
  const steady = steadyOf();

  test("is ours in the place of three's noise, flat and cube, and blends where three does not", () => {
    const [comparing, moments, basic] = bodiesOf('getShadow', steady);
    expect(comparing).toMatch(/tentWeight\(x, y, n\) \* texture\(shadowMap, vec3/);
    expect(moments).toContain('p_max');
    expect(basic).toMatch(/mix\(mix\(lit\.x, lit\.y/);
    const [comparingCube, basicCube] = bodiesOf('getPointShadow', steady);
    expect(comparingCube).toMatch(/tentWeight\(x, y, n\) \* texture\(shadowMap, vec4/);
    expect(basicCube).toMatch(/mix\(mix\(lit\.x, lit\.y/);
    // All that remains of the noise is its definition.
    expect(steady.match(/interleavedGradientNoise|gl_FragCoord/g)).toEqual(['interleavedGradientNoise']);
    expect(steady).not.toMatch(/vogelDiskSample\( \d/);
  });

  test("leaves three's other text as it is, and three's chunks untouched", () => {
    const before = ShaderChunk.shadowmap_pars_fragment;
    shadowMapsChunk();
    expect(ShaderChunk.shadowmap_pars_fragment).toBe(before);
    expect(before).toContain('interleavedGradientNoise( gl_FragCoord.xy )');
    const heads = /(?:float|vec2) get\w*Shadow\([^{]*\{/g;
    expect(steady.match(heads)).toEqual(before.match(heads));
    const uniforms = /^\s*(?:uniform|varying|struct).*$/gm;
    expect(steady.match(uniforms)).toEqual(before.match(uniforms));
  });

  test('finds the filter as versions from 0.182 on word it', () => {
    const sums = (arguments_: (i: number) => string) =>
      [0, 1, 2, 3, 4].map((i) => `texture( shadowMap, ${arguments_(i)} )`).join(' +\n');
    const flat = `float phi = interleavedGradientNoise( gl_FragCoord.xy ) * 6.28318530718; // 2*PI

      shadow = (
        ${sums((i) => `vec3( shadowCoord.xy + vogelDiskSample( ${i}, 5, phi ) * radius, shadowCoord.z )`)}
      ) * 0.2;`;
    const direction = (i: number) =>
      `( tangent * vogelDiskSample( ${i}, 5, phi ).x + bitangent * vogelDiskSample( ${i}, 5, phi ).y ) * texelSize`;
    const cube = `float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;

      shadow = (
        ${sums((i) => `vec4( bd3D + ${direction(i)}, dp )`)}
      ) * 0.2;`;
    for (const [name, text, ours] of [
      ['flat', flat, 'vec3(shadowCoord.xy + vec2(x, y) * away'],
      ['cube', cube, 'vec4(direction, depth)'],
    ]) {
      const found = steadyOf(`float shadow = 1.0;\n${text}\nreturn shadow;`);
      expect(found, name).toContain(ours);
      expect(found, name).toMatch(/float shadow = 1\.0;[\s\S]*return shadow;$/);
      expect(found, name).not.toContain('interleavedGradientNoise');
    }
  });

  test.each(['three-oldest', 'three-middle'])('of %s, whose depth is packed, stays', (version) => {
    const theirs = chunkOf(version);
    expect(theirs).toContain('unpackRGBAToDepth');
    expect(shadowMapsChunk(theirs)).toBe(theirs);
  });

  test('depths are told as each version stores them', () => {
    for (const version of ['three-oldest', 'three-middle']) {
      const packed = shadowDepthChunk(chunkOf(version));
      expect(packed).toContain('unpackRGBAToDepth(texel)');
      expect(packed).not.toMatch(/#define (SHADOW_MAPS_COMPARE|CUBE_SHADOW_MAP)/);
    }
    const present = shadowDepthChunk(chunkOf('three'));
    expect(present).toMatch(/#ifdef SHADOWMAP_TYPE_PCF\n#define SHADOW_MAPS_COMPARE/);
    expect(present).not.toContain('unpack');
  });

  test('that someone has put in place of three’s stays', () => {
    const foreign = 'float getShadow( sampler2D map ) { return texture2D( map, vec2( 0.5 ) ).r; }';
    expect(shadowMapsChunk(foreign)).toBe(foreign);
  });
});
