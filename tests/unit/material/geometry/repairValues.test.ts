import {
  BufferAttribute,
  type BufferGeometry,
  Float16BufferAttribute,
  Float32BufferAttribute,
  PlaneGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';

const layouts = ['corner', 'pull', 'indexed'] as const;
const { NaN: NOT_A_NUMBER } = Number;

const valuesOf = (geometry: BufferGeometry, name: string) => {
  const attribute = geometry.getAttribute(name);
  return Array.from({ length: attribute.count }, (_, i) => [attribute.getX(i), attribute.getY(i), attribute.getZ(i)]);
};

/** A plane facing +z with slanted good normals, which shows whether they were kept. */
function plane(bad: readonly (readonly number[])[]): BufferGeometry {
  const geometry = new PlaneGeometry(1, 1);
  const leaning = [0.6, 0, 0.8];
  const normals = [0, 1, 2, 3].flatMap((i) => bad[i] ?? leaning);
  return geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
}

describe.each(layouts)('normals that cannot be used, layout %s', (layout) => {
  test.each([
    ['NaN', [NOT_A_NUMBER, 0, 1]],
    ['infinite', [0, -Infinity, 1]],
    ['zero', [0, 0, 0]],
  ])('%s ones are computed, the others kept', async (_, bad) => {
    const prepared = await prepareHatchingGeometry(plane([bad]), { layout });
    expect(prepared.userData.hatching.computedNormals).toBe(1);
    const normals = valuesOf(prepared, 'normal');
    // Vertex 0 lies at (−0.5, 0.5).
    for (const [i, [x, y]] of valuesOf(prepared, 'position').entries()) {
      const expected = x === -0.5 && y === 0.5 ? [0, 0, 1] : [0.6, 0, 0.8];
      for (const axis of [0, 1, 2]) expect(normals[i][axis]).toBeCloseTo(expected[axis], 6);
    }
  });

  test('unused vertices get no computed normals, and the others stay', async () => {
    const source = plane([[0, 0, 0]]);
    // The second of the plane's two triangles, 0 2 1 and 2 3 1, alone.
    source.setDrawRange(3, 3);
    const prepared = await prepareHatchingGeometry(source, { layout });
    expect(prepared.userData.hatching.computedNormals).toBe(0);
    const leaning = valuesOf(prepared, 'normal').filter(([x]) => x === Math.fround(0.6));
    expect(leaning).toHaveLength(3);
  });

  test('quantised zeros are computed in their type', async () => {
    const source = new PlaneGeometry(1, 1);
    source.setAttribute('normal', new BufferAttribute(new Int8Array(12), 3, true));
    const prepared = await prepareHatchingGeometry(source, { layout });
    expect(prepared.userData.hatching.computedNormals).toBe(4);
    expect(prepared.getAttribute('normal').array).toBeInstanceOf(Int8Array);
    for (const normal of valuesOf(prepared, 'normal')) expect(normal).toEqual([0, 0, 1]);
  });

  test('missing ones are computed and counted, good ones are not', async () => {
    const none = new PlaneGeometry(1, 1).deleteAttribute('normal');
    expect((await prepareHatchingGeometry(none, { layout })).userData.hatching.computedNormals).toBe(4);
    expect((await prepareHatchingGeometry(plane([]), { layout })).userData.hatching.computedNormals).toBe(0);
  });
});

describe.each(layouts)('values that are not finite, layout %s', (layout) => {
  const finite = (geometry: BufferGeometry) =>
    [geometry.attributes, ...Object.values(geometry.morphAttributes)]
      .flatMap((attributes) => Object.values(attributes))
      .flatMap((attribute) =>
        Array.from({ length: attribute.count * attribute.itemSize }, (_, i) =>
          attribute.getComponent(Math.floor(i / attribute.itemSize), i % attribute.itemSize),
        ),
      )
      .every(Number.isFinite);

  test('become 0 and are counted; the source is left alone', async () => {
    const source = plane([]);
    source.setAttribute('color', new Float32BufferAttribute([NOT_A_NUMBER, ...new Array(10).fill(0.5), Infinity], 3));
    source.setAttribute('uv', new BufferAttribute(new Float64Array([NOT_A_NUMBER, 1, 1, 1, 1, 1, 1, 1]), 2));
    source.setAttribute(
      'tangent',
      new Float16BufferAttribute([0x7e00, 0x7c00, 0x3c00, ...new Array(13).fill(0x3c00)], 4),
    );
    source.setAttribute('skinIndex', new Float32BufferAttribute([NOT_A_NUMBER, ...new Array(15).fill(0)], 4));
    source.setAttribute('skinWeight', new Float32BufferAttribute([Infinity, ...new Array(15).fill(0)], 4));
    const prepared = await prepareHatchingGeometry(source, { layout });
    expect(prepared.userData.hatching.zeroedValues).toBe(7);
    expect(finite(prepared)).toBe(true);
    expect(source.getAttribute('color').getX(0)).toBeNaN();
  });

  test('in morph targets they become 0, or the unmorphed value where the targets are not relative', async () => {
    for (const isRelative of [true, false]) {
      const source = plane([]);
      source.morphTargetsRelative = isRelative;
      const values = [NOT_A_NUMBER, NOT_A_NUMBER, 3, ...new Array(9).fill(0)];
      source.morphAttributes.position = [new Float32BufferAttribute(values, 3)];
      const prepared = await prepareHatchingGeometry(source, { layout });
      expect(prepared.userData.hatching.zeroedValues).toBe(2);
      const target = prepared.morphAttributes.position![0];
      const first = valuesOf(prepared, 'position').findIndex(([x, y]) => x === -0.5 && y === 0.5);
      expect([target.getX(first), target.getY(first), target.getZ(first)]).toEqual(
        isRelative ? [0, 0, 3] : [-0.5, 0.5, 3],
      );
      expect(Number.isFinite(prepared.boundingSphere!.radius)).toBe(true);
    }
  });
});
