import { afterEach, expect, test, vi } from 'vitest';
import { argumentsOf, cases, readSelection } from '../selection.mjs';

afterEach(() => {
  vi.unstubAllEnvs();
});

/** Whether Playwright takes a test by the arguments of a selection. */
function takes(selection: 'quick' | 'all' | 'rest', title: string): boolean {
  return argumentsOf('playwright', selection).every((argument) => {
    const [, flag, pattern] = /^--(grep|grep-invert)=(.*)$/.exec(argument)!;
    return new RegExp(pattern!).test(title) === (flag === 'grep');
  });
}

test.each([
  ['a test', { quick: true, rest: false, all: true }],
  ['a test @all', { quick: false, rest: true, all: true }],
  ['a test @more', { quick: true, rest: true, all: true }],
  ['a test @allowed', { quick: true, rest: false, all: true }],
])('%s is taken by %o', (title, expected) => {
  const { quick, rest, all } = { quick: takes('quick', title), rest: takes('rest', title), all: takes('all', title) };
  expect({ quick, rest, all }).toEqual(expected);
});

test.each([
  ['quick', 1],
  ['rest', 2],
  ['all', 2],
  ['', 2],
])('HATCH_TESTS=%s tries %i cases', (selection, expected) => {
  vi.stubEnv('HATCH_TESTS', selection);
  expect(cases(1, 2)).toBe(expected);
});

test('a selection that does not exist is named', () => {
  expect(() => readSelection('quik')).toThrow(
    'readSelection: "quik" is no selection of tests; there are quick, all, rest.',
  );
});
