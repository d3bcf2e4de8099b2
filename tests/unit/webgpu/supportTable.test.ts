import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

test('docs/support.md has every scene that is drawn of nodes, and no other', () => {
  const cases = readdirSync('tests/webgpu/cases')
    .filter((file) => !['three.ts', 'unlike.ts'].includes(file))
    .sort()
    .flatMap((file) =>
      [...readFileSync(`tests/webgpu/cases/${file}`, 'utf8').matchAll(/\bname: '([^']+)'/g)].map(
        ([, name]) => `${file.slice(0, -'.ts'.length)} | ${name}`,
      ),
    );
  const table = /<!-- Nodes[^>]*-->([\s\S]*?)<!-- End of nodes -->/.exec(readFileSync('docs/support.md', 'utf8'))![1];
  const rows = table
    .split('\n')
    .filter((line) => line.startsWith('|'))
    .slice(2);
  expect(cases.length).toBeGreaterThan(0);
  expect(rows.map((row) => row.split(' | ').slice(0, 2).join(' | ').replace(/^\| /, ''))).toEqual(cases);
  for (const row of rows) expect(row).toMatch(/\| (\d+\.\d+ %|–) \| (\d+\.\d+ %|–) \|$/);
});
