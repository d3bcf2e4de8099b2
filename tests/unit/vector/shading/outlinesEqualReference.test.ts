import { expect, test } from 'vitest';
import { hiddenWeight } from '../../../../src/look/hiddenOutlines.js';
import { combined, normalize, type Vec3 } from '../../../../src/look/vectors.js';
import {
  contourAlong,
  depthAcross,
  liftOf,
  paperness,
  shadeWeight,
  taperAt,
  toleranceOf,
  wobbleAt,
} from '../../../../src/vector/shading/outlines.js';
import { suggestiveShare } from '../../../../src/vector/shading/suggestiveContour.js';
import {
  behindSurface,
  depthBeside,
  liftedBy,
  mayLieBefore,
  paperBehind,
  partInContour,
  shadedWidths,
  strayed,
  suggestedBy,
  taperedTo,
} from '../../../reference/outlineReference.js';
import type { Vec3 as List3 } from '../../../reference/referenceAdjacency.js';
import { randomNumbers } from '../randomNumbers.js';

const random = randomNumbers(41);
const between = (from: number, to: number): number => from + (to - from) * random();
const list3 = (reach: number): List3 => [between(-reach, reach), between(-reach, reach), between(-reach, reach)];
const unit3 = (): List3 => [...normalize(list3(1))];
const same = (found: number, expected: number) => expect(Math.abs(found - expected)).toBeLessThan(1e-9);

test('weights of outlines are those of the reference', () => {
  let [lost, kept] = [0, 0];
  for (let i = 0; i < 500; i++) {
    const [bend, taper, weight, gap] = [between(-1, 2), i % 5 ? between(0.1, 1.5) : 0, random(), between(-0.2, 1.2)];
    same(taperAt(bend, taper), taperedTo(bend, taper));
    same(hiddenWeight(weight), behindSurface(weight));
    same(paperness(gap), paperBehind(gap));
    const [normal, light, sight] = [unit3(), unit3(), unit3()];
    const [lit, shaded, lostEdges, contour] = [random(), 1 + random(), random(), random()];
    const given = { light, sight, shadeWeights: [lit, shaded] as const, lostEdges };
    const [inner, left] = shadeWeight(normal, contour, given);
    const outer = inner * left;
    const expected = shadedWidths(normal, contour, { light, sight, lit, shaded, lostEdges });
    same(inner, expected[0]);
    same(outer, expected[1]);
    if (outer < inner) lost++;
    else kept++;
  }
  expect(lost).toBeGreaterThan(20);
  expect(kept).toBeGreaterThan(20);
});

test('parts of edges that are contours are those of the reference', () => {
  let [none, some] = [0, 0];
  for (let i = 0; i < 500; i++) {
    const [left, right] = [
      [between(-1, 1), between(-1, 1)],
      [between(-1, 1), between(-1, 1)],
    ] as [[number, number], [number, number]];
    const [found, expected] = [contourAlong(left, right), partInContour(left, right)];
    expect(found === null).toBe(expected === null);
    if (found === null) none++;
    for (const k of [0, 1]) {
      if (found && expected) same(found[k], expected[k]);
    }
    if (found && (found[0] > 0 || found[1] < 1)) some++;
  }
  expect(none).toBeGreaterThan(50);
  expect(some).toBeGreaterThan(50);
});

test('lift, tolerance, stray and depth of an outline are those of the reference', () => {
  for (let i = 0; i < 500; i++) {
    const [bend, extent, half, radius] = [between(-0.5, 3), between(0, 0.1), between(0.001, 0.02), between(0.5, 3)];
    const isSmooth = i % 2 === 0;
    const [ownCover, isValley, pixel] = [between(0, 0.1), i % 4 > 1, between(0.001, 0.01)];
    const piece = { isSmooth, bend, extent, ownCover, isValley };
    same(liftOf(piece, half, radius), liftedBy(isSmooth ? bend : null, extent, half, radius));
    same(toleranceOf(piece, pixel, radius), mayLieBefore(ownCover, isValley, pixel, radius));
    const [place, wobble] = [list3(1), between(0, 3)];
    const [x, y] = strayed(place, wobble);
    const found = wobbleAt(place, wobble);
    same(found[0], x);
    same(found[1], y);
    const corners = [list3(1), list3(1), list3(1)] as const;
    const start = combined(0.7, corners[0], 0.3, corners[1]);
    const end = combined(0.2, corners[0], 0.8, corners[2]);
    const toEye = list3(4);
    same(depthAcross(corners, start, end, toEye), depthBeside(corners, [...start], [...end], toEye));
  }
});

test('weights of suggestive contours are those of the reference', () => {
  let [none, part] = [0, 0];
  for (let i = 0; i < 500; i++) {
    const corners = [list3(0.1), list3(0.1), list3(0.1)] as const;
    const normals = [0, 1, 2].map(() => [...normalize(combined(1, list3(0.3), 1, [0, 0, 1]))] as List3);
    const bends: List3 = list3(2);
    const toEye: Vec3 = [between(-2, 2), between(-2, 2), between(0.5, 2)];
    const radius = between(0.5, 3);
    const bent = corners.map((position, k) => ({ position, normal: normals[k], bend: bends[k] }));
    const found = suggestiveShare(bent as unknown as Parameters<typeof suggestiveShare>[0], toEye, radius);
    const expected = suggestedBy(corners, normals as [List3, List3, List3], bends, [...toEye], radius);
    expect(Math.abs(found - expected)).toBeLessThan(1e-6);
    if (found === 0) none++;
    else if (found < 1) part++;
  }
  expect(none).toBeGreaterThan(50);
  expect(part).toBeGreaterThan(50);
});
