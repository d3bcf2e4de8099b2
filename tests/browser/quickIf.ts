import type { TestDetails } from '@playwright/test';

/** The details of a test that `npm test` runs only where a condition holds. `npm run test:all` runs it anyway. */
export const quickIf = (isQuick: boolean): TestDetails => (isQuick ? {} : { tag: '@all' });

/**
 * `npm test` runs only the named cases of a list.
 *
 * @param names of all cases
 * @param quick the names of those that `npm test` runs
 * @returns the details of a case's test, by its name
 * @throws where a name is that of no case
 */
export function quickOnly(names: readonly string[], quick: readonly string[]): (name: string) => TestDetails {
  const missing = quick.filter((name) => !names.includes(name));
  if (missing.length > 0) throw new Error(`quickOnly: no case is named ${missing.join('; ')}.`);
  return (name) => quickIf(quick.includes(name));
}
