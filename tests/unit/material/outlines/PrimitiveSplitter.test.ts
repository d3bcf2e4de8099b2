import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import { type OutlineData, outlineDataOf } from '../../../../src/material/geometry/OutlineData.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { NO_PART, splitterOf } from '../../../../src/material/outlines/PrimitiveSplitter.js';
import {
  BORDER,
  CREASE,
  IS_EDGE,
  MATERIAL_BORDER,
  POINT_BITS,
  PRIMITIVE_WORDS,
} from '../../../../src/mesh/bake/outlineLayout.js';

const outlinesOf = async (geometry: BufferGeometry): Promise<OutlineData> =>
  outlineDataOf(await prepareHatchingGeometry(geometry, { outlines: true, layout: 'indexed' }))!;

function flagsOf({ primitives, triangleCount, edgeCount }: OutlineData): number[] {
  const words = primitives.image.data as Uint32Array;
  return Array.from({ length: edgeCount }, (_, edge) => {
    const o = PRIMITIVE_WORDS * (triangleCount + edge);
    return (words[o] >>> POINT_BITS) | ((words[o + 1] >>> POINT_BITS) << 4);
  });
}

const count = (flags: readonly number[], flag: number): number => flags.filter((each) => (each & flag) !== 0).length;

/** The parts of triangles by groups of two, as on the sides of a box. */
const bySides = (sides: readonly number[]): Int32Array => Int32Array.from(sides.flatMap((side) => [side, side]));

test('a single part has all outlines', async () => {
  const data = await outlinesOf(new BoxGeometry());
  const [part] = splitterOf(data).split(new Int32Array(12), 1);
  expect([part.triangleCount, part.edgeCount, part.points]).toEqual([12, data.edgeCount, data.points]);
  expect(flagsOf(part)).toEqual(flagsOf(data));
});

test('an undrawn side leaves borders and no crease', async () => {
  const data = await outlinesOf(new BoxGeometry());
  const [part] = splitterOf(data).split(bySides([0, 0, 0, NO_PART, 0, 0]), 1);
  const flags = flagsOf(part);
  expect([part.triangleCount, part.edgeCount]).toEqual([10, 12]);
  expect([count(flags, BORDER), count(flags, CREASE), count(flags, IS_EDGE)]).toEqual([4, 8, 12]);
  expect(flags.filter((each) => each & BORDER && each & (CREASE | MATERIAL_BORDER))).toEqual([]);
});

test('an edge between two parts belongs to the first alone', async () => {
  const data = await outlinesOf(new BoxGeometry());
  const [first, second] = splitterOf(data).split(bySides([0, 1, 1, 1, 1, 1]), 2);
  expect([first.triangleCount, first.edgeCount, second.triangleCount, second.edgeCount]).toEqual([2, 4, 10, 8]);
});

test('a smooth or flat surface has borders where it is cut', async () => {
  const plane = await outlinesOf(new PlaneGeometry(2, 1, 2, 1));
  const [half] = splitterOf(plane).split(Int32Array.of(0, 0, NO_PART, NO_PART), 1);
  expect(count(flagsOf(half), BORDER)).toBe(4);

  const ball = await outlinesOf(new SphereGeometry(1, 24, 12));
  const upper = new Int32Array(ball.triangleCount).fill(NO_PART, ball.triangleCount / 2);
  const [cap] = splitterOf(ball).split(upper, 1);
  expect(count(flagsOf(ball), BORDER)).toBe(0);
  expect(count(flagsOf(cap), BORDER)).toBe(24);
});
