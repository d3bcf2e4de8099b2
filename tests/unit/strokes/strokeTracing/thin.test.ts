import { expect, test } from 'vitest';
import { thin } from '../../../../src/strokes/strokeTracing/thin.js';

/** Draws ink as text, thins it, and gives it back as text. */
function thinned(rows: readonly string[]): string[] {
  const width = rows[0].length;
  const mask = Uint8Array.from([...rows.join('')], (letter) => Number(letter === '#'));
  const steps = thin(mask, width, 4);
  let step = steps.next();
  while (!step.done) step = steps.next();
  expect([...step.value]).toEqual([...mask.keys()].filter((i) => mask[i] === 1));
  return rows.map((_, y) => Array.from(mask.subarray(y * width, (y + 1) * width), (ink) => (ink ? '#' : '.')).join(''));
}

test('a bar becomes a line along its middle', () => {
  const result = thinned(['............', '.##########.', '.##########.', '.##########.', '............']);
  expect(result.join('').replaceAll('.', '').length).toBeGreaterThan(6);
  for (const y of [0, 1, 3, 4]) expect(result[y]).toBe('............');
  expect(result[2]).toMatch(/^\.+#{7,}\.+$/);
});

test('a staircase keeps no corners: inside a line every pixel has two neighbours', () => {
  const size = 24;
  const rows = Array.from({ length: size }, (_, y) =>
    Array.from({ length: size }, (_, x) =>
      x > 1 && y > 1 && x < size - 2 && y < size - 2 && Math.abs(x - 0.6 * y - 4) < 2.3 ? '#' : '.',
    ).join(''),
  );
  const result = thinned(rows);
  const isInk = (x: number, y: number): boolean => result[y]?.[x] === '#';
  const counts = result.flatMap((row, y) =>
    [...row].flatMap((letter, x) => {
      if (letter !== '#') return [];
      let count = -1;
      for (const down of [-1, 0, 1]) for (const across of [-1, 0, 1]) count += Number(isInk(x + across, y + down));
      return [count];
    }),
  );
  expect(counts.filter((count) => count === 1)).toHaveLength(2);
  expect(counts.filter((count) => count === 2)).toHaveLength(counts.length - 2);
  expect(counts.length).toBeGreaterThan(14);
});
