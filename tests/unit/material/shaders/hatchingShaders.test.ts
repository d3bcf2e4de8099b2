import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { HATCHING_TECHNIQUES, type HatchingTechnique } from '../../../../src/look/hatchingProperties.js';
import { deformationShaders } from '../../../../src/material/deformation/PrePass.js';
import { backgroundShaders } from '../../../../src/material/HatchingBackground.js';
import { HatchingShadowMaterial } from '../../../../src/material/HatchingShadowMaterial.js';
import { outlineShaders } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { clearShaders, lineShaders, partShaders } from '../../../../src/material/outlines/MovingLines.js';
import { fetchPart, partNameOf } from '../../../../src/material/parts/parts.js';
import { hatchingShaders, type Shaders } from '../../../../src/material/shaders/hatchingShaders.js';
import { plainShaders } from '../../../../src/material/shaders/plainShaders.js';
import { environmentLayout } from '../../../../src/material/three/environments.js';

const names = Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[];
/** The folders of shaders, each with one of its techniques. */
const FOLDERS = { adjacency: 'adjacency', lines: 'engraving', strokes: 'hatching', triangle: 'triangle' } as const;

/** The shaders of a technique, with the part that it needs, with or without a hand and smooth metal. */
async function shadersWith(technique: HatchingTechnique, hand: object | null, metalness = 0): Promise<Shaders> {
  const name = partNameOf({ technique, hand, metalness, roughness: 0 });
  return hatchingShaders(technique, (await fetchPart(name)).files);
}

const shadersOf = (technique: HatchingTechnique): Promise<Shaders> => shadersWith(technique, null);

const files = readdirSync('shaders', { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map(({ parentPath, name }) => `${parentPath}/${name}`);

describe('the shaders', () => {
  test.each(names)('of %s have no include of ours left', async (technique) => {
    const { vertexShader, fragmentShader } = await shadersOf(technique);
    for (const text of [vertexShader, fragmentShader]) expect(text).not.toMatch(/#include[^<\n]*"/);
    expect(vertexShader).toContain('void main()');
    expect(fragmentShader).toContain('void main()');
  });

  test('of hatching, dry media and stipple hold none of each other', async () => {
    const [ink, dry, stipple] = await Promise.all((['hatching', 'dryMedia', 'stipple'] as const).map(shadersOf));
    const holds = ({ fragmentShader }: Shaders) =>
      [/\bsmudge\b/, /\bstippleMap\b/].map((name) => name.test(fragmentShader));
    expect([ink, dry, stipple].map(holds)).toEqual([
      [false, false],
      [true, false],
      [false, true],
    ]);
  });

  test('of lines have no include of ours left, and are resolved once', () => {
    const { vertexShader, fragmentShader } = outlineShaders();
    for (const text of [vertexShader, fragmentShader]) expect(text).not.toMatch(/#include[^<\n]*"/);
    expect(outlineShaders()).toBe(outlineShaders());
  });

  test('are resolved once, and differ by folder', async () => {
    const all = await Promise.all(Object.values(FOLDERS).map(shadersOf));
    for (const [i, technique] of Object.values(FOLDERS).entries()) expect(await shadersOf(technique)).toBe(all[i]);
    expect(new Set(all.map(({ vertexShader }) => vertexShader)).size).toBe(all.length);
    expect(new Set(all.map(({ fragmentShader }) => fragmentShader)).size).toBe(all.length);
  });

  test('of a woodcut are those of the pen with the code of cuts', async () => {
    const [cuts, lines] = await Promise.all((['woodcut', 'pen'] as const).map(shadersOf));
    expect(cuts.vertexShader).toBe(lines.vertexShader);
    const holds = [cuts, lines].map(({ fragmentShader }) => /float cutWidth\(/.test(fragmentShader));
    expect(holds).toEqual([true, false]);
  });

  test.each(names)('of %s have the code of metal only for metal, and are the same but for it', async (technique) => {
    const [plain, metal] = await Promise.all([shadersOf(technique), shadersWith(technique, null, 1)]);
    expect(plain.fragmentShader).not.toMatch(/metal/);
    expect(metal.vertexShader).toBe(plain.vertexShader);
    const file = (name: string): string => readFileSync(`shaders/chunks/${name}.glsl`, 'utf8');
    const [before, after] = plain.fragmentShader.split(file('darkenedByColor'));
    expect(after).toBeDefined();
    expect(metal.fragmentShader.startsWith(before)).toBe(true);
    expect(metal.fragmentShader.endsWith(after)).toBe(true);
    expect(metal.fragmentShader).toContain(file('metal'));
  });

  test('lie in a folder for each family of techniques, and for each of those per triangle', () => {
    expect(readdirSync('shaders/techniques').sort()).toEqual(Object.keys(FOLDERS));
  });

  test('no file lies there for nothing', async () => {
    const ofLooks = [...names.map(shadersOf), shadersWith('pen', {}), shadersWith('pen', null, 1)];
    const ground = new HatchingShadowMaterial({ technique: 'pen' });
    await ground.ready;
    const all = [
      plainShaders(),
      deformationShaders(),
      outlineShaders(),
      partShaders(),
      lineShaders(outlineShaders()),
      clearShaders(outlineShaders()),
      backgroundShaders(),
      ground,
      ...(await Promise.all(ofLooks)),
    ]
      .flatMap(({ vertexShader, fragmentShader }) => [vertexShader, fragmentShader])
      .join('\n');
    const used = new Set(all.split('\n'));
    // The layout of an environment depends on the version of three.js: one of the two is for other versions.
    const unused = files
      .filter((path) => path !== `shaders/environment/${environmentLayout() === 'cube' ? 'atlas' : 'cube'}.glsl`)
      .filter((path) =>
        readFileSync(path, 'utf8')
          .split('\n')
          .some((line) => !/^\s*#include +"/.test(line) && !used.has(line)),
      );
    expect(unused).toEqual([]);
  });

  test('know the two techniques per triangle by their chunks alone', () => {
    for (const path of files) expect(readFileSync(path, 'utf8'), path).not.toMatch(/\bTECHNIQUE_(TRIANGLE|ADJACENCY)/);
  });
});
