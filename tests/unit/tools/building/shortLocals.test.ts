import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { sharedNames, withShortLocals } from '../../../../tools/building/shortLocals.js';
import { shortened } from '../../../../tools/building/shortShaders.js';

const none: ReadonlySet<string> = new Set();

test('parameters and variables of a function become letters, in the order in which they come', () => {
  const text = 'float mean(const float first,const float second){float sum=first+second;return .5*sum;}';
  expect(withShortLocals(text, none)).toBe('float mean(const float a,const float b){float c=a+b;return .5*c;}');
});

test('a letter that the function knows already is not given again', () => {
  expect(withShortLocals('float f(float width){return a*width;}', none)).toBe('float f(float b){return a*b;}');
});

test('members, functions and what is called by its name keep their names', () => {
  const text = 'vec2 f(Ray ray,float max){return ray.ray+other(max(ray.max,ray.x));}';
  expect(withShortLocals(text, none)).toBe('vec2 f(Ray a,float max){return a.ray+other(max(a.max,a.x));}');
});

test('what macros mention and what comes from outside keeps its name', () => {
  const shared = sharedNames(['#define WIDTH(line) cut(depth, line)\nuniform float tone;']);
  const text = 'float f(float depth,float line,float tone,float other){return WIDTH(other);}';
  expect(withShortLocals(text, shared)).toBe('float f(float depth,float line,float tone,float a){return WIDTH(a);}');
});

test('a function that includes another file keeps its names', () => {
  const text = 'void f(vec3 place){\n#include "walk"\n}\nfloat g(float place){return place;}';
  expect(withShortLocals(text, none)).toBe(text.replace('g(float place){return place;}', 'g(float a){return a;}'));
});

/**
 * Names by where they come first, and what else is in a text, members included: two texts have the same if one is the other with names
 * exchanged.
 */
function pattern(text: string): (string | number)[] {
  const words: string[] = text.match(/\.?\w+|[^\s\w]/g) ?? [];
  return words.map((word) => (/^[a-z_]\w*$/i.test(word) ? words.indexOf(word) : word));
}

describe('every function that is shipped', () => {
  const texts = readdirSync('shaders', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => shortened(readFileSync(`${parentPath}/${name}`, 'utf8')));
  const shared = sharedNames(texts);
  const functions = (text: string): string[] => text.split(/\n(?=\w+ \w+\()/);

  test('is the same but for names', () => {
    for (const text of texts) {
      const short = functions(withShortLocals(text, shared));
      expect(short.length).toBe(functions(text).length);
      for (const [i, code] of functions(text).entries()) expect(pattern(short[i]), code).toEqual(pattern(code));
    }
  });
});
