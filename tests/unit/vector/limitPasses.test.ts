import { describe, expect, test } from 'vitest';
import { runToEnd } from '../../../src/mesh/phases.js';
import type { PathLayer } from '../../../src/vector/LineDrawer.js';
import { dashes, type LinePath, pathLength } from '../../../src/vector/paths/LinePath.js';
import { limitPasses, type Penned } from '../../../src/vector/plot/limitPasses.js';

const PEN = 1;
const SIZE = 60;
/** Samples per pixel. */
const SAMPLES = 8;

const line = (...xy: number[]): LinePath => ({
  points: Array.from({ length: xy.length / 2 }, (_, i) => [xy[2 * i], xy[2 * i + 1], PEN / 2, PEN / 2]).flat(),
  isClosed: false,
});

const layer = (name: PathLayer['name'], paths: LinePath[]): PathLayer => ({
  ...{ name, paths, ink: '#000000', group: '', opacity: 1 },
});

const limited = (penned: Partial<Penned>, passes = 2, shortest = 0): Penned =>
  runToEnd(
    limitPasses(
      { lines: [], dots: [], ...penned },
      { passes, shortest, widthOf: () => PEN, width: SIZE, height: SIZE },
    ),
  );

/** Parallel lines over the whole picture, so far apart; those across run downwards. */
const hatching = (apart: number, isAcross = false): LinePath[] =>
  Array.from({ length: Math.floor(SIZE / apart) }, (_, i) => {
    const at = (i + 0.5) * apart;
    return isAcross ? line(at, 0, at, SIZE) : line(0, at, SIZE, at);
  });

const diagonals = (apart: number): LinePath[] =>
  Array.from({ length: Math.floor((2 * SIZE) / apart) }, (_, i) => {
    const at = (i + 0.5) * apart;
    return line(Math.max(at - SIZE, 0), Math.min(at, SIZE), Math.min(at, SIZE), Math.max(at - SIZE, 0));
  });

/** The number of passes over each sample of the picture. */
function passesOver({ lines, dots }: Penned): Uint8Array {
  const side = SIZE * SAMPLES;
  const counts = new Uint8Array(side * side);
  const cover = (left: number, top: number, right: number, bottom: number, isIn: (x: number, y: number) => boolean) => {
    const [from, to] = [Math.max(Math.floor(left * SAMPLES), 0), Math.min(Math.ceil(right * SAMPLES), side)];
    for (let row = Math.max(Math.floor(top * SAMPLES), 0); row < Math.min(Math.ceil(bottom * SAMPLES), side); row++)
      for (let column = from; column < to; column++)
        counts[row * side + column] += Number(isIn((column + 0.5) / SAMPLES, (row + 0.5) / SAMPLES));
  };
  for (const { points } of lines.flatMap(({ paths }) => paths)) {
    const [x, y, toX, toY] = [0, 1, points.length - 4, points.length - 3].map((i) => points[i]);
    const [dx, dy] = [toX - x, toY - y];
    const box = [Math.min(x, toX) - 1, Math.min(y, toY) - 1, Math.max(x, toX) + 1, Math.max(y, toY) + 1] as const;
    cover(...box, (px, py) => {
      const t = Math.min(Math.max(((px - x) * dx + (py - y) * dy) / (dx * dx + dy * dy), 0), 1);
      return Math.hypot(px - x - t * dx, py - y - t * dy) <= PEN / 2;
    });
  }
  for (const { x, y, radius } of dots.flatMap((one) => one.dots)) {
    const reach = Math.max(radius, PEN / 2);
    cover(x - reach, y - reach, x + reach, y + reach, (px, py) => Math.hypot(px - x, py - y) <= reach);
  }
  return counts;
}

/** The share of what is inked that has at least so many passes. Lines are straight. */
function shareOf(penned: Penned, least: number): number {
  const counts = passesOver(penned);
  return counts.filter((count) => count >= least).length / counts.filter((count) => count > 0).length;
}

const lengthOf = (paths: readonly LinePath[]): number => paths.reduce((sum, path) => sum + pathLength(path), 0);

describe('pens pass no more often than they may', () => {
  const crossed = [
    layer('lines', hatching(2)),
    layer('crossing', hatching(2, true)),
    layer('shadows', diagonals(2)),
  ] as const;

  test('over lines of three families, of which the last gives way', () => {
    const penned = { lines: crossed, dots: [] };
    expect(shareOf(penned, 3)).toBeGreaterThan(0.1);
    const left = limited(penned);
    expect(shareOf(left, 3)).toBeLessThan(0.01);
    expect(left.lines.slice(0, 2)).toEqual(crossed.slice(0, 2));
    expect(lengthOf(left.lines[2].paths)).toBeLessThan(0.3 * lengthOf(crossed[2].paths));
  });

  test('once, twice or three times', () => {
    const lines = [...crossed, layer('background', hatching(2.5))];
    expect(limited({ lines: crossed }, 3).lines).toEqual(crossed);
    expect(shareOf(limited({ lines }, 3), 4)).toBeLessThan(0.02);
    expect(shareOf(limited({ lines }, 1), 2)).toBeLessThan(0.05);
  });

  test('and a line ends where another pair covers its width, with clean ends', () => {
    const two = [line(30, 0, 30, 60), line(30.2, 0, 30.2, 60)];
    const { lines } = limited({ lines: [layer('outlines', two), layer('lines', [line(0, 20, 30, 20)])] });
    const [[left]] = [lines[1].paths];
    expect(left.points[4]).toBeGreaterThan(28.5);
    expect(left.points[4]).toBeLessThan(30);
  });

  test('a line goes on across a place as wide as a pen: a gap would cost a lift', () => {
    const two = [line(30, 0, 30, 60), line(30, 0, 30, 60)];
    const crossing = line(0, 20, 60, 20);
    expect(limited({ lines: [layer('outlines', two), layer('lines', [crossing])] }).lines[1].paths).toEqual([crossing]);
  });

  test('of a line between wide dark bands no crumbs are left', () => {
    const bands = [10, 24].flatMap((x) => Array.from({ length: 22 }, (_, k) => line(x + 0.5 * k, 0, x + 0.5 * k, 60)));
    const { lines } = limited({ lines: [layer('outlines', bands), layer('lines', [line(0, 20, 60, 20)])] });
    const lengths = lines[1].paths.map(pathLength);
    expect(lengths).toHaveLength(2);
    expect(Math.min(...lengths)).toBeGreaterThan(8);
  });

  test('dashes stay whole or go', () => {
    const all = dashes(line(0, 20, 60, 20), 3, 2);
    const wall = Array.from({ length: 42 }, (_, k) => line(20 + 0.5 * k, 0, 20 + 0.5 * k, 60));
    const { lines } = limited({ lines: [layer('outlines', wall), layer('hidden', all)] });
    expect(lines[1].paths.length).toBeLessThan(all.length - 2);
    for (const dash of lines[1].paths) expect(all).toContain(dash);
  });

  test('dots are left out where others lie, and none elsewhere', () => {
    const dots = Array.from({ length: 4000 }, (_, i) => {
      const [x, y] = [(i * 0.754877666) % 1, (i * 0.569840291) % 1];
      return { x: 5 + 20 * x, y: 5 + 20 * y, radius: 0.5 };
    });
    const lone = { x: 50, y: 50, radius: 2 };
    const penned = { dots: [{ ink: '#000000', group: '', dots: [...dots, lone] }] };
    const left = limited(penned);
    expect(shareOf({ lines: [], dots: penned.dots }, 3)).toBeGreaterThan(0.9);
    expect(shareOf(left, 3)).toBeLessThan(0.04);
    expect(left.dots[0].dots).toContain(lone);
    // The dark stays dark: the square, without the rims of its dots.
    const inked = passesOver({
      lines: [],
      dots: [{ ...left.dots[0], dots: left.dots[0].dots.filter((dot) => dot !== lone) }],
    });
    expect(inked.filter((count) => count > 0).length / SAMPLES ** 2).toBeGreaterThan(0.97 * 20 * 20);
  });

  test('a ring stays closed where it is free, and a line that crosses itself is whole', () => {
    const around = Array.from({ length: 24 }, (_, i) => [
      30 + 9 * Math.cos(i / 3.82),
      30 + 9 * Math.sin(i / 3.82),
    ]).flat();
    const ring = { ...line(...around), isClosed: true };
    const loops = line(10, 50, 50, 52, 50, 56, 30, 40, 30, 58);
    expect(limited({ lines: [layer('lines', [ring, loops])] }, 1).lines[0].paths).toEqual([ring, loops]);
  });

  test('lines that are too short to be drawn take no place', () => {
    const short = [line(29, 20, 31, 20), line(29, 20.1, 31, 20.1)];
    const crossing = line(30, 0, 30, 60);
    const { lines } = limited({ lines: [layer('outlines', short), layer('lines', [crossing])] }, 1, 4);
    expect(lines.map(({ paths }) => paths)).toEqual([[], [crossing]]);
  });
});
