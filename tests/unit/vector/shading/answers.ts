import { expect, test } from 'vitest';

type Answer = number | readonly Answer[] | null;

/**
 * Declares a test that a function gives the answer after the arrow for the arguments before it. Answers were worked out once, by an
 * implementation that shared no code with it; those below a derivation (#) by hand. They do not follow the shaders.
 *
 * @param rows a line each, in JSON with `Infinity`
 */
export function answers<Args extends unknown[]>(
  title: string,
  of: (...args: Args) => Answer,
  rows: string,
  digits = 6,
): void {
  const near = (answer: Answer): unknown =>
    typeof answer === 'number' ? expect.closeTo(answer, digits) : (answer?.map(near) ?? null);
  const read = (text: string) => JSON.parse(`[${text.replaceAll('Infinity', '1e999')}]`);
  const lines = rows.split('\n').map((line) => line.trim());
  test(title, () => {
    for (const line of lines.filter((line) => line !== '' && !line.startsWith('#'))) {
      const [given, answer] = line.split('→').map(read);
      expect(of(...(given as Args)), line).toEqual(near(answer[0]));
    }
  });
}
