import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { PARTS } from '../../../../tools/notice/contents.js';
import { licenceTable, unnoticed, writeNotice } from '../../../../tools/notice/writeNotice.js';

const root = fileURLToPath(new URL('../../../../', import.meta.url));

describe('NOTICE.txt', () => {
  const text = writeNotice();

  test('has the terms of everything that others have made', () => {
    for (const { name, licence, by } of PARTS) {
      expect(text).toContain(name);
      expect(text).toContain(`Licence: ${licence}\n`);
      expect(text).toContain(`By: ${by}\n`);
    }
    expect(text.match(/Permission is hereby granted/g)).toHaveLength(
      1 + PARTS.filter(({ licence }) => licence === 'MIT').length,
    );
    for (const sentence of [
      'Copyright (c) 2026 The three-hatching authors',
      'three.js authors',
      'Copyright (c) 2019 Amazon',
      'Arseny Kapoulkine',
      'Mozilla Public License Version 2.0',
      'Stanford Computer Graphics Laboratory',
      'END OF TERMS AND CONDITIONS',
    ])
      expect(text).toContain(sentence);
    // Made anywhere, it is the same.
    expect(text).not.toContain(root);
  });

  test('is a table in the docs too', () => {
    expect(readFileSync(`${root}docs/versions.md`, 'utf8')).toContain(licenceTable());
  });

  test('speaks of every package that the pages import', () => {
    const imported = sourcesIn(`${root}src/`).flatMap((source) =>
      // Types are no part of the pages.
      [...source.replace(/^import type [^;]+;$/gm, '').matchAll(/(?:\bfrom |\bimport\()'([\w@][\w@./?-]*)'/g)].map(
        ([, name]) => name,
      ),
    );
    // Nor are components, and what the command alone imports.
    const modules = imported
      .filter((name) => !/^(node:|three-hatching|react$|@react-three\/fiber$|@jsquash\/)/.test(name))
      .map((name) => `/x/node_modules/${name.replace('three/addons/', 'three/examples/jsm/')}`);
    expect(modules.length).toBeGreaterThan(20);
    expect(unnoticed(modules)).toEqual([]);
  });

  test.each([
    ['/p/node_modules/left-pad/index.js', 'left-pad'],
    ['/p/node_modules/@a/b/c.js?url', '@a/b'],
    ['C:\\p\\node_modules\\left-pad\\index.js', 'left-pad'],
    ['/p/node_modules/three/examples/jsm/libs/opentype.module.js', 'three/examples/jsm/libs/opentype.module.js'],
    ['/p/node_modules/three/node_modules/left-pad/index.js', 'left-pad'],
  ])('misses %s', (module, name) => {
    expect(unnoticed([module, '/p/src/main.ts', '/p/node_modules/three/src/Three.js'])).toEqual([name]);
  });
});

function sourcesIn(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => readFileSync(`${folder}${name}`, 'utf8'));
}
