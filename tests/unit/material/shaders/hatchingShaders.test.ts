import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { HATCHING_TECHNIQUES, type HatchingTechnique } from '../../../../src/material/facts/hatchingProperties.js';
import { environmentLayout } from '../../../../src/material/shaders/environmentLayout.js';
import { deformationShaders, hatchingShaders } from '../../../../src/material/shaders/hatchingShaders.js';
import { outlineShaders } from '../../../../src/outlines/outlineShaders.js';

const names = Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[];
const files = readdirSync('shaders', { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map(({ parentPath, name }) => `${parentPath}/${name}`);

describe('the shaders', () => {
  test.each(names)('of %s have no include of ours left', (technique) => {
    const { vertexShader, fragmentShader } = hatchingShaders(technique);
    for (const text of [vertexShader, fragmentShader]) expect(text).not.toMatch(/#include[^<\n]*"/);
    expect(vertexShader).toContain('void main()');
    expect(fragmentShader).toContain('void main()');
  });

  test('of lines have no include of ours left, and are resolved once', () => {
    const { vertexShader, fragmentShader } = outlineShaders();
    for (const text of [vertexShader, fragmentShader]) expect(text).not.toMatch(/#include[^<\n]*"/);
    expect(outlineShaders()).toBe(outlineShaders());
  });

  test('are resolved once and differ by technique', () => {
    for (const technique of names) expect(hatchingShaders(technique)).toBe(hatchingShaders(technique));
    expect(new Set(names.map((technique) => hatchingShaders(technique).vertexShader)).size).toBe(names.length);
    expect(new Set(names.map((technique) => hatchingShaders(technique).fragmentShader)).size).toBe(names.length);
  });

  test('every technique has a folder of chunks, and every folder is a technique', () => {
    const folders = readdirSync('shaders/techniques');
    expect(folders.sort()).toEqual([...names].sort());
  });

  test('no file lies there for nothing', () => {
    const all = [deformationShaders(), outlineShaders(), ...names.map(hatchingShaders)]
      .flatMap(({ vertexShader, fragmentShader }) => [vertexShader, fragmentShader])
      .join('\n');
    const used = new Set(all.split('\n'));
    // How an environment is laid out depends on the version of three.js: one of the two is for others.
    const unused = files
      .filter((path) => path !== `shaders/environment/${environmentLayout() === 'cube' ? 'atlas' : 'cube'}.glsl`)
      .filter((path) =>
        readFileSync(path, 'utf8')
          .split('\n')
          .some((line) => !/^\s*#include +"/.test(line) && !used.has(line)),
      );
    expect(unused).toEqual([]);
  });

  test('know techniques by their chunks alone', () => {
    for (const path of files) expect(readFileSync(path, 'utf8'), path).not.toMatch(/\bTECHNIQUE/);
  });
});
