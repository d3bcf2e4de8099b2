import { describe, expect, it } from 'vitest';
import { describeMetrics, drawMetrics } from '../../../metrics/describeMetrics.mjs';
import { requirements } from '../../../metrics/requirements.mjs';

const flips = (share: number) => ({
  strokeScale: 3,
  spacing: 6,
  flips: [0.1, 0.5].map((degrees) => ({ degrees, share: share * degrees * 2 })),
});

const measured = (change = {}) => ({
  greyness: 0,
  ink: { 0.1: 0.11, 0.8: 0.79 },
  coherence: 0.8,
  spacing: 6,
  edgeJump: { mean: 0, p95: 0, samples: 9 },
  light: flips(0.05),
  dolly: { flips: [0.1, 0.1, 0.15], popping: 1.5 },
  zoom: { spacings: [6, 7], spread: 0.1 },
  ...change,
});

/** Models on which `anchored` keeps to everything, but for what is changed on the one named. */
function modelsWith(changed: string, change: object) {
  const others = { adjacency: measured({ light: flips(0.3) }) };
  return Object.fromEntries(
    ['sphere', 'bunny', 'dragon11k', 'dragon871k'].map((name) => [
      name,
      {
        triangles: 11000,
        techniques: {
          ...others,
          'adjacency, crisp': measured(),
          triangle: measured(),
          anchored: measured(name === changed ? change : {}),
        },
      },
    ]),
  );
}

function missed(changed: string, change: object): string[] {
  return requirements
    .filter(({ limit, atLeast, worst }) => {
      const found = worst(modelsWith(changed, change) as never, 'anchored')!;
      return atLeast ? found.value < limit : found.value > limit;
    })
    .map(({ name }) => name);
}

describe('requirements', () => {
  it('are kept by strokes that keep them', () => {
    expect(missed('', {})).toEqual([]);
  });

  it.each([
    ['Greyness', { greyness: 0.006 }],
    ['Mean jump', { edgeJump: { mean: 0.002, p95: 0, samples: 9 } }],
    ['Tone error', { ink: { 0.1: 0.1, 0.8: 0.77 } }],
    ['Flips', { light: flips(0.11) }],
    ['Popping', { dolly: { flips: [0.1], popping: 2.1 } }],
    ['Stroke spacing', { zoom: { spacings: [], spread: 0.16 } }],
  ])('are missed by one figure on one model: %s', (name, change) => {
    expect(missed('bunny', change)).toEqual([expect.stringContaining(name)]);
  });

  it('are missed by strokes that break up on a dense mesh', () => {
    expect(missed('dragon871k', { coherence: 0.75 })).toEqual([expect.stringContaining('Coherence')]);
  });

  it('ignore flips on the sphere, where the paper by Suarez et al. has none to compare with', () => {
    expect(missed('sphere', { light: flips(0.3) })).toEqual([]);
  });
});

describe('the page of the docs', () => {
  it('holds every model and technique, and what was not measured as an empty cell', () => {
    const models = modelsWith('bunny', { dolly: undefined, zoom: undefined }) as never;
    const page = describeMetrics({ renderer: 'a renderer', models });
    for (const name of ['sphere', 'bunny', 'dragon11k', 'dragon871k']) expect(page).toContain(`### ${name}, 11,000`);
    expect(page).not.toMatch(/undefined|NaN|null/);
    expect(drawMetrics(models)).not.toMatch(/undefined|NaN/);
  });
});
