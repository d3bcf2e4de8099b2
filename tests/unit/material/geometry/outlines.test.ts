import { isDeepStrictEqual } from 'node:util';
import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry, type Texture, TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { type OutlineData, outlineDataOf } from '../../../../src/material/geometry/OutlineData.js';
import type { PrepareHatchingGeometryOptions } from '../../../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { BORDER, CREASE, MATERIAL_BORDER, POINT_MASK } from '../../../../src/mesh/bake/outlineLayout.js';
import { reactive } from './reactive.js';

const prepare = (geometry: BufferGeometry, options: PrepareHatchingGeometryOptions = { outlines: true }) =>
  prepareHatchingGeometry(geometry, options);

const wordsOf = ({ image }: Texture): Uint32Array => (image as { data: Uint32Array }).data;

/** The number of edges with a flag of the first word. */
function countOf(geometry: BufferGeometry, flag: number): number {
  const { primitives, triangleCount, edgeCount } = outlineDataOf(geometry)!;
  const edges = wordsOf(primitives).subarray(4 * triangleCount, 4 * (triangleCount + edgeCount));
  return [...edges].filter((word, i) => i % 4 === 0 && (word >>> 28) & flag).length;
}

describe('options', () => {
  const rejected = (outlines: unknown) =>
    prepare(new BoxGeometry(), { outlines: outlines as boolean }).then(
      () => 'none',
      (error: Error) => `${error.constructor.name}: ${error.message}`,
    );

  test('that are unknown are refused', async () => {
    expect(await rejected({ featureAngles: 1 })).toBe(
      'TypeError: prepareHatchingGeometry: unknown option "featureAngles". The known ones are featureAngle, creaseLength.',
    );
    for (const outlines of ['yes', 1, null, () => {}]) {
      expect(await rejected(outlines)).toMatch(/^TypeError: prepareHatchingGeometry: the outlines are /);
    }
  });

  test.each([-0.1, 3.2, Number.NaN, Infinity])('a featureAngle of %d is refused', async (featureAngle) => {
    expect(await rejected({ featureAngle })).toMatch(
      `RangeError: prepareHatchingGeometry: outlines.featureAngle is ${featureAngle}. Pass an angle in radians from 0 to π`,
    );
  });

  test.each([-1, Number.NaN, Infinity])('a creaseLength of %d is refused', async (creaseLength) => {
    expect(await rejected({ creaseLength })).toMatch(
      `RangeError: prepareHatchingGeometry: outlines.creaseLength is ${creaseLength}. Pass a length in object units, 0 or more`,
    );
  });

  test.each([
    true,
    {},
    { featureAngle: undefined, creaseLength: undefined },
    { featureAngle: 0 },
    { featureAngle: Math.PI, creaseLength: 0 },
  ])('%j is taken', async (outlines) => {
    expect(outlineDataOf(await prepare(new BoxGeometry(), { outlines }))).toBeDefined();
  });

  test.each([undefined, false])('%s asks for none', async (outlines) => {
    const geometry = await prepare(new BoxGeometry(), { outlines });
    expect(outlineDataOf(geometry)).toBeUndefined();
  });

  test('reach the bake', async () => {
    const box = new BoxGeometry();
    expect(countOf(await prepare(box), CREASE)).toBe(12);
    expect(countOf(await prepare(box, { outlines: { creaseLength: 12.1 } }), CREASE)).toBe(0);
    expect(countOf(await prepare(box, { outlines: { creaseLength: 11.9 } }), CREASE)).toBe(12);
    expect(countOf(await prepare(box, { outlines: { featureAngle: 1.6 } }), CREASE)).toBe(0);
    expect(countOf(await prepare(box, { outlines: { featureAngle: 1.5 } }), CREASE)).toBe(12);
    // The six sides of a box are groups, whose materials differ.
    expect(countOf(await prepare(box), MATERIAL_BORDER)).toBe(12);
    box.clearGroups();
    expect(countOf(await prepare(box), MATERIAL_BORDER)).toBe(0);
  });

  test('groups are those of the draw range', async () => {
    const plane = new PlaneGeometry(1, 1, 2, 1);
    plane.addGroup(0, 6, 0);
    plane.addGroup(6, 6, 1);
    expect(countOf(await prepare(plane), MATERIAL_BORDER)).toBe(1);
    plane.setDrawRange(6, 6);
    const half = await prepare(plane);
    expect([countOf(half, MATERIAL_BORDER), countOf(half, BORDER)]).toEqual([0, 4]);
  });
});

describe.each(['corner', 'pull', 'indexed'] as const)('in the layout %s', (layout) => {
  test('outlines are counted in the bytes, and nothing else of the geometry changes', async () => {
    const source = new SphereGeometry(1, 48, 24);
    const [without, prepared] = [
      await prepare(source, { layout }),
      await prepare(source, { layout, outlines: true }),
    ] as const;
    const { points, primitives, triangleCount } = outlineDataOf(prepared)!;
    expect(triangleCount).toBe(without.userData.hatching.triangles);
    const bytes = wordsOf(points).byteLength + wordsOf(primitives).byteLength;
    expect(bytes).toBeGreaterThan(16 * triangleCount + 32 * 1000);
    expect(prepared.userData.hatching).toEqual({
      ...without.userData.hatching,
      bytes: without.userData.hatching.bytes + bytes,
    });
    expect(Object.keys(prepared.attributes)).toEqual(Object.keys(without.attributes));
    for (const [name, attribute] of Object.entries(without.attributes)) {
      expect(Buffer.from(prepared.getAttribute(name).array.buffer).equals(Buffer.from(attribute.array.buffer))).toBe(
        true,
      );
    }
  });
});

describe('the data of outlines', () => {
  const isFreed = (data: OutlineData) => {
    const freed = { points: 0, primitives: 0 };
    for (const name of ['points', 'primitives'] as const) data[name].addEventListener('dispose', () => freed[name]++);
    return freed;
  };

  test('are shared by clones, and freed with the geometry', async () => {
    const geometry = await prepare(new BoxGeometry());
    const data = outlineDataOf(geometry)!;
    const clone = geometry.clone();
    expect(outlineDataOf(clone)).toBe(data);
    expect(outlineDataOf(reactive(geometry))).toBe(data);
    const freed = isFreed(data);
    geometry.dispose();
    expect(freed).toEqual({ points: 1, primitives: 1 });
  });

  test('are those of one geometry alone', async () => {
    const [a, b] = [await prepare(new BoxGeometry()), await prepare(new BoxGeometry())];
    expect(outlineDataOf(a)).not.toBe(outlineDataOf(b));
    expect(outlineDataOf(new BoxGeometry())).toBeUndefined();
    const freed = isFreed(outlineDataOf(b)!);
    a.dispose();
    expect(freed).toEqual({ points: 0, primitives: 0 });
  });

  test('are not those of the geometry it was prepared from', async () => {
    const geometry = await prepare(new BoxGeometry());
    expect(outlineDataOf(await prepare(geometry, {}))).toBeUndefined();
    const again = await prepare(geometry);
    expect(outlineDataOf(again)).not.toBe(outlineDataOf(geometry));
    expect(wordsOf(outlineDataOf(again)!.primitives)).toEqual(wordsOf(outlineDataOf(geometry)!.primitives));
  });

  test('are lost with JSON, without an error', async () => {
    const geometry = await prepare(new BoxGeometry());
    geometry.userData = JSON.parse(JSON.stringify(geometry.userData));
    expect(outlineDataOf(geometry)).toBeUndefined();
    for (const hatching of [null, 3, 'x', undefined]) {
      geometry.userData = { hatching };
      expect(outlineDataOf(geometry)).toBeUndefined();
    }
  });

  test('are two textures of whole rows, uploaded once, and the search data', async () => {
    const geometry = await prepare(new SphereGeometry(1, 64, 32));
    const { points, primitives, search, triangleCount, edgeCount, radius, isSearchedInWorker } =
      outlineDataOf(geometry)!;
    for (const texture of [points, primitives]) {
      const { width, height } = texture.image;
      expect(width).toBe(2048);
      expect(wordsOf(texture)).toHaveLength(4 * width * height);
      expect(texture.version).toBe(1);
    }
    expect(isSearchedInWorker).toBe(false);
    expect(radius).toBeCloseTo(1, 6);
    expect(search).toMatchObject({ triangleCount, edgeCount, pointMask: POINT_MASK });
    expect(search!.sides).toHaveLength(search!.positions.length / 3);
    expect(search!.list).toHaveLength(triangleCount + edgeCount);
    expect(search!.primitives).toBe(wordsOf(primitives));
  });

  test('include a copy for the worker if that searches, made by the bake', async () => {
    const prepared = await prepareHatchingGeometry(new TorusGeometry(1, 0.4, 250, 200), { outlines: true });
    const large = outlineDataOf(prepared)!;
    expect(large.isSearchedInWorker).toBe(true);
    const copy = large.search!.primitives;
    expect(copy === wordsOf(large.primitives)).toBe(false);
    expect(isDeepStrictEqual(copy, wordsOf(large.primitives))).toBe(true);
    large.restoreSearch();
    expect(large.search!.primitives === wordsOf(large.primitives)).toBe(false);
    expect(isDeepStrictEqual(large.search!.primitives, copy)).toBe(true);
    const small = await prepareHatchingGeometry(new TorusGeometry(1, 0.4, 250, 199), { outlines: true });
    expect(outlineDataOf(small)!.isSearchedInWorker).toBe(false);
  });

  test.each(['corner', 'pull', 'indexed'] as const)('use the worker of the options, layout %s', async (layout) => {
    const createWorker = () => null as unknown as Worker;
    const geometry = await prepare(new BoxGeometry(), { outlines: true, layout, createWorker });
    expect(outlineDataOf(geometry)!.createWorker).toBe(createWorker);
    expect(outlineDataOf(await prepare(new BoxGeometry(), { outlines: true, layout }))!.createWorker).toBeUndefined();
  });
});
