import { readdirSync, readFileSync } from 'node:fs';
import { ShaderChunk } from 'three';
import { afterEach, describe, expect, test } from 'vitest';
import { lightChunks, lightCountDefines, shadowChunks } from '../../../../src/material/three/lightKinds.js';

const { lights_pars_begin } = ShaderChunk;

afterEach(() => {
  ShaderChunk.lights_pars_begin = lights_pars_begin;
});

/** The pattern by which three.js finds loops to unroll, after it has replaced counts by numbers. */
const UNROLLED =
  /#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;

const visited = (chunk: string): string[] =>
  [...chunk.matchAll(/VISIT_LIGHT\((\w+)\[i\]/g)].map(([, lights]) => lights);

describe('the walks over lights', () => {
  test('no other file names a kind of light', () => {
    const files = readdirSync('shaders', { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map(({ parentPath, name }) => `${parentPath}/${name}`);
    expect(files.length).toBeGreaterThan(50);
    for (const path of files) {
      expect(readFileSync(path, 'utf8'), path).not.toMatch(
        /NUM_\w+_LIGHTS|\b(point|spot|sun|directional|hemisphere|rectArea)Lights\b|get\w+(LightInfo|Shadow)\(/,
      );
    }
  });

  test('meet every kind that has a direction once, distant ones first', () => {
    const { eachLight, eachDistantLight, eachPositionalLight, eachSky } = lightChunks();
    expect(visited(eachDistantLight)).toEqual(['sunLights', 'directionalLights']);
    expect(visited(eachPositionalLight)).toEqual(['pointLights', 'spotLights']);
    expect(visited(eachLight)).toEqual([...visited(eachDistantLight), ...visited(eachPositionalLight)]);
    expect(visited(eachSky)).toEqual(['hemisphereLights']);
  });

  test("number lights as three's own walk meets them", () => {
    const { lights_fragment_begin } = ShaderChunk;
    const counts = [...lights_fragment_begin.matchAll(/i < (NUM_(?!RECT|HEMI)\w+_LIGHTS)\b/g)].map(
      ([, count]) => count,
    );
    expect(counts).toHaveLength(4);
    const { eachLight } = lightChunks();
    for (const [index, count] of counts.entries()) {
      const number = [...counts.slice(0, index), 'UNROLLED_LOOP_INDEX'].join(' + ');
      expect(eachLight).toMatch(new RegExp(`i < ${count};[^}]*, ${number.replaceAll('+', '\\+')}\\)`));
    }
    expect(lightCountDefines().split('\n')).toEqual([
      `#define LIGHTS_WITH_DIRECTION (${counts.join(' + ')})`,
      '#define POSITIONAL_LIGHTS (NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS)',
    ]);
  });

  test('are unrolled by three.js, and leave no macro behind', () => {
    const { lightShadows, ...walks } = lightChunks();
    for (const [name, chunk] of Object.entries(walks)) {
      const left = chunk.replace(/NUM_\w+_LIGHTS/g, '2').replace(UNROLLED, '');
      expect(left, name).not.toContain('for (');
      expect(chunk.trimEnd().endsWith('#undef VISIT_LIGHT'), name).toBe(true);
    }
    const told = [...lightShadows.matchAll(/^#define (get\w*Shadow)\(/gm)].map(([, name]) => name);
    expect(new Set(told)).toEqual(new Set(['getShadow', 'getPointShadow', 'getSunShadow']));
  });

  test("visit the shadow maps that three's own walk reads, by the number of their light, flat ones and cubes apart", () => {
    const { lights_fragment_begin, shadowmap_pars_vertex } = ShaderChunk;
    const theirs = [...lights_fragment_begin.matchAll(/\bget(Point)?Shadow\( (\w+)\[ i \],/g)].map(([, cube, map]) => ({
      isCube: cube !== undefined,
      map,
    }));
    expect(theirs).toHaveLength(3);
    const { shadowMatrices, eachFlatShadow, eachCubeShadow } = shadowChunks();
    for (const { isCube, map } of theirs) {
      const visit = new RegExp(`VISIT_SHADOW\\(([^,]*), ${map}\\[i\\], [^,]*\\[i\\][^,]*, \\w+LightShadows\\[i\\]\\)`);
      const [chunk, other] = isCube ? [eachCubeShadow, eachFlatShadow] : [eachFlatShadow, eachCubeShadow];
      expect(chunk).toMatch(visit);
      expect(other).not.toContain(map);
      const kind = map.replace('ShadowMap', '');
      const number = new RegExp(`VISIT_LIGHT\\(${kind}Lights\\[i\\], ([^)]*)\\)`).exec(lightChunks().eachLight)?.[1];
      expect(visit.exec(chunk)?.[1]).toBe(number);
    }
    for (const [, name, count] of shadowMatrices.matchAll(/uniform mat4 (\w+)\[(\w+)\];/g)) {
      expect(shadowmap_pars_vertex).toMatch(new RegExp(`uniform mat4 ${name}\\[ ${count} \\];`));
    }
    for (const chunk of [eachFlatShadow, eachCubeShadow]) {
      expect(chunk.replace(/NUM_\w+_SHADOWS/g, '2').replace(UNROLLED, '')).not.toContain('for (');
      expect(chunk.endsWith('#undef VISIT_SHADOW')).toBe(true);
    }
  });

  test('leave out what the installed three.js does not have', () => {
    ShaderChunk.lights_pars_begin = lights_pars_begin.replaceAll('NUM_SUN_LIGHTS', 'NUM_OTHER_LIGHTS');
    const text = [lightCountDefines(), ...Object.values(lightChunks())].join('\n');
    expect(text).not.toMatch(/sunLights|_SUN_/);
    expect(text).toContain('directionalLights');
  });
});
