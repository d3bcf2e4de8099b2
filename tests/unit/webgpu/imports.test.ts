import { existsSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { expect, test } from 'vitest';

const { dirname, join } = posix;

/** The imports of a module that load when it runs, static or dynamic. */
const IMPORT = /(?:^(?:import|export)\s+(?!type\b)[^'"`;]*?from\s*|^import\s*|\bimport\(\s*)['"]([^'"]+)['"]/gm;

/** The modules that a module loads when it runs, itself included, and the packages that they name. */
function closureOf(entry: string): { modules: string[]; packages: Set<string> } {
  const modules = [entry];
  const packages = new Set<string>();
  for (const path of modules) {
    if (!/\.tsx?$/.test(path)) continue;
    for (const [, name] of readFileSync(path, 'utf8').matchAll(IMPORT)) {
      if (!name.startsWith('.')) {
        packages.add(name);
        continue;
      }
      const plain = join(dirname(path), name.split('?')[0]);
      const target = [plain, plain.replace(/\.js$/, '.ts'), plain.replace(/\.js$/, '.tsx')].find(existsSync)!;
      if (!modules.includes(target)) modules.push(target);
    }
  }
  return { modules, packages };
}

/** Whether a module loads GLSL, by a glob. */
const hasGlsl = (path: string): boolean => readFileSync(path, 'utf8').includes('import.meta.glob');

test('what draws with WebGPURenderer needs no GLSL, and no material that is written in it', () => {
  const { modules, packages } = closureOf('src/webgpu/index.ts');
  expect(modules.length).toBeGreaterThan(20);
  // Fetched for geometries with outlines that deform, by whichever renderer.
  const later = 'src/material/deformation/PrePass.ts';
  expect(modules.filter((path) => hasGlsl(path) && path !== later)).toEqual([]);
  expect(modules.filter((path) => /Hatching(Outline)?Material\.ts$/.test(path))).toEqual([]);
  expect([...packages].filter((name) => !/^three($|\/webgpu$|\/tsl$)/.test(name))).toEqual([]);
});

test.each(['index', 'facts', 'vector/svg/index', 'strokes/hands/index', 'react/index', 'element/element'])(
  '%s loads with versions of three.js that have no WebGPURenderer',
  (entry) => {
    const { packages } = closureOf(`src/${entry}.ts`);
    expect([...packages].filter((name) => /^three\/(webgpu|tsl)/.test(name))).toEqual([]);
  },
);

test('GLSL is found where it is imported', () => {
  expect(closureOf('src/index.ts').modules.filter(hasGlsl).length).toBeGreaterThan(5);
});
