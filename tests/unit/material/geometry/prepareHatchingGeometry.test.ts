import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Float16BufferAttribute,
  Float32BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  IntType,
  TorusKnotGeometry,
  type TypedArray,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingStatistics } from '../../../../src/material/geometry/preparedGeometry.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { CORNER_STRIDE, cornerLayout } from '../../../../src/mesh/bake/attributeLayouts.js';
import { quad, quadIndices, quadPositions, snapshot } from './quad.js';

const quadCorners = quadIndices.flatMap((vertex) => quadPositions.slice(3 * vertex, 3 * vertex + 3));

const arrayOf = (geometry: BufferGeometry, name: string): TypedArray => geometry.getAttribute(name).array;

/** The layout's attributes, corner by corner, read through three.js. */
const layoutOf = (geometry: BufferGeometry): number[][] =>
  cornerLayout.map(({ name, itemSize }) => {
    const attribute = geometry.getAttribute(name);
    return Array.from({ length: attribute.count * itemSize }, (_, i) =>
      attribute.getComponent(Math.floor(i / itemSize), i % itemSize),
    );
  });

/** The index of a number of triangles, all but the first of them degenerate, so that a bake is fast. */
function indexOf(triangles: number): Uint32Array {
  const index = new Uint32Array(3 * triangles);
  index.set([0, 1, 2]);
  return index;
}

describe('the prepared geometry', () => {
  test('is a new, non-indexed one with positions, one interleaved buffer, normals, bounds and statistics', async () => {
    const geometry = quad();
    geometry.name = 'quad';
    geometry.userData = { mine: { a: 1 } };
    const before = snapshot(geometry);
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect(snapshot(geometry)).toEqual(before);

    expect(prepared).not.toBe(geometry);
    expect(prepared.index).toBeNull();
    expect(prepared.name).toBe('quad');
    expect([...arrayOf(prepared, 'position')]).toEqual(quadCorners);
    const buffers = cornerLayout.map(({ name, itemSize }) => {
      const attribute = prepared.getAttribute(name) as InterleavedBufferAttribute;
      expect(attribute.itemSize).toBe(itemSize);
      return attribute.data;
    });
    expect(new Set(buffers).size).toBe(1);
    expect(buffers[0].stride).toBe(CORNER_STRIDE);
    expect(layoutOf(prepared)[0].slice(0, 8)).toEqual([1, 0, 0, 0, 0, 1, 0, 1]);
    const hatchNormal = prepared.getAttribute('hatchNormal') as BufferAttribute;
    expect([hatchNormal.itemSize, hatchNormal.normalized]).toEqual([4, true]);
    expect(hatchNormal.array).toEqual(Int16Array.from({ length: 24 }, (_, i) => (i % 4 === 2 ? 32767 : 0)));
    expect([...arrayOf(prepared, 'normal')]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect(prepared.boundingBox!.min.toArray()).toEqual([0, 0, 0]);
    expect(prepared.boundingBox!.max.toArray()).toEqual([1, 1, 0]);
    expect(prepared.boundingSphere!.center.toArray()).toEqual([0.5, 0.5, 0]);
    expect(prepared.boundingSphere!.radius).toBeCloseTo(Math.SQRT1_2, 12);
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
      layout: 'corner',
      direction: 'light',
      bytes: 6 * ((3 + 16 + 3) * 4 + 8),
    };
    expect(prepared.userData).toEqual({ mine: { a: 1 }, hatching: statistics });
  });

  test.each([
    [{ technique: 'triangle' }, 'corner'],
    [{ technique: 'adjacency' }, 'corner'],
    [{ technique: 'hatching' }, 'indexed'],
    [{ technique: 'engraving' }, 'indexed'],
    [{ technique: 'engraving', adjacency: true }, 'corner'],
  ] as const)('has what the technique needs: %j', async (options, layout) => {
    expect((await prepareHatchingGeometry(quad(), options)).userData.hatching.layout).toBe(layout);
  });

  test('can be prepared again with the same result', async () => {
    const once = await prepareHatchingGeometry(new BoxGeometry(), { adjacency: true });
    const twice = await prepareHatchingGeometry(once, { adjacency: true });
    expect(layoutOf(twice)).toEqual(layoutOf(once));
    expect(Object.keys(twice.attributes).sort()).toEqual(Object.keys(once.attributes).sort());
    expect(twice.userData).toEqual(once.userData);
  });

  test('does not depend on changes during the bake', async () => {
    const geometry = quad();
    const expected = layoutOf(await prepareHatchingGeometry(quad(), { adjacency: true }));
    const promise = prepareHatchingGeometry(geometry, { adjacency: true });
    (geometry.attributes.position.array as Float32Array).fill(7);
    geometry.addGroup(0, 3, 1);
    geometry.name = 'changed';
    const prepared = await promise;
    expect(layoutOf(prepared)).toEqual(expected);
    expect(prepared.groups).toEqual([]);
    expect(prepared.name).toBe('');
  });
});

describe('input', () => {
  const expected = async () => layoutOf(await prepareHatchingGeometry(quad(), { adjacency: true }));
  const withIndex = (index: TypedArray) => {
    const geometry = quad();
    geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
  };
  const withPosition = (position: BufferAttribute | InterleavedBufferAttribute) => {
    const geometry = quad();
    geometry.setAttribute('position', position);
    return geometry;
  };
  // Ten other floats before and between the positions.
  const interleaved = new InterleavedBuffer(
    new Float32Array([0, 1, 2, 3].flatMap((v) => [9, 9, ...quadPositions.slice(3 * v, 3 * v + 3), 9])),
    6,
  );

  test.each<[string, () => BufferGeometry]>([
    ['16-bit indices', () => withIndex(new Uint16Array(quadIndices))],
    ['32-bit indices', () => withIndex(new Uint32Array(quadIndices))],
    ['8-bit indices', () => withIndex(new Uint8Array(quadIndices))],
    ['no index', () => quad().toNonIndexed()],
    ['interleaved', () => withPosition(new InterleavedBufferAttribute(interleaved, 3, 2))],
    [
      'normalised bytes',
      () => withPosition(new BufferAttribute(new Uint8Array(quadPositions.map((v) => 255 * v)), 3, true)),
    ],
    [
      'normalised shorts',
      () => withPosition(new BufferAttribute(new Int16Array(quadPositions.map((v) => 32767 * v)), 3, true)),
    ],
    ['plain shorts', () => withPosition(new BufferAttribute(new Int16Array(quadPositions), 3))],
    [
      'half floats',
      () =>
        withPosition(
          new Float16BufferAttribute(
            quadPositions.map((v) => 0x3c00 * v),
            3,
          ),
        ),
    ],
    ['doubles', () => withPosition(new BufferAttribute(new Float64Array(quadPositions), 3))],
    [
      'a shared buffer',
      () => {
        const array = new Float32Array(new SharedArrayBuffer(48));
        array.set(quadPositions);
        return withPosition(new BufferAttribute(array, 3));
      },
    ],
    [
      'a view into a larger buffer',
      () => {
        const array = new Float32Array([9, ...quadPositions, 9]).subarray(1, 13);
        return withPosition(new BufferAttribute(array, 3));
      },
    ],
  ])('%s', async (_, create) => {
    const geometry = create();
    const before = snapshot(geometry);
    expect(layoutOf(await prepareHatchingGeometry(geometry, { adjacency: true }))).toEqual(await expected());
    expect(snapshot(geometry)).toEqual(before);
  });

  test('quantised positions have the value that the vertex shader reads', async () => {
    const values = new Int16Array([-32768, -32767, 1, 12345, 0, 32767, 1, 2, -3]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(values, 3, true));
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect([...arrayOf(prepared, 'position')]).toEqual(
      [...values].map((value) => Math.fround(Math.max(value / 32767, -1))),
    );
  });
});

describe('attributes', () => {
  test('are expanded in their type, size and normalisation', async () => {
    const geometry = quad();
    geometry.setAttribute(
      'normal',
      new BufferAttribute(new Int8Array([0, 0, 127, 1, 0, 127, 2, 0, 127, 3, 0, 127]), 3, true),
    );
    geometry.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]), 2));
    geometry.setAttribute(
      'color',
      new BufferAttribute(new Uint8ClampedArray([0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23, 30, 31, 32, 33]), 4, true),
    );
    geometry.setAttribute(
      'skinIndex',
      new BufferAttribute(new Uint16Array([0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]), 4),
    );
    geometry.setAttribute('half', new Float16BufferAttribute([0x3c00, 0x4000, 0x4200, 0x4400], 1));
    geometry.setAttribute('precise', new BufferAttribute(new Float64Array([Math.PI, Math.E, -0, Number.NaN]), 1));
    const id = new BufferAttribute(new Int32Array([-1, -2, -3, -4]), 1);
    id.gpuType = IntType;
    id.name = 'identity';
    geometry.setAttribute('id', id);
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });

    for (const [name, source] of Object.entries(geometry.attributes)) {
      if (name === 'position') continue;
      const attribute = prepared.getAttribute(name) as BufferAttribute;
      expect(attribute.array.constructor, name).toBe(source.array.constructor);
      expect(attribute.count, name).toBe(6);
      for (const property of ['itemSize', 'normalized', 'gpuType', 'name', 'isFloat16BufferAttribute'] as const) {
        expect(Reflect.get(attribute, property), `${name}.${property}`).toEqual(Reflect.get(source, property));
      }
      for (const [corner, vertex] of quadIndices.entries()) {
        for (let i = 0; i < source.itemSize; i++) {
          expect(attribute.getComponent(corner, i), name).toBe(source.getComponent(vertex, i));
        }
      }
    }
  });

  test('interleaved ones are taken apart', async () => {
    const geometry = quad();
    const buffer = new InterleavedBuffer(
      new Uint8Array([1, 2, 3, 4, 11, 12, 13, 14, 21, 22, 23, 24, 31, 32, 33, 34]),
      4,
    );
    geometry.setAttribute('color', new InterleavedBufferAttribute(buffer, 3, 1, true));
    const color = (await prepareHatchingGeometry(geometry, { adjacency: true })).getAttribute('color');
    expect(color.normalized).toBe(true);
    expect(color.array).toEqual(new Uint8Array([2, 3, 4, 12, 13, 14, 22, 23, 24, 22, 23, 24, 12, 13, 14, 32, 33, 34]));
  });

  test('morph targets are kept, and the bounds include them', async () => {
    const geometry = quad();
    geometry.morphTargetsRelative = true;
    const up = new Float32BufferAttribute([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5], 3);
    up.name = 'up';
    const down = new Float32BufferAttribute([0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0], 3);
    geometry.morphAttributes.position = [up, down];
    geometry.morphAttributes.color = [new BufferAttribute(new Uint8Array([1, 2, 3, 4]), 1)];
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect(prepared.morphTargetsRelative).toBe(true);
    expect(prepared.morphAttributes.position!.map(({ name, count }) => [name, count])).toEqual([
      ['up', 6],
      ['', 6],
    ]);
    expect(prepared.morphAttributes.position![0].getZ(5)).toBe(5);
    expect(prepared.morphAttributes.position![1].getZ(0)).toBe(-1);
    expect([...prepared.morphAttributes.color![0].array]).toEqual([1, 2, 3, 3, 2, 4]);
    expect([prepared.boundingBox!.min.z, prepared.boundingBox!.max.z]).toEqual([-1, 5]);
  });

  test('instanced ones are copied as they are', async () => {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(quadPositions, 3));
    geometry.setIndex(quadIndices);
    geometry.instanceCount = 2;
    geometry.setAttribute('offset', new InstancedBufferAttribute(new Float32Array([1, 2, 3, 4]), 2, false, 3));
    const buffer = new InstancedInterleavedBuffer(new Float32Array([1, 2, 3, 4, 5, 6]), 3, 1);
    geometry.setAttribute('turn', new InterleavedBufferAttribute(buffer, 1, 0));
    geometry.setAttribute('tint', new InterleavedBufferAttribute(buffer, 2, 1));
    const prepared = (await prepareHatchingGeometry(geometry, { adjacency: true })) as InstancedBufferGeometry;
    expect(prepared.isInstancedBufferGeometry).toBe(true);
    expect(prepared.instanceCount).toBe(2);
    const offset = prepared.getAttribute('offset') as InstancedBufferAttribute;
    expect([offset.meshPerAttribute, ...offset.array]).toEqual([3, 1, 2, 3, 4]);
    expect(offset.array).not.toBe(arrayOf(geometry, 'offset'));
    const turn = prepared.getAttribute('turn') as InterleavedBufferAttribute;
    const tint = prepared.getAttribute('tint') as InterleavedBufferAttribute;
    expect(turn.data).toBe(tint.data);
    expect(turn.data).toBeInstanceOf(InstancedInterleavedBuffer);
    expect([turn.getX(1), tint.getY(1)]).toEqual([4, 6]);
  });
});

describe('draw range and groups', () => {
  /** A row of four separate quads: eight triangles, 24 corners. */
  function row(): BufferGeometry {
    const geometry = new BufferGeometry();
    const positions = [0, 1, 2, 3].flatMap((x) => quadCorners.map((value, i) => (i % 3 === 0 ? value + 2 * x : value)));
    geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
    return geometry;
  }

  test('groups are counted in corners and keep their material', async () => {
    const box = new BoxGeometry();
    const prepared = await prepareHatchingGeometry(box, { adjacency: true });
    expect(prepared.groups).toEqual(box.groups);
    // Adjacency runs across groups: no side of a box has a border.
    expect(prepared.userData.hatching.borderEdges).toBe(0);
  });

  test('only the draw range is baked, and groups are cut to it', async () => {
    const geometry = row();
    geometry.setDrawRange(3, 12);
    geometry.addGroup(0, 6, 2);
    geometry.addGroup(6, 6, 1);
    geometry.addGroup(12, 12, 0);
    geometry.addGroup(18, 6, 5);
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect([...arrayOf(prepared, 'position')]).toEqual([...arrayOf(geometry, 'position').subarray(9, 45)]);
    expect(prepared.groups).toEqual([
      { start: 0, count: 3, materialIndex: 2 },
      { start: 3, count: 6, materialIndex: 1 },
      { start: 9, count: 3, materialIndex: 0 },
    ]);
    expect(prepared.drawRange).toEqual({ start: 0, count: Infinity });
    expect(prepared.userData.hatching).toMatchObject({ triangles: 4, borderEdges: 10 });
    expect(prepared.boundingBox!.max.x).toBe(5);
  });

  test('an index is cut too', async () => {
    const geometry = quad();
    geometry.setDrawRange(3, 3);
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect([...arrayOf(prepared, 'position')]).toEqual(quadCorners.slice(9));
  });

  test('a group of infinite count ends with the geometry', async () => {
    const geometry = row();
    geometry.addGroup(6, Infinity, 1);
    expect((await prepareHatchingGeometry(geometry, { adjacency: true })).groups).toEqual([
      { start: 6, count: 18, materialIndex: 1 },
    ]);
  });
});

describe('options', () => {
  test.each<[string, (geometry: BufferGeometry) => void, HatchingStatistics['layout']]>([
    ['nothing that deforms', () => {}, 'corner'],
    ['a skin', (g) => g.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(16), 4)), 'pull'],
    ['morphed positions', (g) => Reflect.set(g.morphAttributes, 'position', [g.attributes.position]), 'pull'],
    ['morphed normals', (g) => Reflect.set(g.morphAttributes, 'normal', [g.attributes.position]), 'pull'],
    ['200,000 triangles', (g) => g.setIndex(new BufferAttribute(indexOf(200_000), 1)), 'corner'],
    ['more triangles than that', (g) => g.setIndex(new BufferAttribute(indexOf(200_001), 1)), 'pull'],
    ['morphed colours', (g) => Reflect.set(g.morphAttributes, 'color', [g.attributes.position]), 'corner'],
  ])('the layout auto, with %s', async (_, change, layout) => {
    const geometry = quad();
    change(geometry);
    const prepared = await prepareHatchingGeometry(geometry, { adjacency: true });
    expect(prepared.userData.hatching.layout).toBe(layout);
    expect(prepared.hasAttribute('cornerNext')).toBe(layout === 'corner');
  });

  test('the layout pull takes 32 bytes per triangle and 16 per vertex, besides the corners', async () => {
    const source = new TorusKnotGeometry(1, 0.3, 400, 32);
    const { triangles, bytes, borderEdges } = (await prepareHatchingGeometry(source, { layout: 'pull' })).userData
      .hatching;
    const rows = (texels: number) => 2048 * Math.ceil(texels / 2048);
    const textures = 16 * (rows(2 * triangles) + rows(source.attributes.position.count));
    expect(bytes).toBe(triangles * 3 * (12 + 12 + 8 + 8) + textures);
    expect(textures / triangles).toBeLessThan(41);
    expect(borderEdges).toBe(0);
  });

  test('creaseAngle cuts neighbours and splits added normals', async () => {
    const box = new BoxGeometry().deleteAttribute('normal');
    const opposite = async (creaseAngle?: number) => {
      const prepared = await prepareHatchingGeometry(box, { adjacency: true, creaseAngle });
      const { array } = prepared.getAttribute('normal');
      return {
        alpha: layoutOf(prepared)[2],
        axisAligned: array.every((value) => value === 0 || Math.abs(value) === 1),
      };
    };
    const all = await opposite(Math.PI);
    const none = await opposite(Math.PI / 3);
    // By the rule of Suarez et al. too, the faces of a cube do not influence each other.
    expect(await opposite()).toEqual(none);
    expect(none.alpha).not.toEqual(all.alpha);
    expect([all.axisAligned, none.axisAligned]).toEqual([false, true]);
  });

  test.each([
    [{}, 'indexed'],
    [{ adjacency: false }, 'indexed'],
    [{ adjacency: true }, 'corner'],
    [{ layout: 'auto' }, 'corner'],
    [{ adjacency: true, layout: 'pull' }, 'pull'],
    [{ layout: 'pull' }, 'pull'],
  ] as const)('%j gives the layout %s', async (options, layout) => {
    expect((await prepareHatchingGeometry(new BoxGeometry(), options)).userData.hatching.layout).toBe(layout);
  });

  test('a crease angle of 0 parts coplanar triangles too, without a NaN', async () => {
    for (const layout of ['corner', 'pull', 'indexed'] as const) {
      const source = new BoxGeometry(1, 1, 1, 2, 2, 2).deleteAttribute('normal');
      const prepared = await prepareHatchingGeometry(source, { layout, creaseAngle: 0 });
      for (const attribute of Object.values(prepared.attributes)) {
        expect(attribute.array.every(Number.isFinite)).toBe(true);
      }
      if (layout !== 'corner') continue;
      // Across every edge lies the triangle's own opposite vertex.
      const [, , alpha, beta, gamma] = layoutOf(prepared);
      const positions = [...arrayOf(prepared, 'position')];
      expect(alpha.slice(0, 3)).toEqual(positions.slice(6, 9));
      expect(beta.slice(0, 3)).toEqual(positions.slice(0, 3));
      expect(gamma.slice(0, 3)).toEqual(positions.slice(3, 6));
    }
  });

  test('progress rises and ends at 1', async () => {
    const progress: number[] = [];
    await prepareHatchingGeometry(new BoxGeometry(1, 1, 1, 60, 60, 60), {
      onProgress: (value) => progress.push(value),
    });
    expect(progress.at(-1)).toBe(1);
    for (let i = 1; i < progress.length; i++) expect(progress[i]).toBeGreaterThan(progress[i - 1]);
  });

  test('an aborted signal rejects with its reason, before any check', async () => {
    const reason = new Error('not wanted');
    await expect(prepareHatchingGeometry(null as never, { signal: AbortSignal.abort(reason) })).rejects.toBe(reason);
  });

  test('aborting midway rejects with the reason and leaves the geometry alone', async () => {
    const geometry = new BoxGeometry(1, 1, 1, 60, 60, 60);
    const before = snapshot(geometry);
    const controller = new AbortController();
    const promise = prepareHatchingGeometry(geometry, { signal: controller.signal });
    controller.abort();
    await expect(promise).rejects.toHaveProperty('name', 'AbortError');
    expect(snapshot(geometry)).toEqual(before);
  });
});
