import { execFileSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { expect, test } from 'vitest';
import { root } from './documents.js';
import { SAMPLES } from './sampleList.js';

const folder = join(root, 'tests/output/samples');

/** What samples speak of and do not make: a scene that stands there already. */
const AROUND = `
import type { BufferGeometry, DirectionalLight as Sun, Group, Mesh as AnyMesh, Object3D, PerspectiveCamera as Eye,
  Scene as World, Texture, WebGLRenderer as Renderer } from 'three';
import type { Hand as OwnHand, HandStroke as Drawn, HatchingMaterial as Material, TonalArtMap as HatchMap } from 'three-hatching';
declare global {
  const mesh: AnyMesh; const scene: World; const camera: Eye; const renderer: Renderer; const light: Sun;
  const geometry: BufferGeometry; const material: Material; const tonalArtMap: HatchMap; const map: HatchMap;
  const gltf: { scene: Group }; const first: Object3D; const second: Object3D; const gradientMap: Texture;
  const files: File[]; const ground: AnyMesh<BufferGeometry, Material>; const BakeWorker: new () => Worker;
  const strokes: Drawn[]; const hand: OwnHand; const picture: HTMLCanvasElement;
}
export {};
`;

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
