import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { FORM_CONSTANTS } from '../../../../src/look/constants/lineConstants.js';
import { HATCHING_TECHNIQUES, type HatchingTechnique } from '../../../../src/look/hatchingProperties.js';
import { backgroundShaders } from '../../../../src/material/HatchingBackground.js';
import { outlineShaders } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { fetchPart, partNameOf } from '../../../../src/material/parts/parts.js';
import { hatchingShaders } from '../../../../src/material/shaders/hatchingShaders.js';
import { MULTIPLES } from '../../../../src/mesh/form/phase/solvePhase.js';

/** Every number that shaders and processor share is in one of these tables, and nowhere else. */
type Value = number | readonly number[];
const tables = import.meta.glob<Record<string, Record<string, Value>>>('../../../../src/look/constants/*.ts', {
  eager: true,
});
const constants = Object.entries(tables).flatMap(([path, exported]) =>
  Object.values(exported).flatMap((table) =>
    Object.entries(table).map(([name, value]) => ({ name, value, file: path.replace(/.*\//, '') })),
  ),
);

const textsIn = (folders: readonly string[], ending: RegExp): Record<string, string> =>
  Object.fromEntries(
    folders
      .flatMap((folder) =>
        readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((path) => `${folder}/${path}`),
      )
      .filter((path) => ending.test(path) && !path.startsWith('src/look/constants'))
      .map((path) => [path, readFileSync(path, 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')]),
  );

const shaders = textsIn(['shaders'], /\.(glsl|vert|frag)$/);
const processor = textsIn(['src/vector', 'src/look'], /\.ts$/);

/** Definitions such as `#define NAME value` or `const float NAME = value;`, and in TypeScript `const NAME = value;`. */
const definitionsIn = (texts: Record<string, string>) =>
  Object.entries(texts).flatMap(([path, text]) =>
    [
      ...text.matchAll(/^\s*(?:#define|(?:export )?const(?: \w+)?) ([A-Z][A-Z0-9_]+)(?::[^=]*)?(?: =)? +(.+?);?$/gm),
    ].map(([, name, value]) => ({ name, value, path })),
  );

/** The numbers of a value in either language: vec2(0.1, 0.6) and [0.1, 0.6] as const have the same. */
const numbersOf = (value: string): string =>
  (value.replace(/\bvec\d/g, '').match(/(?<!\w)[\d.]+(?:e-?\d+)?/g) ?? []).map(Number).join();

const isNumber = (value: string): boolean => /^(vec\d *\(|\[)?[-\d.,e ]+(\)|\])?( as const)?$/.test(value);

const isUsed = (name: string, texts: Record<string, string>): boolean =>
  Object.values(texts).some((text) => new RegExp(`\\b${name}\\b`).test(text));

describe('numbers that shaders and the processor share', () => {
  test('have unique names', () => {
    const names = constants.map(({ name }) => name);
    expect(names.filter((name, i) => names.indexOf(name) < i)).toEqual([]);
    expect(names.length).toBeGreaterThan(90);
  });

  test.each(constants)('$name of $file is used by both, and defined by neither', ({ name, value }) => {
    expect(isUsed(name, shaders), 'in shaders').toBe(true);
    expect(isUsed(name, processor), 'on the processor').toBe(true);
    expect(definitionsIn(shaders).filter((one) => one.name === name)).toEqual([]);
    const numbers = numbersOf(JSON.stringify(value));
    const again = definitionsIn(processor).filter((one) => one.name === name && numbersOf(one.value) === numbers);
    expect(again).toEqual([]);
  });

  test('are in the tables if both languages name them', () => {
    const onProcessor = definitionsIn(processor);
    const twice = definitionsIn(shaders).filter(
      ({ name, value }) =>
        isNumber(value) &&
        onProcessor.some((other) => other.name === name && numbersOf(other.value) === numbersOf(value)),
    );
    expect(twice).toEqual([]);
  });

  test('are defined exactly once in every program that uses them', async () => {
    const programs = [outlineShaders(), backgroundShaders()];
    for (const technique of Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[]) {
      programs.push(hatchingShaders(technique, (await fetchPart(partNameOf({ technique }))).files));
    }
    for (const text of new Set(
      programs.flatMap(({ vertexShader, fragmentShader }) => [vertexShader, fragmentShader]),
    )) {
      const defined = [...text.matchAll(/^\s*#define (\w+) /gm)].map(([, name]) => name);
      const used = new Set(text.replace(/\/\/.*|^\s*#define \w+/gm, '').match(/\b[A-Z][A-Z0-9_]+\b/g));
      for (const { name } of constants) {
        const count = defined.filter((one) => one === name).length;
        expect(count, name).toBeLessThanOrEqual(1);
        if (used.has(name)) expect(count, name).toBe(1);
      }
    }
  });

  test('of the form are those of its bake', () => {
    expect(FORM_CONSTANTS.COARSEST_OCTAVES).toEqual(MULTIPLES.map(Math.log2));
  });
});
