import { expect, test } from 'vitest';
import { random } from '../../../../src/strokes/random.js';
import { measureDistances } from '../../../../src/strokes/strokeTracing/thin.js';

test('every distance equals the brute-force distance to the nearest pixel of paper', () => {
  const [width, height] = [37, 23];
  for (const share of [0.5, 0.95, 0.995]) {
    const next = random(Math.round(1000 * share));
    const mask = Uint8Array.from({ length: width * height }, () => Number(next() < share));
    const steps = measureDistances(mask, width, height);
    let step = steps.next();
    while (!step.done) step = steps.next();
    const paper = [...mask.keys()].filter((i) => mask[i] === 0);
    const expected = Array.from(mask, (_, i) =>
      Math.min(
        ...paper.map((other) =>
          Math.hypot((other % width) - (i % width), Math.floor(other / width) - Math.floor(i / width)),
        ),
      ),
    );
    expect([...step.value]).toEqual(expected.map((distance) => expect.closeTo(distance, 5)));
  }
});
