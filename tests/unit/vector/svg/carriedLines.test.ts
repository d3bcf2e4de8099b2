import { SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG, type SVGDrawing } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

const PEN = 0.3;
const SMALL: DrawSVGOptions = { kind: 'pen', penWidth: PEN, sheet: [60, 60], margin: 0, shadows: false };
/** Millimetres on the sheet per unit of the world, for an orthographic camera. */
const SCALE = (60 - PEN) / 2.1;
/** The distance of places on lines that are compared, and a quarter of the distance between lines of each layer, millimetres. */
const EVERY = 0.2;
const NEAR: Readonly<Record<string, number>> = { lines: 0.15, crossing: 0.25 };

const ball = async () =>
  sceneOf(await hatchedMesh(new SphereGeometry(1, 96, 64), { outlines: false, material: { irregularity: 0 } }));

/** A camera around the ball. @param turn radians */
const cameraTurned = (turn: number) => cameraAt(Math.sin(turn), 0, Math.cos(turn), true);

/** Draws frames of a turn. @param angles radians */
async function framesOf(angles: readonly number[]): Promise<SVGDrawing[]> {
  const scene = await ball();
  const frames: SVGDrawing[] = [];
  for (const angle of angles)
    frames.push(await drawSVG(scene, cameraTurned(angle), { ...SMALL, before: frames.at(-1) ?? null }));
  return frames;
}

/** Where a place on the sheet lies after the camera has turned around the ball, unless it goes out of sight. */
function afterTurn([x, y]: readonly number[], turn: number): readonly [number, number] | null {
  const [across, up] = [(x - 30) / SCALE, (30 - y) / SCALE];
  const square = 1 - across * across - up * up;
  if (square < 0.1) return null;
  const depth = Math.sqrt(square);
  const [sine, cosine] = [Math.sin(-turn), Math.cos(turn)];
  if (depth * cosine - across * sine < 0.3) return null;
  return [30 + SCALE * (across * cosine + depth * sine), y];
}

/** Places along lines. */
function placesOn(lines: readonly number[][]): [number, number][] {
  const places: [number, number][] = [];
  for (const line of lines)
    for (let o = 2; o < line.length; o += 2) {
      const [x, y, dx, dy] = [line[o - 2], line[o - 1], line[o] - line[o - 2], line[o + 1] - line[o - 1]];
      const count = Math.ceil(Math.hypot(dx, dy) / EVERY);
      for (let k = 0; k < count; k++) places.push([x + (k / count) * dx, y + (k / count) * dy]);
    }
  return places;
}

/** The share of the length of lines that the next frame has where they lie on the surface. */
function keptShare(before: string, after: string, turn: number, layer: string): number {
  const there = placesOn(pathsOf(after, layer).flatMap(ringsOf));
  const moved = placesOn(pathsOf(before, layer).flatMap(ringsOf)).flatMap((place) => {
    const now = afterTurn(place, turn);
    return now ? [now] : [];
  });
  const near = NEAR[layer];
  const cellOf = (x: number, y: number): string => `${Math.floor(x / near)} ${Math.floor(y / near)}`;
  const cells = new Map<string, [number, number][]>();
  for (const place of there) cells.set(cellOf(...place), [...(cells.get(cellOf(...place)) ?? []), place]);
  const around = [-near, 0, near];
  const isThere = ([x, y]: readonly [number, number]): boolean =>
    around.some((dx) =>
      around.some((dy) => cells.get(cellOf(x + dx, y + dy))?.some(([px, py]) => Math.hypot(px - x, py - y) < near)),
    );
  return moved.filter(isThere).length / moved.length;
}

const DEGREE = Math.PI / 180;

test('after half a degree the lines of the frame before lie where they lay on the surface', async () => {
  const turn = 0.5 * DEGREE;
  const [before, after] = await framesOf([0, turn]);
  const alone = await drawSVG(await ball(), cameraTurned(turn), SMALL);
  for (const layer of ['lines', 'crossing']) {
    expect(keptShare(before.svg, after.svg, turn, layer), layer).toBeGreaterThan(0.95);
    expect(keptShare(before.svg, alone.svg, turn, layer), layer).toBeLessThan(0.8);
  }
  expect(alone.surfaceLines).toBeNull();
});

test('after many frames there is as much ink as in a picture of its own, in few more lines', {
  tags: ['all'],
}, async () => {
  const angles = Array.from({ length: 7 }, (_, i) => 5 * i * DEGREE);
  const last = (await framesOf(angles)).at(-1)!;
  const alone = await drawSVG(await ball(), cameraTurned(angles.at(-1)!), SMALL);
  expect(last.paths).toBeLessThan(1.6 * alone.paths);
  expect(Math.abs(last.drawn / alone.drawn - 1)).toBeLessThan(0.05);
});

test('lines of another scene are not carried', async () => {
  const [{ surfaceLines }] = await framesOf([0]);
  const other = sceneOf(await hatchedMesh(new SphereGeometry(1, 48, 32), { outlines: false }));
  const [carried, first] = [
    await drawSVG(other, cameraTurned(0), { ...SMALL, before: { surfaceLines } }),
    await drawSVG(other, cameraTurned(0), { ...SMALL, before: null }),
  ];
  expect(carried.svg).toBe(first.svg);
});
