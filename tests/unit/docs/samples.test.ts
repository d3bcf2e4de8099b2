import { execFileSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import * as three from 'three';
import * as hatching from 'three-hatching';
import { expect, test } from 'vitest';
import { DOCUMENTS, root } from './documents.js';

const folder = join(root, 'tests/output/samples');

/** What samples speak of and do not make: a scene that stands there already. */
const AROUND = `
import type { BufferGeometry, DirectionalLight as Sun, Group, Mesh as AnyMesh, Object3D, PerspectiveCamera as Eye,
  Scene as World, Texture, WebGLRenderer as Renderer } from 'three';
import type { HatchingMaterial as Material, TonalArtMap as HatchMap } from 'three-hatching';
declare global {
  const mesh: AnyMesh; const scene: World; const camera: Eye; const renderer: Renderer; const light: Sun;
  const geometry: BufferGeometry; const material: Material; const tonalArtMap: HatchMap; const map: HatchMap;
  const gltf: { scene: Group }; const first: Object3D; const second: Object3D; const gradientMap: Texture;
  const files: File[]; const ground: AnyMesh<BufferGeometry, Material>; const BakeWorker: new () => Worker;
}
export {};
`;

/** Types of the library, which a module that is loaded does not show. */
const TYPES = ['HatchingMaterialParameters', 'HatchingLineParameters', 'LineOptions', 'MapDrawing'];
const WORD = /\b[A-Za-z]\w*\b/g;

/** A sample with imports of what it uses and does not import, as readers add them. */
function completed(sample: string): string {
  const code = sample.replace(/\/\/.*|'[^'\n]*'/g, '');
  const imported = new Set(
    [...sample.matchAll(/^import\s+(?:type\s+)?\{([^}]*)\}/gm)].flatMap(([, names]) => names.match(WORD) ?? []),
  );
  const declared = new Set(
    [...code.matchAll(/\b(?:const|let|class|interface|function)\s+(\w+)/g)].map(([, name]) => name),
  );
  const used = new Set(code.match(WORD));
  const lacking = (names: string[]) =>
    names.filter((name) => used.has(name) && !imported.has(name) && !declared.has(name));
  const classes = Object.keys(three).filter((name) => /^[A-Z][a-z]/.test(name));
  return [
    `import { ${lacking(classes).join(', ')} } from 'three';`,
    `import { ${lacking([...Object.keys(hatching), ...TYPES]).join(', ')} } from 'three-hatching';`,
    `import { ${lacking(['GLTFLoader']).join(', ')} } from 'three/addons/loaders/GLTFLoader.js';`,
    `import { ${lacking(['useMemo']).join(', ')} } from 'react';`,
    `import { ${lacking(['Canvas']).join(', ')} } from '@react-three/fiber';`,
    `import { ${lacking(['Hatched']).join(', ')} } from 'three-hatching/react';`,
    // Elements alone, without a component around them.
    sample.startsWith('<') ? `export const elements = <>${sample}</>;` : sample,
    'export {};',
  ].join('\n');
}

test('every sample of README and guides compiles', () => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const names: string[] = [];
  for (const [path, text] of Object.entries(DOCUMENTS)) {
    for (const [i, [, kind, sample]] of [...text.matchAll(/^```(tsx?)\n([\s\S]*?)^```/gm)].entries()) {
      const name = `${path.replace(/^docs\//, '').replace('.md', '')}-${i + 1}.${kind}`;
      writeFileSync(join(folder, name), completed(sample));
      names.push(name);
    }
  }
  expect(names.length).toBeGreaterThan(30);
  writeFileSync(join(folder, 'around.d.ts'), AROUND);
  const compilerOptions = { verbatimModuleSyntax: false, noUnusedLocals: false, noUnusedParameters: false };
  const config = { extends: '../../../tsconfig.json', compilerOptions, include: ['*.ts', '*.tsx'], exclude: [] };
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
