import { Mesh, PlaneGeometry, SphereGeometry, TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

const PEN = 0.3;
const SMALL: DrawSVGOptions = { kind: 'pen', penWidth: PEN, sheet: [60, 60], margin: 0 };

/** Distance between the places of lines that are measured, millimetres. */
const EVERY = 0.7;
/** The least cosine between neighbours. */
const PARALLEL = 0.9;

/** The distances of places on lines from the lines on both sides, where both are there. */
function gapsOf(lines: readonly number[][]): [number, number][] {
  const gaps: [number, number][] = [];
  for (const line of lines) {
    let next = 0.5 * EVERY;
    for (let o = 2; o < line.length; o += 2) {
      const [dx, dy] = [line[o] - line[o - 2], line[o + 1] - line[o - 1]];
      const length = Math.hypot(dx, dy);
      for (; next < length; next += EVERY) {
        const [x, y] = [line[o - 2] + (next / length) * dx, line[o - 1] + (next / length) * dy];
        const nearest = [Infinity, Infinity];
        for (const other of lines) if (other !== line) meet(other, [x, y], [-dy / length, dx / length], nearest);
        if (nearest[0] < Infinity && nearest[1] < Infinity) gaps.push([nearest[0], nearest[1]]);
      }
      next -= length;
    }
  }
  return gaps;
}

/** Keeps the distances at which a line crosses the normal of a place, on one side and on the other. */
function meet(line: readonly number[], [x, y]: number[], [nx, ny]: number[], nearest: number[]): void {
  for (let k = 2; k < line.length; k += 2) {
    const [ax, ay] = [line[k - 2] - x, line[k - 1] - y];
    const [dx, dy] = [line[k] - line[k - 2], line[k + 1] - line[k - 1]];
    const turn = dx * ny - dy * nx;
    if (Math.abs(turn) < PARALLEL * Math.hypot(dx, dy)) continue;
    const along = (nx * ay - ny * ax) / turn;
    if (!(along >= 0 && along <= 1)) continue;
    const gap = (dx * ay - dy * ax) / turn;
    const side = gap > 0 ? 0 : 1;
    nearest[side] = Math.min(nearest[side], Math.abs(gap));
  }
}

const share = (list: readonly unknown[], count: number): number => count / list.length;

describe('lines of a pen are evenly apart', { tags: ['more'] }, () => {
  test.each(cases([0.45], [0.15, 0.45, 0.7]))('on a plane of the tone %s', async (tone) => {
    const { svg } = await drawSVG(sceneOf(await planeOfTone(tone)), cameraAt(0, 0, 1, true), SMALL);
    const gaps = gapsOf(pathsOf(svg, 'lines').flatMap(ringsOf));
    expect(gaps.length).toBeGreaterThan(30);
    const middle = gaps.map(([a, b]) => 0.5 * (a + b)).sort((a, b) => a - b)[gaps.length >> 1];
    expect(Math.abs((middle * tone) / PEN - 1)).toBeLessThan(0.06);
    const uneven = gaps.filter(([a, b]) => Math.max(a, b) > 1.5 * Math.min(a, b)).length;
    expect(share(gaps, uneven)).toBeLessThan(0.06);
  });

  test('on a ring more evenly than on the canvas', async () => {
    const ring = await hatchedMesh(new TorusGeometry(0.65, 0.35, 32, 64));
    const unevenShare = async (lines: 'even' | 'canvas') => {
      const { svg } = await drawSVG(sceneOf(ring), cameraAt(0.5, 0.4, 1), { ...SMALL, lines });
      const gaps = gapsOf(pathsOf(svg, 'lines').flatMap(ringsOf)).filter((both) => Math.max(...both) < 2.5);
      return share(gaps, gaps.filter(([a, b]) => Math.max(a, b) > 1.5 * Math.min(a, b)).length);
    };
    const even = await unevenShare('even');
    const canvas = await unevenShare('canvas');
    expect(even).toBeLessThan(0.5 * canvas);
  });
});

describe('the block of a woodcut is filled along its cuts', () => {
  const block = async (tone: number) => {
    const plane = await planeOfTone(tone, { technique: 'woodcut' });
    return drawSVG(sceneOf(plane), cameraAt(0, 0, 1, true), SMALL);
  };

  test('at 0.85 of the pen', async () => {
    const gaps = gapsOf(pathsOf((await block(1)).svg, 'lines').flatMap(ringsOf));
    expect(gaps.length).toBeGreaterThan(1000);
    const sorted = gaps.map(([a, b]) => 0.5 * (a + b)).sort((a, b) => a - b);
    expect(Math.abs(sorted[sorted.length >> 1] / (0.85 * PEN) - 1)).toBeLessThan(0.05);
    expect(share(gaps, gaps.filter((both) => Math.max(...both) > PEN).length)).toBeLessThan(0.02);
  });

  test('so that cuts leave the tone', async () => {
    for (const tone of [0.3, 0.6]) {
      const { drawn } = await block(tone);
      expect(Math.abs((drawn * 0.85 * PEN) / 60 ** 2 - tone)).toBeLessThan(0.05);
    }
  });
});

test('lines end where their surface ends', async () => {
  const plane = await planeOfTone(0.4);
  const small = new Mesh(plane.geometry, plane.material);
  small.scale.setScalar(0.4);
  const { svg } = await drawSVG(sceneOf(small), cameraAt(0, 0, 1, true), SMALL);
  // The plane is 1.2 units of a picture of 2.1, which leaves room for half the pen.
  const [low, high] = [-1, 1].map((side) => 30 + (side * (30 - PEN / 2) * 0.6) / 1.05);
  const ends = pathsOf(svg, 'lines')
    .flatMap(ringsOf)
    .flatMap((line) => [line.slice(0, 2), line.slice(-2)]);
  const beyond = ends.map(([x, y]) => Math.max(low - x, x - high, low - y, y - high));
  expect(Math.max(...beyond)).toBeLessThan(0.03);
  // Most lines run from border to border.
  expect(share(ends, beyond.filter((way) => way > -0.03).length)).toBeGreaterThan(0.7);
});

test('surfaces keep their inks and their directions', async () => {
  const balls = await Promise.all(
    (['#aa0000', '#0000aa'] as const).map(async (ink, i) => {
      const ball = await hatchedMesh(new SphereGeometry(0.45, 32, 24), {
        outlines: false,
        material: { ink, direction: i === 0 ? 'y' : 'x', irregularity: 0, crossFrom: 1 },
      });
      ball.position.x = i === 0 ? -0.5 : 0.5;
      return ball;
    }),
  );
  const { svg } = await drawSVG(sceneOf(...balls), cameraAt(0, 0, 1, true), SMALL);
  for (const [i, ink] of ['#aa0000', '#0000aa'].entries()) {
    const lines = pathsOf(svg, `lines ${ink}`).flatMap(ringsOf);
    expect(lines.length).toBeGreaterThan(10);
    for (const line of lines) for (let o = 0; o < line.length; o += 2) expect(line[o] < 30).toBe(i === 0);
    const [across, down] = [0, 1].map((axis) =>
      lines.reduce((sum, line) => {
        let way = 0;
        for (let o = 2 + axis; o < line.length; o += 2) way += Math.abs(line[o] - line[o - 2]);
        return sum + way;
      }, 0),
    );
    expect(i === 0 ? across : down).toBeGreaterThan(1.5 * (i === 0 ? down : across));
  }
});

test('twice the same bytes', async () => {
  const ball = await hatchedMesh(new SphereGeometry(1, 32, 24));
  const [one, other] = [
    await drawSVG(sceneOf(ball), cameraAt(0.5, 0.4, 1), SMALL),
    await drawSVG(sceneOf(ball), cameraAt(0.5, 0.4, 1), SMALL),
  ];
  expect(other.svg).toBe(one.svg);
});

test('where the plane of a picture is behind another, its lines end there', async () => {
  const [behind, before] = [
    await planeOfTone(0.4),
    await hatchedMesh(new PlaneGeometry(0.8, 0.8), {
      outlines: false,
      material: {
        toneCurve: [
          [0, 0],
          [1, 0],
        ],
        hollowStrength: 0,
      },
    }),
  ];
  before.position.z = 0.2;
  const { svg } = await drawSVG(sceneOf(behind, before), cameraAt(0, 0, 1, true), SMALL);
  const [low, high] = [-1, 1].map((side) => 30 + (side * (30 - PEN / 2) * 0.4) / 1.05);
  const points = pathsOf(svg)
    .flatMap(ringsOf)
    .flatMap((line) => line.filter((_, o) => o % 2 === 0).map((x, k) => [x, line[2 * k + 1]]));
  const within = points.map(([x, y]) => Math.min(x - low, high - x, y - low, high - y));
  expect(Math.max(...within)).toBeLessThan(0.03);
  expect(within.filter((way) => Math.abs(way) < 0.03).length).toBeGreaterThan(20);
});
