import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Float16BufferAttribute,
  Float32BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  SphereGeometry,
  TorusKnotGeometry,
  type TypedArray,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingStatistics } from '../../../../src/material/geometry/preparedGeometry.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { cornerLayout } from '../../../../src/mesh/bake/attributeLayouts.js';

//  2 ── 3
//  │ ╲  │      the right half stands upright on the diagonal, so that its vertices 2 and 1 have two normals
//  0 ── 1
const foldPositions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0.5, 1];
const foldIndices = [0, 1, 2, 2, 1, 3];
/** The source vertex of each vertex of the prepared geometry. */
const foldSources = [0, 1, 2, 3, 2, 1];
const splitIndices = [0, 1, 2, 4, 5, 3];

function fold(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(foldPositions, 3));
  geometry.setIndex(foldIndices);
  return geometry;
}

const prepareIndexed = (geometry: BufferGeometry) => prepareHatchingGeometry(geometry, { layout: 'indexed' });

/** The values of an attribute; its getters, unlike `getComponent`, decode half floats. */
const valuesOf = (geometry: BufferGeometry, name: string): number[][] => {
  const attribute = geometry.getAttribute(name);
  const getters = (['getX', 'getY', 'getZ', 'getW'] as const).slice(0, attribute.itemSize);
  return Array.from({ length: attribute.count }, (_, i) => getters.map((getter) => attribute[getter](i)));
};

/** The values of an attribute at each corner, through the index if there is one. */
const cornersOf = (geometry: BufferGeometry, name: string): number[][] => {
  const values = valuesOf(geometry, name);
  return geometry.index ? Array.from(geometry.index.array, (vertex) => values[vertex]) : values;
};

describe('the prepared geometry', () => {
  test('has its vertices, an index, copies at sharp edges, hatch normals, normals, bounds and statistics', async () => {
    const geometry = fold();
    geometry.name = 'fold';
    geometry.userData = { mine: 1 };
    const prepared = await prepareIndexed(geometry);
    expect([...geometry.index!.array]).toEqual(foldIndices);
    expect([...geometry.attributes.position.array]).toEqual(foldPositions);
    expect(Object.keys(geometry.attributes)).toEqual(['position']);

    expect(prepared.name).toBe('fold');
    expect(prepared.index!.array).toEqual(new Uint16Array(splitIndices));
    expect(Object.keys(prepared.attributes).sort()).toEqual(['hatchNormal', 'normal', 'position']);
    expect(valuesOf(prepared, 'position')).toEqual(foldSources.map((v) => foldPositions.slice(3 * v, 3 * v + 3)));
    const hatchNormal = prepared.getAttribute('hatchNormal') as BufferAttribute;
    expect(hatchNormal.array).toBeInstanceOf(Int16Array);
    expect([hatchNormal.itemSize, hatchNormal.normalized, hatchNormal.count]).toEqual([4, true, 6]);
    expect(valuesOf(prepared, 'hatchNormal')[1]).toEqual([0, 0, 1, 0]);
    for (const vertex of [3, 4, 5]) expect(valuesOf(prepared, 'hatchNormal')[vertex][2]).toBeCloseTo(0, 4);
    expect(prepared.boundingBox!.max.toArray()).toEqual([1, 1, 1]);
    expect(prepared.boundingSphere!.center.toArray()).toEqual([0.5, 0.5, 0.5]);
    const statistics: HatchingStatistics = {
      triangles: 2,
      borderEdges: 4,
      nonManifoldEdges: 0,
      unpairedEdges: 0,
      inconsistentEdges: 0,
      degenerateTriangles: 0,
      computedNormals: 4,
      zeroedValues: 0,
      turnedTriangles: 0,
      layout: 'indexed',
      direction: 'light',
      bytes: 6 * (12 + 12 + 8) + 6 * 2,
    };
    expect(prepared.userData).toEqual({ mine: 1, hatching: statistics });
  });

  test.each([
    ['a box', new BoxGeometry(1, 2, 3, 2, 2, 2), 0],
    ['a sphere', new SphereGeometry(1, 24, 16), 0],
    ['a torus knot', new TorusKnotGeometry(1, 0.3, 60, 12), 0],
    ['a triangle soup', new BoxGeometry(1, 2, 3).toNonIndexed(), 0],
  ])('of %s adds no vertices, and every corner has what it has in the corner layout', async (_, geometry, added) => {
    const indexed = await prepareIndexed(geometry);
    const corner = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect(indexed.attributes.position.count - geometry.attributes.position.count).toBe(added);
    for (const name of ['position', 'normal', 'uv', 'hatchNormal']) {
      expect(cornersOf(indexed, name), name).toEqual(cornersOf(corner, name));
    }
    expect(indexed.groups).toEqual(corner.groups);
    expect(indexed.userData.hatching.borderEdges).toBe(corner.userData.hatching.borderEdges);
  });

  test('can be prepared again, in either layout', async () => {
    const geometry = new BoxGeometry(1, 1, 1, 3, 3, 3);
    const [corner, indexed] = [
      await prepareHatchingGeometry(geometry, { adjacency: true }),
      await prepareIndexed(geometry),
    ];
    const again = await prepareIndexed(corner);
    expect(cornersOf(again, 'hatchNormal')).toEqual(cornersOf(indexed, 'hatchNormal'));
    for (const { name } of cornerLayout) expect(again.hasAttribute(name)).toBe(false);
    const back = await prepareHatchingGeometry(indexed, { adjacency: true });
    expect(Object.keys(back.attributes).sort()).toEqual(Object.keys(corner.attributes).sort());
    expect(cornersOf(back, 'oppositeAlpha')).toEqual(cornersOf(corner, 'oppositeAlpha'));
    expect((await prepareIndexed(indexed)).userData).toEqual(indexed.userData);
  });

  test('does not depend on changes during the bake', async () => {
    const geometry = fold();
    const expected = cornersOf(await prepareIndexed(fold()), 'position');
    const promise = prepareIndexed(geometry);
    (geometry.attributes.position.array as Float32Array).fill(7);
    geometry.index!.array.fill(0);
    expect(cornersOf(await promise, 'position')).toEqual(expected);
  });
});

describe('input', () => {
  const withPosition = (position: BufferAttribute | InterleavedBufferAttribute) =>
    fold().setAttribute('position', position);
  const scaled = foldPositions.map((value) => 2 * value);
  const interleaved = new InterleavedBuffer(
    new Float32Array([0, 1, 2, 3].flatMap((v) => [9, 9, ...foldPositions.slice(3 * v, 3 * v + 3), 9])),
    6,
  );

  test.each<[string, () => BufferGeometry, number]>([
    ['16-bit indices', () => fold().setIndex(new BufferAttribute(new Uint16Array(foldIndices), 1)), 1],
    ['32-bit indices', () => fold().setIndex(new BufferAttribute(new Uint32Array(foldIndices), 1)), 1],
    ['8-bit indices', () => fold().setIndex(new BufferAttribute(new Uint8Array(foldIndices), 1)), 1],
    ['no index', () => fold().toNonIndexed(), 1],
    ['interleaved', () => withPosition(new InterleavedBufferAttribute(interleaved, 3, 2)), 1],
    ['bytes', () => withPosition(new BufferAttribute(new Uint8Array(scaled), 3)), 2],
    [
      'normalised shorts',
      () => withPosition(new BufferAttribute(new Int16Array(scaled.map((v) => Math.round(32767 * (v / 2)))), 3, true)),
      1,
    ],
    [
      'half floats',
      () =>
        withPosition(
          new Float16BufferAttribute(
            scaled.map((v) => (v === 0 ? 0 : 0x3800 + 0x400 * v)),
            3,
          ),
        ),
      2,
    ],
    ['doubles', () => withPosition(new BufferAttribute(new Float64Array(foldPositions), 3)), 1],
  ])('%s', async (_, create, scale) => {
    const geometry = create();
    const prepared = await prepareIndexed(geometry);
    const position = prepared.getAttribute('position') as BufferAttribute;
    const source = geometry.getAttribute('position');
    expect(position.array.constructor).toBe(source.array.constructor);
    expect(position.normalized).toBe(source.normalized);
    const close = (values: number[]) => values.map((value) => expect.closeTo(value, 4));
    expect(cornersOf(prepared, 'position')).toEqual(
      foldIndices.map((v) => close(foldPositions.slice(3 * v, 3 * v + 3).map((value) => scale * value))),
    );
    const normals = cornersOf(prepared, 'hatchNormal');
    for (const corner of [0, 1, 2]) expect(normals[corner]).toEqual([0, 0, 1, 0]);
    for (const corner of [3, 4, 5])
      expect(normals[corner].slice(0, 3)).toEqual(close([-Math.SQRT1_2, -Math.SQRT1_2, 0]));
  });
});

test('attributes keep type, size and normalisation, and the copies have them too', async () => {
  const geometry = fold();
  geometry.setAttribute(
    'normal',
    new BufferAttribute(new Int8Array([0, 0, 127, 1, 0, 127, 2, 0, 127, 3, 0, 127]), 3, true),
  );
  geometry.setAttribute(
    'skinIndex',
    new BufferAttribute(
      new Uint16Array(16).map((_, i) => i),
      4,
    ),
  );
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      Array.from({ length: 16 }, (_, i) => i / 16),
      4,
    ),
  );
  geometry.setAttribute('half', new Float16BufferAttribute([0x3c00, 0x4000, 0x4200, 0x4400], 1));
  // longer than needed, and interleaved
  const buffer = new InterleavedBuffer(
    new Uint8Array(24).map((_, i) => i),
    4,
  );
  geometry.setAttribute('color', new InterleavedBufferAttribute(buffer, 3, 1, true));
  geometry.morphTargetsRelative = true;
  const targets = [0, 1].map(
    (t) =>
      new Float32BufferAttribute(
        Array.from({ length: 12 }, (_, i) => 100 * t + i),
        3,
      ),
  );
  geometry.morphAttributes.position = targets;
  const prepared = await prepareIndexed(geometry);

  for (const [name, source] of Object.entries(geometry.attributes)) {
    const attribute = prepared.getAttribute(name) as BufferAttribute;
    expect(attribute.array.constructor, name).toBe(source.array.constructor);
    expect([attribute.itemSize, attribute.normalized], name).toEqual([source.itemSize, source.normalized]);
    const values = valuesOf(geometry, name);
    expect(valuesOf(prepared, name), name).toEqual(foldSources.map((vertex) => values[vertex]));
  }
  expect(prepared.morphTargetsRelative).toBe(true);
  for (const [t, target] of prepared.morphAttributes.position!.entries()) {
    expect(Array.from({ length: 6 }, (_, i) => target.getX(i))).toEqual(foldSources.map((v) => 100 * t + 3 * v));
  }
  expect(prepared.boundingBox!.max.x).toBeGreaterThan(100);
});

test('instanced attributes are copied as they are', async () => {
  const geometry = new InstancedBufferGeometry();
  geometry.copy(fold() as InstancedBufferGeometry);
  geometry.instanceCount = 2;
  geometry.setAttribute('offset', new InstancedBufferAttribute(new Float32Array([1, 2, 3, 4]), 2));
  const prepared = (await prepareIndexed(geometry)) as InstancedBufferGeometry;
  expect(prepared.isInstancedBufferGeometry).toBe(true);
  expect(prepared.instanceCount).toBe(2);
  expect([...prepared.getAttribute('offset').array]).toEqual([1, 2, 3, 4]);
});

test('only the draw range is drawn; groups are cut to it', async () => {
  const ranged = (geometry: BufferGeometry) => {
    geometry.clearGroups();
    geometry.setDrawRange(6, 12);
    geometry.addGroup(0, 9, 2);
    geometry.addGroup(9, 12, 1);
    return geometry;
  };
  for (const create of [() => new BoxGeometry(), () => new BoxGeometry().toNonIndexed()]) {
    const prepared = await prepareIndexed(ranged(create()));
    const corner = await prepareHatchingGeometry(ranged(create()), { adjacency: true });
    expect(cornersOf(prepared, 'position')).toEqual(cornersOf(corner, 'position'));
    expect(prepared.drawRange).toEqual({ start: 0, count: Infinity });
    expect(prepared.groups).toEqual(corner.groups);
    expect(prepared.userData.hatching.triangles).toBe(4);
    expect(prepared.boundingBox).toEqual(corner.boundingBox);
  }
});

test('bad input is rejected as in the corner layout', async () => {
  const geometry = fold();
  (geometry.attributes.position.array as TypedArray)[4] = Number.NaN;
  await expect(prepareIndexed(geometry)).rejects.toThrow(
    /^prepareHatchingGeometry: the geometry: the position of vertex 1/,
  );
});

test('smoothingRadius reaches the bake', async () => {
  const bumpy = new SphereGeometry(1, 24, 16);
  const position = bumpy.attributes.position;
  for (let i = 0; i < position.count; i++) if (i % 7 === 0) position.setX(i, 1.05 * position.getX(i));
  const normals = async (layout: 'corner' | 'indexed', smoothingRadius?: number) =>
    cornersOf(await prepareHatchingGeometry(bumpy, { layout, smoothingRadius }), 'hatchNormal');
  for (const layout of ['corner', 'indexed'] as const) {
    expect(await normals(layout, 0.5)).not.toEqual(await normals(layout));
    expect(await normals(layout, 0)).not.toEqual(await normals(layout));
  }
});
