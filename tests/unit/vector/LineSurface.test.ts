import { expect, test } from 'vitest';
import { FIELD, type LineSurface, readTriangle, STRIDE, TONE_NORMAL } from '../../../src/vector/LineSurface.js';

/** A triangle from (0, 0, 0) along x and y, two tiles long, with these tone normals. */
function triangleWith(normals: readonly (readonly number[])[]): LineSurface {
  const places = [
    [0, 0, 0],
    [2, 0, 0],
    [0, 2, 0],
  ];
  const vertices = new Float64Array(3 * STRIDE);
  for (const [i, place] of places.entries()) {
    vertices.set(place, i * STRIDE + FIELD);
    vertices.set(normals[i], i * STRIDE + TONE_NORMAL);
  }
  return {
    vertices,
    placeOf: Int32Array.of(0, 1, 2),
    triangles: Int32Array.of(0, 1, 2),
    parents: Int32Array.of(0),
    drawsFront: true,
    drawsBack: false,
    viewToField: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    details: null,
  };
}

test('a triangle is plane where its corners have one normal, and round where one of them differs', () => {
  const up = [0, 0, 1];
  const slanted = [0, 0.1, 0.995];
  expect(readTriangle(triangleWith([up, up, up]), 0)).toEqual({ flatNormal: [0, 0, 4], isPlane: true });
  for (const odd of [0, 1, 2]) {
    const normals = [up, up, up].map((normal, i) => (i === odd ? slanted : normal));
    expect(readTriangle(triangleWith(normals), 0).isPlane).toBe(false);
  }
});
