/**
 * Which tests run: `quick` is the selection of `npm test`, `all` is every test, and `rest` is what `quick` leaves out.
 *
 * A test with the tag `all` is no part of `quick`. A test with the tag `more` is part of both, and tries fewer cases in `quick`, which it asks
 * {@link cases} for. Playwright writes a tag with an `@`.
 *
 * @typedef {'quick' | 'all' | 'rest'} Selection
 */

/** @type {readonly Selection[]} */
const SELECTIONS = ['quick', 'all', 'rest'];

/**
 * @param {string | undefined} text
 * @returns {Selection}
 * @throws where it names no selection
 */
export function readSelection(text) {
  const found = SELECTIONS.find((name) => name === text);
  if (!found) throw new Error(`readSelection: "${text}" is no selection of tests; there are ${SELECTIONS.join(', ')}.`);
  return found;
}

/**
 * The cases that a test tries. The environment variable HATCH_TESTS names the selection; where it is not set, all cases are tried.
 *
 * @template T
 * @param {T} quick - what `npm test` tries
 * @param {T} all - what `npm run test:all` and `npm run test:rest` try
 * @returns {T}
 */
export const cases = (quick, all) => (readSelection(process.env.HATCH_TESTS || 'all') === 'quick' ? quick : all);

/** The arguments by which a runner takes the tests of a selection. */
const FILTERS = {
  vitest: { quick: ['--tags-filter=!all'], rest: ['--tags-filter=all or more'], all: [] },
  playwright: { quick: ['--grep-invert=@all\\b'], rest: ['--grep=@(all|more)\\b'], all: [] },
};

/**
 * @param {keyof typeof FILTERS} runner
 * @param {Selection} selection
 * @returns {readonly string[]}
 */
export const argumentsOf = (runner, selection) => FILTERS[runner][selection];
