import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterEach, expect, test } from 'vitest';
import { compileTemplate } from 'vue/compiler-sfc';
import { parseDrawing } from '../../../src/command/parseDrawing.js';
import { DOCUMENTS, root } from './documents.js';
import { NODE_SAMPLES, SAMPLE_CALLS, SAMPLES } from './sampleList.js';

const folder = join(root, 'tests/output/samples');

/** What samples speak of and do not make: a scene that stands there already. */
const AROUND = `
import type { BufferGeometry, DirectionalLight as Sun, Group, Mesh as AnyMesh, MeshStandardMaterial as Standard, Object3D, PerspectiveCamera as Eye,
  Scene as World, Texture, WebGLRenderer as Renderer } from 'three';
import type { Hand as OwnHand, HandStroke as Drawn, HatchedScene as Hatched, HatchingMaterial as Material, TonalArtMap as HatchMap } from 'three-hatching';
declare global {
  const mesh: AnyMesh; const scene: World; const camera: Eye; const renderer: Renderer; const light: Sun;
  const geometry: BufferGeometry; const material: Material; const tonalArtMap: HatchMap; const map: HatchMap;
  const gltf: { scene: Group }; const scan: Object3D; const first: Object3D; const second: Object3D; const gradientMap: Texture;
  const files: File[]; const ground: AnyMesh<BufferGeometry, Material>; const BakeWorker: new () => Worker;
  const strokes: Drawn[]; const hand: OwnHand; const picture: HTMLCanvasElement; const canvas: HTMLCanvasElement;
  const lamp: Group; const cord: AnyMesh; var shade: AnyMesh<BufferGeometry, Standard>; const kind: string;
  const shades: Record<string, () => BufferGeometry>; const hatched: Hatched; const signal: AbortSignal; const draw: () => void; const save: () => void;
}
export {};
`;

const home = process.cwd();
afterEach(() => process.chdir(home));

test('a sample for Node runs as it stands', async () => {
  expect(NODE_SAMPLES.map(({ name }) => name)).toEqual(['svg-node-1']);
  const [{ name, code }] = NODE_SAMPLES;
  const place = join(root, 'tests/output/nodeSamples');
  mkdirSync(place, { recursive: true });
  rmSync(join(place, 'drawing.svg'), { force: true });
  writeFileSync(join(place, `${name}.js`), code);
  process.chdir(place);
  await import(/* @vite-ignore */ pathToFileURL(join(place, `${name}.js`)).href);
  const svg = readFileSync(join(place, 'drawing.svg'), 'utf8');
  expect(svg).toContain('width="200mm" height="200mm"');
  expect(svg.match(/<path/g)!.length).toBeGreaterThan(100);
});

test.each(SAMPLE_CALLS.filter(({ args }) => args[0] === 'draw').map(({ line, args }) => [line, args] as const))(
  'a call of the guides is understood: %s',
  (_, args) => {
    expect(parseDrawing(args.slice(1)).action).toBe('draw');
  },
);

test('every sample of README and guides compiles', () => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const modules = SAMPLES.filter(({ kind }) => kind !== 'html');
  expect(modules.length).toBeGreaterThan(30);
  for (const { name, kind, code } of modules) writeFileSync(join(folder, `${name}.${kind}`), code);
  writeFileSync(join(folder, 'around.d.ts'), AROUND);
  const compilerOptions = { verbatimModuleSyntax: false, noUnusedLocals: false, noUnusedParameters: false };
  const config = {
    extends: '../../../tsconfig.json',
    compilerOptions,
    include: ['*.ts', '*.tsx', '../../../src/**/*.d.ts'],
    exclude: [],
  };
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config));
  const typescript = dirname(createRequire(import.meta.url).resolve('typescript/package.json'));
  let output = '';
  try {
    execFileSync(process.execPath, [join(typescript, 'bin/tsc'), '--project', folder], {
      encoding: 'utf8',
      cwd: folder,
    });
  } catch (error) {
    output = (error as { stdout: string }).stdout;
  }
  expect(output).toBe('');
});

test('the setting for Vue has the tag left to the browser', () => {
  const [, code] = /^```js\n(vue\([\s\S]*?)^```/m.exec(DOCUMENTS['docs/element.md'])!;
  const { template } = new Function('vue', `return ${code}`)((options: unknown) => options);
  const compiled = (compilerOptions: object): string =>
    compileTemplate({ source: '<hatched-model src="bust.glb" />', filename: 'bust.vue', id: 'bust', compilerOptions })
      .code;
  expect(compiled({})).toContain('resolveComponent');
  expect(compiled(template.compilerOptions)).not.toContain('resolveComponent');
});

test('the code of the Configurator guide is that of its example', () => {
  const example = readFileSync(join(root, 'examples/configurator/main.ts'), 'utf8');
  const lines = new Set(example.split('\n').map((line) => line.trim()));
  const blocks = [...DOCUMENTS['docs/configurator.md'].matchAll(/^```ts\n([\s\S]*?)^```/gm)].map(([, code]) => code);
  const same = blocks.filter((code) => /applyHatching\(|hatched\.(update|background, 0|dispose)/.test(code));
  expect(same).toHaveLength(4);
  const others = same.flatMap((code) => code.split('\n').map((line) => line.trim())).filter((line) => !lines.has(line));
  expect(others).toEqual(['const next = new Mesh(shades[kind](), shade.material);']);
});
