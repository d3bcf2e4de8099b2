import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { HATCHING_TECHNIQUES, type HatchingTechnique, type Medium } from '../../../../src/look/hatchingProperties.js';
import { deformationShaders } from '../../../../src/material/deformation/PrePass.js';
import { backgroundShaders } from '../../../../src/material/HatchingBackground.js';
import { outlineShaders } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { fetchPart, partNameOf } from '../../../../src/material/parts/parts.js';
import { hatchingShaders, plainShaders, type Shaders } from '../../../../src/material/shaders/hatchingShaders.js';
import { environmentLayout } from '../../../../src/material/three/environments.js';

const names = Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[];
const media = ['ink', 'dry', 'stipple'] as const;

/** The shaders of a technique and a medium, with the part that they need. */
async function shadersOf(technique: HatchingTechnique, medium: Medium = 'ink'): Promise<Shaders> {
  const part = partNameOf(technique, medium);
  return hatchingShaders(technique, part ? (await fetchPart(part)).files : undefined);
}

const files = readdirSync('shaders', { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map(({ parentPath, name }) => `${parentPath}/${name}`);

describe('the shaders', () => {
  test.each(names)('of %s have no include of ours left, in any medium', async (technique) => {
    for (const medium of media) {
      const { vertexShader, fragmentShader } = await shadersOf(technique, medium);
      for (const text of [vertexShader, fragmentShader]) expect(text).not.toMatch(/#include[^<\n]*"/);
      expect(vertexShader).toContain('void main()');
      expect(fragmentShader).toContain('void main()');
    }
  });

  test('of a medium hold no other', async () => {
    const [ink, dry, stipple] = await Promise.all(media.map((medium) => shadersOf('anchored', medium)));
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

  test('are resolved once and differ by technique', async () => {
    const all = await Promise.all(names.map((technique) => shadersOf(technique)));
    for (const [i, technique] of names.entries()) expect(await shadersOf(technique)).toBe(all[i]);
    expect(new Set(all.map(({ vertexShader }) => vertexShader)).size).toBe(names.length);
    expect(new Set(all.map(({ fragmentShader }) => fragmentShader)).size).toBe(names.length);
  });

  test('every technique has a folder of chunks, and every folder is a technique', () => {
    const folders = readdirSync('shaders/techniques');
    expect(folders.sort()).toEqual([...names].sort());
  });

  test('no file lies there for nothing', async () => {
    const ofLooks = names.flatMap((technique) => media.map((medium) => shadersOf(technique, medium)));
    const all = [
      plainShaders(),
      deformationShaders(),
      outlineShaders(),
      backgroundShaders(),
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

  test('know techniques by their chunks alone', () => {
    for (const path of files) expect(readFileSync(path, 'utf8'), path).not.toMatch(/\bTECHNIQUE/);
  });
});
