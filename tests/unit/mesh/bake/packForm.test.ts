import { describe, expect, test } from 'vitest';
import { packForm } from '../../../../src/mesh/bake/packAttributes.js';
import { NO_CORNER, splitVertices } from '../../../../src/mesh/bake/splitVertices.js';
import { computeAreaNormals } from '../../../../src/mesh/computeAreaNormals.js';
import type { FormField } from '../../../../src/mesh/form/FormField.js';
import { finish, meshOf } from '../meshes.js';

/** Form vertices whose values and gradients are told apart by their numbers. */
const field = (ofCorner: number[], count: number, slope = 16): FormField => ({
  count,
  ofCorner: Uint32Array.from(ofCorner),
  values: Float32Array.from({ length: 2 * count }, (_, i) => i + 0.1),
  slopes: Float32Array.from({ length: 3 * count }, (_, i) => slope * Math.sin(i + 1)),
  crossings: Float32Array.from({ length: 3 * count }, (_, i) => slope * Math.cos(i + 1)),
  radius: 1,
  statistics: { singularPoints: 0, addedVertices: 0 },
});

/** Where gradients lie among those of a vertex. */
const [SLOPE, CROSSING] = [0, 4];

/** A gradient as the shader reads it. */
function unpacked(packed: Int16Array, vertex: number, offset = SLOPE): number[] {
  const [x, y, z, exponent] = packed.subarray(8 * vertex + offset);
  return [x, y, z].map((value) => (value / 32767) * 2 ** exponent);
}

describe('packForm', () => {
  test('gives each corner the values of its form vertex', () => {
    const form = field([0, 1, 2, 2, 1, 3], 4);
    const { values, gradients: packed } = finish(packForm(form, 1, null));
    for (const [corner, vertex] of form.ofCorner.entries()) {
      expect([...values.subarray(2 * corner, 2 * corner + 2)]).toEqual([
        ...form.values.subarray(2 * vertex, 2 * vertex + 2),
      ]);
      for (const [offset, gradients] of [
        [SLOPE, form.slopes],
        [CROSSING, form.crossings],
      ] as const) {
        const expected = [...gradients.subarray(3 * vertex, 3 * vertex + 3)];
        expect(unpacked(packed, corner, offset)).toEqual(expected.map((slope) => expect.closeTo(slope, 2)));
      }
    }
  });

  test('gives each vertex the values of its corner, and zeros to vertices without a corner', () => {
    const form = field([0, 1, 2, 2, 1, 3], 4);
    const { values, gradients } = finish(packForm(form, 1, Uint32Array.of(5, NO_CORNER, 0)));
    expect([...values]).toEqual([...form.values.subarray(6, 8), 0, 0, ...form.values.subarray(0, 2)]);
    expect(unpacked(gradients, 1)).toEqual([0, 0, 0]);
    expect(unpacked(gradients, 2)[0]).toBeCloseTo(form.slopes[0], 2);
  });

  test.each([1e-7, 1e-3, 1, 1e4, 1e9])('keeps gradients of an object with a radius of %s to a thousandth', (radius) => {
    const form = field([0, 1, 2], 3, 16 / radius);
    const { gradients } = finish(packForm(form, radius, null));
    for (let vertex = 0; vertex < 3; vertex++) {
      for (const [axis, slope] of unpacked(gradients, vertex).entries()) {
        expect(Math.abs(slope - form.slopes[3 * vertex + axis]) * radius).toBeLessThan(0.004);
      }
    }
  });

  test('clamps huge gradients, and allows objects without extent', () => {
    const form = field([0, 1, 2], 3, 1e6);
    expect(Math.max(...finish(packForm(form, 1, null)).gradients.map(Math.abs))).toBe(32767);
    expect(finish(packForm(field([0, 1, 2], 3, 0), 0, null)).gradients.every((slope) => slope === 0)).toBe(true);
  });
});

test('vertices are copied where a fan has several form vertices, and where a form vertex has several fans', () => {
  //  2 ── 3
  //  │ ╲  │
  //  0 ── 1
  const places = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [1, 1, 0],
  ];
  const mesh = meshOf(places, [
    [0, 1, 2],
    [2, 1, 3],
  ]);
  const areaNormals = finish(computeAreaNormals(mesh));
  const split = (fans: number[], parts: number[]) => {
    const ofCorner = Uint32Array.from(fans);
    const { indices, addedVertices } = finish(
      splitVertices(mesh, areaNormals, { ofCorner, count: 4 }, Uint32Array.from(parts)),
    );
    return { indices: [...indices], added: [...addedVertices] };
  };
  const joined = [0, 1, 2, 2, 1, 3];
  expect(split(joined, joined)).toEqual({ indices: joined, added: [] });
  expect(split(joined, [0, 1, 2, 4, 1, 3])).toEqual({ indices: [0, 1, 2, 4, 1, 3], added: [2] });
  expect(split([0, 1, 2, 4, 1, 3], joined)).toEqual({ indices: [0, 1, 2, 4, 1, 3], added: [2] });
  expect(split([0, 1, 2, 4, 1, 3], [0, 1, 2, 2, 5, 3])).toEqual({ indices: [0, 1, 2, 4, 5, 3], added: [2, 1] });
});
