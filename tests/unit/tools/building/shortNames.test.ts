import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { shortNames, withShortNames } from '../../../../tools/building/shortNames.js';
import { asShipped, shortened } from '../../../../tools/building/shortShaders.js';

const nobody: ReadonlySet<string> = new Set();

test('functions, macros, structures, members, varyings and variables get short names, the same in all files', () => {
  const files = [
    'struct Stroke{float width;};\n#define DOUBLE(value) mean(value,value)\nvarying vec3 vAxis;\nfloat mean(float a,float b){return a;}',
    '#ifdef DOUBLE\nfloat read(Stroke stroke){return DOUBLE(stroke.width)+vAxis.x;}\n#endif',
  ];
  const short = shortNames(files, nobody);
  expect([...short.keys()].sort()).toEqual(['DOUBLE', 'Stroke', 'mean', 'read', 'stroke', 'vAxis', 'width'].sort());
  const [first, second] = files.map((file) => withShortNames(file, short));
  expect(new Set(short.values()).size).toBe(short.size);
  const of = (name: string) => short.get(name);
  expect(second).toBe(
    `#ifdef ${of('DOUBLE')}\nfloat ${of('read')}(${of('Stroke')} ${of('stroke')}){return ${of('DOUBLE')}(${of('stroke')}.${of('width')})+${of('vAxis')}.x;}\n#endif`,
  );
  expect(first).toContain(`struct ${of('Stroke')}{float ${of('width')};};`);
});

test('values of materials and of vertices, names that others know, and names of files stay', () => {
  const file =
    'uniform float tone;attribute vec3 place;\n#include "width"\nfloat width(float tone){return tone;}\nfloat area(){return 1.;}';
  const short = shortNames([file.replace(';attribute', ';\nattribute')], new Set(['area']));
  expect([...short.keys()]).toEqual(['width']);
  expect(withShortNames(file, short)).toBe(file.replace('float width', 'float _a'));
});

test('the most frequent name is the shortest', () => {
  const functions = Array.from({ length: 99 }, (_, i) => `float other${i}(){return often();}`);
  const short = shortNames(['float often(){return 1.;}', ...functions], nobody);
  expect(short.get('often')).toBe('_a');
  expect(short.get('other98')).toMatch(/^_[a-zA-Z]{2}$/);
});

describe('shaders as they are shipped', () => {
  const texts = readdirSync('shaders', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => readFileSync(`${parentPath}/${name}`, 'utf8'));

  test('have another name for each name, and no name for two', () => {
    const words = (text: string) => text.match(/(?<!\w)[a-z_]\w*/gi) ?? [];
    const given = new Map<string, string>();
    for (const text of texts) {
      const before = words(shortened(text).replace(/^#include.*/gm, ''));
      const after = words(asShipped(text).replace(/^#include.*/gm, ''));
      expect(after).toHaveLength(before.length);
      for (const [i, name] of after.entries()) {
        // Those without an underscore are as they were, or letters of one function.
        if (!name.startsWith('_')) continue;
        expect(given.get(name) ?? before[i]).toBe(before[i]);
        given.set(name, before[i]);
      }
    }
    expect(given.size).toBeGreaterThan(300);
    for (const name of given.values()) expect(given.has(name)).toBe(false);
  });
});
