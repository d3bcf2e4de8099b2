import { Matrix3, Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { bakeJointForms, type JointForm, type Part } from '../../../../src/mesh/bake/bakeJointForms.js';
import { FORM_DEFAULTS, type FormField } from '../../../../src/mesh/form/FormField.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { formOf } from '../form/phases.js';
import { finish } from '../meshes.js';
import { cube, sphere, torus } from '../shapes.js';

const HERE = new Matrix4().toArray();
const turned = new Quaternion().setFromAxisAngle(new Vector3(0.6, 0, 0.8), 2.2);
const AWAY = new Matrix4().compose(new Vector3(3, -1, 2), turned, new Vector3(-4, 4, 4));

/** Takes the triangles of a range out of a mesh, with all its vertices. */
const slice = ({ positions, indices }: TriangleMesh, first: number, end: number): TriangleMesh => ({
  positions: positions.slice(),
  indices: indices.slice(3 * first, 3 * end),
});

const moved = ({ positions, indices }: TriangleMesh, matrix: Matrix4): TriangleMesh => ({
  positions: Float32Array.from(
    Array.from({ length: positions.length / 3 }, (_, i) =>
      new Vector3()
        .fromArray(positions, 3 * i)
        .applyMatrix4(matrix)
        .toArray(),
    ).flat(),
  ),
  // A mirrored part shows its triangles from the other side.
  indices: matrix.determinant() < 0 ? indices.map((_, i) => indices[i - (i % 3) + [0, 2, 1][i % 3]]) : indices,
});

const formsOf = (parts: readonly Part[], isChosen = false): JointForm[] =>
  finish(bakeJointForms({ parts, creaseAngle: Math.PI / 2, form: { ...FORM_DEFAULTS, isChosen } }));

const isField = (form: JointForm): form is FormField => typeof form !== 'string';

/** φ, φ₂ and their gradients at a corner. */
const at = ({ ofCorner, values, slopes, crossings }: FormField, corner: number): number[] => {
  const vertex = ofCorner[corner];
  return [
    values.subarray(2 * vertex, 2 * vertex + 2),
    slopes.subarray(3 * vertex, 3 * vertex + 3),
    crossings.subarray(3 * vertex, 3 * vertex + 3),
  ].flatMap((numbers) => [...numbers]);
};

describe('parts whose borders meet', () => {
  const whole = torus(48, 24);
  const count = whole.indices.length / 3;

  test('have the field of the whole, to the last bit', () => {
    const expected = formOf(whole);
    const forms = formsOf([
      { mesh: slice(whole, 0, 1000), matrix: HERE },
      { mesh: slice(whole, 1000, count), matrix: HERE },
    ]).filter(isField);
    expect(forms).toHaveLength(2);
    for (let corner = 0; corner < 3 * count; corner++) {
      const [form, own] = corner < 3000 ? [forms[0], corner] : [forms[1], corner - 3000];
      expect(at(form, own)).toEqual(at(expected, corner));
    }
  });

  test('have the same field in object spaces of their own, one of them mirrored, rotated and scaled', () => {
    const expected = formOf(whole);
    const [, form] = formsOf([
      { mesh: slice(whole, 0, 1000), matrix: HERE },
      { mesh: moved(slice(whole, 1000, count), AWAY.clone().invert()), matrix: AWAY.toArray() },
    ]).filter(isField);
    expect(form.radius).toBeCloseTo(expected.radius / 4, 4);
    for (let corner = 0; corner < form.ofCorner.length; corner++) {
      // The mirrored part has the last two corners of each triangle in the other order.
      const found = at(form, corner - (corner % 3) + [0, 2, 1][corner % 3]);
      const wanted = at(expected, 3000 + corner);
      for (const family of [0, 1]) {
        expect(found[family]).toBeCloseTo(wanted[family], 1);
        const start = 2 + 3 * family;
        const gradient = new Vector3().fromArray(found, start).applyMatrix3(new Matrix3().getNormalMatrix(AWAY));
        expect(gradient.distanceTo(new Vector3().fromArray(wanted, start))).toBeLessThan(0.2);
      }
    }
  });
});

test('parts that meet no other are left alone, and groups are independent', () => {
  const [ball, ring] = [sphere(8), torus(24, 12)];
  const far = new Matrix4().makeTranslation(9, 0, 0).toArray();
  const half = (mesh: TriangleMesh, i: number): TriangleMesh => {
    const middle = mesh.indices.length / 6;
    return slice(mesh, i * middle, (i + 1) * middle);
  };
  const forms = formsOf([
    { mesh: half(ball, 0), matrix: HERE },
    { mesh: half(ring, 0), matrix: far },
    { mesh: cube(2), matrix: HERE },
    { mesh: half(ball, 1), matrix: HERE },
    { mesh: half(ring, 1), matrix: far },
  ]);
  expect(forms.map((form) => (isField(form) ? form.radius.toFixed(1) : form))).toEqual([
    '1.0',
    '1.4',
    'alone',
    '1.0',
    '1.4',
  ]);
});

test('parts without a common form follow the light, if that was requested', () => {
  const box = cube(4);
  const middle = box.indices.length / 6;
  const parts = [slice(box, 0, middle - 4), slice(box, middle - 4, 2 * middle)];
  expect(
    formsOf(
      parts.map((mesh) => ({ mesh, matrix: HERE })),
      true,
    ),
  ).toEqual(['light', 'light']);
});

test('an invalid part is an error for all', () => {
  const broken = sphere(4);
  broken.positions[7] = Number.NaN;
  expect(() =>
    formsOf([
      { mesh: sphere(4), matrix: HERE },
      { mesh: broken, matrix: HERE },
    ]),
  ).toThrow(RangeError);
  const strange = sphere(4);
  strange.indices[4] = 9999;
  expect(() =>
    formsOf([
      { mesh: strange, matrix: HERE },
      { mesh: sphere(4), matrix: HERE },
    ]),
  ).toThrow(RangeError);
});
