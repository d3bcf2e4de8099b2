export type Side = 'old' | 'new';

/** Milliseconds of both sides, one entry per turn. */
export type Times = Record<Side, number[]>;

const TURN: readonly Side[] = ['old', 'new', 'new', 'old'];
const OTHER_TURN: readonly Side[] = ['new', 'old', 'old', 'new'];

/**
 * Measures both sides twice per turn, in an order in which a steady drift and who begins make no difference, after one turn
 * that does not count.
 */
export async function alternate(turns: number, measure: (side: Side) => number | Promise<number>): Promise<Times> {
  const times: Times = { old: [], new: [] };
  for (let turn = -1; turn < turns; turn++) {
    const sums = { old: 0, new: 0 };
    for (const side of turn % 2 === 0 ? TURN : OTHER_TURN) sums[side] += (await measure(side)) / 2;
    if (turn < 0) continue;
    times.old.push(sums.old);
    times.new.push(sums.new);
  }
  return times;
}
