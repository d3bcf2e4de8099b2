export type Side = 'old' | 'new';

/** Milliseconds of both sides, one entry per turn. */
export type Times = Record<Side, number[]>;

const TURN: readonly Side[] = ['old', 'new', 'new', 'old'];
const OTHER_TURN: readonly Side[] = ['new', 'old', 'old', 'new'];

/** The number of measured turns: at least `turns`, and as many short ones as fill the time, but at most four times `turns`. */
export interface Effort {
  turns: number;
  milliseconds: number;
}

/**
 * Measures both sides twice per turn, in an order that cancels a steady drift and the advantage of going first, after one turn
 * that does not count.
 */
export async function alternate(effort: Effort, measure: (side: Side) => number | Promise<number>): Promise<Times> {
  const times: Times = { old: [], new: [] };
  const isEnough = (turn: number, start: number): boolean =>
    turn >= effort.turns && (turn >= 4 * effort.turns || performance.now() - start > effort.milliseconds);
  const start = performance.now();
  for (let turn = -1; !isEnough(turn, start); turn++) {
    const sums = { old: 0, new: 0 };
    for (const side of turn % 2 === 0 ? TURN : OTHER_TURN) sums[side] += (await measure(side)) / 2;
    if (turn < 0) continue;
    times.old.push(sums.old);
    times.new.push(sums.new);
  }
  return times;
}
