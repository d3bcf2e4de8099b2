/**
 * A time at which a run begins no further test: HATCH_UNTIL, in milliseconds since 1970. `.ci/run` sets it for the tests that `npm test` leaves
 * out, so that a slow machine ends with the results it has. Without it, a run has no end but its own.
 */

/** Why a test was left out. */
export const TIME_IS_UP = 'The time of this run was up.';

export const isTimeUp = () => Date.now() > Number(process.env.HATCH_UNTIL || Infinity);

/**
 * The tests of a JSON report of Playwright that were left out because the time was up.
 *
 * @param {any} report
 * @returns {number}
 */
export function leftOut(report) {
  let count = 0;
  const visit = ({ specs = [], suites = [] }) => {
    for (const { annotations } of specs.flatMap(({ tests }) => tests)) {
      if (annotations.some(({ description }) => description === TIME_IS_UP)) count += 1;
    }
    suites.forEach(visit);
  };
  visit(report ?? {});
  return count;
}
