import { cpSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { DirectionalLight, Mesh, OrthographicCamera, PlaneGeometry, Scene } from 'three';
import { float } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { beforeAll, describe, expect, test } from 'vitest';
import { coverageOf, pathsOf } from '../vector/paths.js';
import { DOCUMENTS, root } from './documents.js';

/** The tutorial of CONTRIBUTING.md, followed in a copy of the source. */

const copy = join(root, 'tests/output/tutorial');

interface Change {
  file: string;
  before: string;
  after: string;
}

/** The diffs of the tutorial, each of the file that the text before it names last. */
function changesOf(text: string): Change[] {
  const pieces = text.split(/^ *```diff\n([\s\S]*?)^ *```$/m);
  let file = '';
  return pieces.flatMap((piece, i) => {
    if (i % 2 === 0) {
      const named = [...piece.matchAll(/`([\w./]+)`/g)].map(([, name]) => name);
      file = named.filter((name) => name.includes('/') && existsSync(join(root, name))).at(-1) ?? file;
      return [];
    }
    // The blocks stand in a list, three spaces in.
    const lines = piece
      .trimEnd()
      .split('\n')
      .map((line) => line.slice(3));
    const withMark = (mark: string) => lines.filter((line) => !line.startsWith(mark)).map((line) => line.slice(1));
    return [{ file, before: withMark('+').join('\n'), after: withMark('-').join('\n') }];
  });
}

const load = (path: string) => import(/* @vite-ignore */ pathToFileURL(join(copy, path)).href);

const text = DOCUMENTS['CONTRIBUTING.md'];
const changes = changesOf(
  text.slice(text.indexOf('## A first change'), text.indexOf('The stations of a value')).split('**The picture.**')[0],
);

test('changes the table, the shader, the nodes, the vector file and the control, where each is found once', () => {
  expect(changes.map(({ file }) => file)).toEqual([
    'tools/properties/rows/colour.ts',
    'shaders/chunks/printedColor.glsl',
    'shaders/chunks/printedColor.glsl',
    'src/webgpu/nodes/chunks/ink.ts',
    'src/webgpu/nodes/chunks/ink.ts',
    'src/vector/svg/readLook.ts',
    'src/viewer/settings/table/toneSettings.ts',
  ]);
  for (const { file, before } of changes) {
    expect(readFileSync(join(root, file), 'utf8').split(before), `${file}: ${before}`).toHaveLength(2);
  }
});

describe('followed in a copy', { tags: ['all'] }, () => {
  beforeAll(async () => {
    rmSync(copy, { recursive: true, force: true });
    for (const name of ['src', 'shaders', 'tools/properties', 'docs/material.md', 'biome.json', 'package.json']) {
      cpSync(join(root, name), join(copy, name), { recursive: true });
    }
    for (const { file, before, after } of changes) {
      const source = readFileSync(join(copy, file), 'utf8');
      writeFileSync(
        join(copy, file),
        source.replace(before, () => after),
      );
    }
    // The page's settings import the library by its name: theirs is that of the copy.
    for (const name of readdirSync(join(copy, 'src/viewer/settings'), { recursive: true, encoding: 'utf8' })) {
      const path = join(copy, 'src/viewer/settings', name);
      if (!path.endsWith('.ts')) continue;
      const named = (entry: string) => `'${join(copy, 'src', entry).replaceAll('\\', '/')}'`;
      const source = readFileSync(path, 'utf8')
        .replaceAll("'three-hatching'", named('index.ts'))
        .replaceAll("'three-hatching/facts'", named('facts.ts'));
      writeFileSync(path, source);
    }
    const { outputs } = await load('tools/properties/outputs.ts');
    for (const [file, written] of Object.entries<string>(outputs())) writeFileSync(join(copy, file), written);
  });

  test('gives the material a property with a range, and a uniform of its shader', async () => {
    const { HatchingMaterial } = await load('src/material/HatchingMaterial.ts');
    const material = new HatchingMaterial({ inkStrength: 0.5 });
    expect(material.uniforms.inkStrength.value).toBe(0.5);
    await HatchingMaterial.preload();
    material.customProgramCacheKey();
    expect(material.fragmentShader).toContain('inkStrength * hatched');
    expect(readFileSync(join(copy, 'docs/material.md'), 'utf8')).toContain('| `inkStrength` | `1` |');
  });

  test('gives the nodes the uniform', async () => {
    const { printedColor } = await load('src/webgpu/nodes/chunks/ink.ts');
    const references: unknown[] = [];
    printedColor(float(1), float(0.5), false, true).traverse((node: Node & { property?: unknown }) =>
      references.push(node.property),
    );
    expect(references).toContain('uniforms.inkStrength.value');
  });

  test('gives the control the range of the property', async () => {
    const { COLOUR_SETTINGS } = await load('src/viewer/settings/table/toneSettings.ts');
    expect(COLOUR_SETTINGS.inkStrength).toMatchObject({ label: 'Strength', default: 100, min: 0, max: 100 });
  });

  test('draws thinner lines in a vector file', async () => {
    const { HatchingMaterial } = await load('src/material/HatchingMaterial.ts');
    const { drawSVG } = await load('src/vector/svg/index.ts');
    const inkOf = async (inkStrength: number): Promise<number> => {
      const material = new HatchingMaterial({ technique: 'engraving', direction: 'y', inkStrength });
      const light = new DirectionalLight('white', 0.7 * Math.PI);
      light.position.z = 1;
      const scene = new Scene().add(new Mesh(new PlaneGeometry(2, 2), material), light);
      const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
      camera.position.z = 5;
      const { svg } = await drawSVG(scene, camera, { sheet: [40, 40], margin: 0, leastWidth: 0 });
      return coverageOf(pathsOf(svg), [5, 5, 30, 30], 200);
    };
    const [full, half] = [await inkOf(1), await inkOf(0.5)];
    expect(half / full).toBeGreaterThan(0.4);
    expect(half / full).toBeLessThan(0.6);
  });
});
