const TURNS = 8;
const TURN_MILLISECONDS = 250;

/**
 * Waits two seconds for an answer. The time is counted in turns of a timer, so that it does not run out while the page is busy: the answer
 * may have arrived by then, and wait for the page.
 *
 * @throws the reason for which the answer rejects, or an Error if none comes in time
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
