const TURNS = 8;
const TURN_MILLISECONDS = 250;

/**
 * What comes within two seconds. They are counted in turns, so that none passes while the page is busy: an answer may be there by
 * then, and wait for the page.
 *
 * @throws what it rejects with; an Error if nothing comes
 */
export async function inTime<Result>(answer: Promise<Result>): Promise<Result> {
  const settled = answer.then(
    () => true,
    () => true,
  );
  for (let i = 0; i < TURNS; i++) {
    const turn = new Promise<boolean>((resolve) => setTimeout(resolve, TURN_MILLISECONDS, false));
    if (await Promise.race([settled, turn])) return answer;
  }
  throw new Error('The browser does not answer.');
}
