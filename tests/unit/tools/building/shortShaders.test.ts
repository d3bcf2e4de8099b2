import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { shortened } from '../../../../tools/building/shortShaders.js';

/** The words, numbers and signs that a compiler sees, each in its shortest form. */
const tokensOf = (text: string): string[] =>
  (
    text
      .replace(/\/\/.*/g, '')
      .replace(/\bconst in\b/g, 'const')
      .match(/[\w.]+|[+-]+|[^\s\w.]/g) ?? []
  ).map((token) => token.replace(/^0(\.\d+)$/, '$1').replace(/^(\d+\.)0$/, '$1'));

describe('shaders as they are shipped', () => {
  const files = readdirSync('shaders', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => `${parentPath}/${name}`);

  test.each(files)('%s has the tokens of its source, and its directives on lines of their own', (path) => {
    const text = readFileSync(path, 'utf8');
    const short = shortened(text);
    expect(tokensOf(short)).toEqual(tokensOf(text));
    for (const line of short.split('\n')) expect(line.indexOf('#'), line).toBeLessThanOrEqual(0);
    expect(short.match(/^#/gm)?.length).toBe(text.match(/^\s*#/gm)?.length);
    expect(short.length).toBeLessThanOrEqual(text.length);
  });

  test('keep the head of main as users look for it in onBeforeCompile', () => {
    expect(shortened('void main() {\n  float a = 1.0;\n}\n')).toContain('void main() {float a=1.;');
  });

  test('keep signs apart that would be another operator', () => {
    expect(shortened('float x = a - -b + +c + d - e;')).toBe('float x=a - -b + +c+d-e;');
  });

  test('keep numbers what they are', () => {
    expect(shortened('vec4 a = vec4(0.5, 1.0, 10.05, 2.0e3);')).toBe('vec4 a=vec4(.5,1.,10.05,2.0e3);');
  });

  test('keep the space after a macro, which decides whether it has parameters', () => {
    expect(shortened('#define A (1 + 2) // three\n  float f(const in float x) {\n  return x;\n}\n')).toBe(
      '#define A (1 + 2)\nfloat f(const float x){return x;}\n',
    );
  });
});
