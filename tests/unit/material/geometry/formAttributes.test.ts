import { type BufferGeometry, CylinderGeometry, TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingFormOptions } from '../../../../src/material/geometry/HatchingFormOptions.js';
import type { PrepareHatchingGeometryOptions } from '../../../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import type { VertexAttribute } from '../../../../src/material/geometry/vertexAttributes.js';

/** An open tube of radius 0.5 and height 1.5, which three.js gives a seam. */
const tube = () => new CylinderGeometry(0.5, 0.5, 1.5, 36, 12, true);
const NAMES = ['formValue', 'formSlope', 'formCrossing'] as const;

const prepareTube = (options: PrepareHatchingGeometryOptions) => prepareHatchingGeometry(tube(), options);

/** A gradient as the shader reads it. */
function slopeAt(geometry: BufferGeometry, name: 'formSlope' | 'formCrossing', vertex: number): number[] {
  const attribute = geometry.getAttribute(name);
  const scale = 2 ** Math.round(32767 * attribute.getW(vertex));
  return [attribute.getX(vertex), attribute.getY(vertex), attribute.getZ(vertex)].map((slope) => slope * scale);
}

describe.each(['indexed', 'corner', 'pull'] as const)('the layout %s', (layout) => {
  test('has lines around a tube: φ rises by 16 lines per bounding radius along it, and nowhere else', async () => {
    const geometry = await prepareTube({ layout, form: true });
    const { position, formValue } = geometry.attributes;
    expect(NAMES.map((name) => geometry.getAttribute(name).count)).toEqual(NAMES.map(() => position.count));
    const steepness = 16 / geometry.boundingSphere!.radius;
    for (let vertex = 0; vertex < position.count; vertex++) {
      const [x, y, z] = slopeAt(geometry, 'formSlope', vertex);
      expect(Math.abs(y) / steepness).toBeCloseTo(1, 1);
      expect(Math.hypot(x, z) / steepness).toBeLessThan(0.05);
      const height = position.getY(vertex) - position.getY(0);
      expect(
        Math.abs(Math.abs(formValue.getX(vertex) - formValue.getX(0)) - steepness * Math.abs(height)),
      ).toBeLessThan(0.2);
    }
  });
});

test('the other family crosses the first at the requested angle', async () => {
  for (const crossAngle of [Math.PI / 3, Math.PI / 2]) {
    const geometry = await prepareTube({ form: { crossAngle } });
    for (let vertex = 0; vertex < geometry.attributes.position.count; vertex++) {
      const [a, b] = (['formSlope', 'formCrossing'] as const).map((name) => slopeAt(geometry, name, vertex));
      const cosine = a.reduce((sum, x, i) => sum + x * b[i], 0) / (Math.hypot(...a) * Math.hypot(...b));
      expect(Math.acos(cosine)).toBeCloseTo(crossAngle, 0);
    }
  }
});

test('it takes 24 bytes per vertex, and exists only on request', async () => {
  const plain = await prepareTube({});
  const formed = await prepareTube({ form: true });
  expect(NAMES.filter((name) => plain.hasAttribute(name))).toEqual([]);
  const bytes = NAMES.reduce(
    (sum, name) => sum + formed.getAttribute(name).array.BYTES_PER_ELEMENT * formed.getAttribute(name).itemSize,
    0,
  );
  expect(bytes).toBe(24);
});

test('it takes two vertex buffers', async () => {
  const { formValue, formSlope, formCrossing } = (await prepareTube({ form: true })).attributes;
  const bufferOf = (attribute: VertexAttribute) => ('data' in attribute ? attribute.data : attribute);
  expect(new Set([formValue, formSlope, formCrossing].map(bufferOf)).size).toBe(2);
});

test('a prepared geometry that is prepared again keeps no old form attributes', async () => {
  const formed = await prepareTube({ form: true });
  expect((await prepareHatchingGeometry(formed)).hasAttribute('formValue')).toBe(false);
  const again = await prepareHatchingGeometry(formed, { form: true });
  expect(NAMES.map((name) => again.hasAttribute(name))).toEqual([true, true, true]);
});

test('groups, morph targets and other attributes are those of their vertices', async () => {
  const torus = new TorusGeometry(1, 0.4, 12, 24);
  torus.morphAttributes.position = [torus.attributes.position.clone()];
  torus.addGroup(0, 300, 0);
  torus.addGroup(300, torus.index!.count - 300, 1);
  const formed = await prepareHatchingGeometry(torus, { form: true });
  const { position, normal } = formed.attributes;
  const [target] = formed.morphAttributes.position!;
  expect(formed.groups).toEqual(torus.groups);
  expect([normal.count, target.count]).toEqual([position.count, position.count]);
  expect(target.array).toEqual(position.array);
});

test('wrong options are refused by name', async () => {
  const refuse = (form: unknown, message: string) =>
    expect(prepareTube({ form: form as HatchingFormOptions })).rejects.toThrow(message);
  await refuse({ crossAngle: 0 }, 'form.crossAngle is 0. Pass an angle in radians between 0 and π');
  await refuse({ crossAngle: 4 }, 'form.crossAngle is 4.');
  await refuse({ smoothing: -1 }, 'form.smoothing is -1. Pass a share of the bounding radius above 0');
  await refuse({ reach: Number.NaN }, 'form.reach is NaN');
  await refuse({ up: [0, 1] }, 'form.up must be an array of three finite numbers');
  await refuse({ front: [0, 1, Infinity] }, 'form.front must be');
  await refuse({ upp: [0, 1, 0] }, 'unknown option "upp"');
  await refuse('yes', 'the options of form are yes');
});
