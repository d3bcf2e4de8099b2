import { describe, expect, test } from 'vitest';
import { resolveIncludes } from '../../../../src/material/shaders/shaderText.js';

describe('resolveIncludes', () => {
  test('replaces our includes, nested ones too, and keeps the rest', () => {
    const source = 'a\n  #include "outer"\nb';
    const chunks = { outer: 'outer {\n#include "inner"\n}', inner: 'inner' };
    expect(resolveIncludes(source, chunks)).toBe('a\nouter {\ninner\n}\nb');
  });

  test("leaves three's includes to three", () => {
    expect(resolveIncludes('#include <common>\n', {})).toBe('#include <common>\n');
  });

  test('a chunk with a dollar sign arrives as it is', () => {
    expect(resolveIncludes('#include "money"', { money: "$& $1 $'" })).toBe("$& $1 $'");
  });

  test('a missing chunk is named', () => {
    expect(() => resolveIncludes('#include "nothing"', { something: '' })).toThrow('no shader chunk "nothing"');
  });

  test('a name may have a folder', () => {
    expect(resolveIncludes('#include "folder/name"', { 'folder/name': 'text' })).toBe('text');
  });

  test('a name that no chunk could have is missing all the same', () => {
    expect(() => resolveIncludes('#include "to String"', {})).toThrow('no shader chunk "to String"');
    expect(() => resolveIncludes('#include "toString"', {})).toThrow('no shader chunk "toString"');
  });

  test('a chunk that includes itself is named, by whatever way it does', () => {
    const chunks = { a: '#include "b"', b: '#include "a"' };
    expect(() => resolveIncludes('#include "a"', chunks)).toThrow('"a", or it includes itself');
  });

  test('the same chunk twice is no circle', () => {
    expect(resolveIncludes('#include "a"\n#include "a"', { a: 'x' })).toBe('x\nx');
  });
});
