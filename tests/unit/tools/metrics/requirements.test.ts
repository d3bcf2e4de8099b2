import { describe, expect, it } from 'vitest';
import { describeMetrics, drawMetrics } from '../../../../tools/metrics/describeMetrics.mjs';
import { isKept, requirements } from '../../../../tools/metrics/requirements.mjs';

const flips = (share: number) => ({
  tilesPerObjectUnit: 3,
  spacing: 6,
  flips: [0.1, 0.5].map((degrees) => ({ degrees, share: share * degrees * 2 })),
});

const measured = (change = {}) => ({
  greyness: 0,
  ink: { 0.1: 0.11, 0.8: 0.79 },
  coherence: 0.92,
  strokeLength: 0.9,
  spacing: 6,
  edgeJump: { mean: 0, p95: 0, samples: 9 },
  light: flips(0.05),
  dolly: { flips: [0.1, 0.1, 0.15], popping: 1.5, luminance: [0.1], luminancePopping: 1 },
  zoom: { spacings: [6, 7], spread: 0.1, octaveSpread: 0.05 },
  ...change,
});

/** Models on which every technique keeps to everything, but for what is changed of one technique on the one named. */
function modelsWith(changed: string, change: object, technique: string) {
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
          hatching: measured(),
          engraving: measured(),
          'engraving, x': measured({ light: flips(0) }),
          'engraving, form': measured({ light: flips(0), ink: { 0.1: 0.105, 0.8: 0.795 } }),
          ...(name === changed && { [technique]: measured(change) }),
        },
      },
    ]),
  );
}

function missed(changed: string, change: object, technique = 'hatching'): string[] {
  const models = modelsWith(changed, change, technique) as never;
  return requirements.flatMap((requirement) =>
    Object.keys(requirement.limits)
      .filter((limited) => !isKept(requirement, limited, requirement.worst(models, limited)!.value))
      .map((limited) => `${limited}: ${requirement.name}`),
  );
}

describe('requirements', () => {
  it('are kept by strokes that keep them', () => {
    expect(missed('', {})).toEqual([]);
  });

  it.each([
    ['hatching', 'Greyness', { greyness: 0.006 }],
    ['hatching', 'Length of strokes', { strokeLength: 0.6 }],
    ['hatching', 'Mean jump', { edgeJump: { mean: 0.002, p95: 0, samples: 9 } }],
    ['hatching', 'Tone error', { ink: { 0.1: 0.1, 0.8: 0.77 } }],
    ['hatching', 'Flips', { light: flips(0.11) }],
    ['hatching', 'Popping index of', { dolly: { flips: [0.1], popping: 2.1 } }],
    ['hatching', 'Stroke spacing in', { zoom: { spacings: [], spread: 0.16 } }],
    ['engraving', 'Mean jump', { edgeJump: { mean: 0.002, p95: 0, samples: 9 } }],
    ['engraving', 'Tone error', { ink: { 0.1: 0.1, 0.8: 0.77 } }],
    ['engraving', 'Popping index of', { dolly: { popping: 1.6, luminancePopping: 1 } }],
    ['engraving', 'Popping index by', { dolly: { popping: 1, luminancePopping: 1.6 } }],
    ['engraving', 'Stroke spacing in', { zoom: { spread: 0.34, octaveSpread: 0 } }],
    ['engraving', 'Stroke spacing 1', { zoom: { spread: 0.1, octaveSpread: 0.11 } }],
    ['engraving', 'Coherence', { coherence: 0.89 }],
    ['engraving, x', 'Flips', { light: flips(0.001) }],
  ])('are missed by one figure on one model: %s, %s', (technique, name, change) => {
    const figures = technique === 'engraving, x' ? change : { light: flips(0.05), ...change };
    expect(missed('bunny', figures, technique)).toEqual([expect.stringContaining(`${technique}: ${name}`)]);
  });

  it('are missed by strokes that break up on a dense mesh', () => {
    expect(missed('dragon871k', { coherence: 0.86 })).toEqual([expect.stringContaining('hatching: Coherence')]);
  });

  it('ignore flips on the sphere, where the paper by Suarez et al. has none to compare with', () => {
    expect(missed('sphere', { light: flips(0.3) })).toEqual([]);
  });
});

describe('the page of the docs', () => {
  it('holds every model and technique, and what was not measured as an empty cell', () => {
    const models = modelsWith('bunny', { dolly: undefined, zoom: undefined, coherence: 0.5 }, 'engraving') as never;
    const pieces = { ink: 649, inkArea: 2, paper: 556, paperArea: 3 };
    const flat = { tone: 0.5, ink: 0.499, pieces, bands: [0.2, 0.1, 0.03, 0.02, 0.01] };
    const flatTones = {
      stipple: [
        { ...flat, coherence: 0.17 },
        { ...flat, coherence: NaN },
      ],
    };
    const strokes = { look: 'pen' as const, model: 'bunny', strokes: 501, median: 8.13, medianByInk: 14.46 };
    const printedStrokes = [{ ...strokes, crumbs: 0.325, crumbsByInk: 0.015 }];
    const page = describeMetrics({ renderer: 'a renderer', models, flatTones, printedStrokes });
    expect(page).toContain('| pen | bunny | 501 | 8.1 | 14.5 | 0.325 | 0.015 |');
    for (const name of ['sphere', 'bunny', 'dragon11k', 'dragon871k']) expect(page).toContain(`### ${name}, 11,000`);
    expect(page).not.toMatch(/undefined|NaN|null/);
    expect(page).toContain('| 0.5 | 0.499 | 649 of 2 | 556 of 3 | 0.200 | 0.100 | 0.030 | 0.020 | 0.010 | 0.170 |');
    expect(page, 'what is missed').toContain('**0.500 (bunny)**');
    expect(page.match(/\*\*0\.\d+ /g), 'nothing else').toHaveLength(1);
    expect(drawMetrics(models)).not.toMatch(/undefined|NaN/);
  });
});
