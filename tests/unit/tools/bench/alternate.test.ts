import { expect, test } from 'vitest';
import { alternate, type Side } from '../../../../tools/bench/compare/alternate.js';

test('both sides are measured twice a turn, in an order that a steady drift does not favour', async () => {
  const order: Side[] = [];
  const times = await alternate({ turns: 2, milliseconds: 0 }, (side) => order.push(side));
  const [one, other] = ['old new new old', 'new old old new'];
  expect(order.join(' ')).toBe(`${other} ${one} ${other}`);
  // The clock of this test goes on by one with every measurement; the first turn only warms up.
  expect(times).toEqual({ old: [6.5, 10.5], new: [6.5, 10.5] });
});

test('turns go on while there is time, up to four times what is asked for', async () => {
  const { old } = await alternate({ turns: 3, milliseconds: 60_000 }, () => 1);
  expect(old).toHaveLength(12);
});
