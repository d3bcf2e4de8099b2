import { readdirSync, readFileSync } from 'node:fs';
import { afterEach, expect, test, vi } from 'vitest';
import { newEnough } from '../../../src/webgpu/nodes/base/values.js';

const SENTENCE =
  /^three-hatching\/webgpu needs three\.js 0\.186 or newer, but this is 0\.(\w+)\. Update three\.js, or /;

const VERSIONS = [
  ['three-oldest', '170'],
  ['three-middle', '180'],
] as const;

afterEach(() => {
  for (const name of ['three', 'three/webgpu', 'three/tsl']) vi.doUnmock(name);
  vi.resetModules();
  vi.unstubAllGlobals();
});

test.each(VERSIONS)('%s: importing the subpath is rejected with one sentence', async (name, revision) => {
  vi.resetModules();
  // 0.170 needs `self` when it is imported.
  vi.stubGlobal('self', globalThis);
  vi.stubGlobal('navigator', {});
  vi.doMock('three', () => import(name));
  vi.doMock('three/webgpu', () => import(`${name}/webgpu`));
  vi.doMock('three/tsl', () => import(`${name}/tsl`));
  const error: Error = await import('../../../src/webgpu/index.js').then(
    () => new Error('it was imported'),
    (reason) => reason,
  );
  expect(SENTENCE.exec(error.message)?.[1], error.message).toBe(revision);
});

test.each(['186', '187', '187dev', '200'])('0.%s is new enough', (revision) => {
  const nodes = {};
  expect(newEnough(nodes, revision)).toBe(nodes);
});

test.each(['185', '185dev', '99'])('0.%s is too old', (revision) => {
  expect(() => newEnough({}, revision)).toThrow(SENTENCE);
});

/** The names that modules import at run time. */
const IMPORTED = /^import \{([^}]*)\} from '(three\/\w+)';/gm;

const sources = readdirSync('src/webgpu', { recursive: true, encoding: 'utf8' }).filter((path) => path.endsWith('.ts'));

/** The exports of a build of an older version. */
function exportsOf(name: string): Set<string> {
  const { exports } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8'));
  const code = readFileSync(`node_modules/${name}/${exports['./webgpu']}`, 'utf8');
  const lists = [...code.matchAll(/^export \{([^}]*)\}/gm)].map(([, list]) => list);
  return new Set(lists.flatMap((list) => list.split(',').map((one) => one.trim().split(' as ').at(-1)!)));
}

test.each(VERSIONS)('%s has every name that is imported before it is asked for its version', (name) => {
  const known = exportsOf(name);
  const asked = sources.flatMap((path) =>
    [...readFileSync(`src/webgpu/${path}`, 'utf8').matchAll(IMPORTED)].flatMap(([, list, from]) =>
      list
        .split(',')
        .map((one) => one.trim())
        .filter((one) => one !== '' && !one.startsWith('type '))
        .map((one) => `${from} ${one}`),
    ),
  );
  expect(asked).toContain('three/webgpu NodeMaterial');
  expect(asked.filter((one) => one.startsWith('three/tsl') || !known.has(one.split(' ')[1]))).toEqual([]);
});
