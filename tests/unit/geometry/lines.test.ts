import { isDeepStrictEqual } from 'node:util';
import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry, type Texture } from 'three';
import { describe, expect, test } from 'vitest';
import { POINT_MASK } from '../../../src/bake/lineLayout.js';
import { BORDER, CREASE, MATERIAL_BORDER } from '../../../src/features/edgeFlags.js';
import { LineData, lineDataOf } from '../../../src/geometry/LineData.js';
import {
  type PrepareHatchingGeometryOptions,
  prepareHatchingGeometry,
} from '../../../src/geometry/prepareHatchingGeometry.js';
import { reactive } from './reactive.js';

const prepare = (geometry: BufferGeometry, options: PrepareHatchingGeometryOptions = { lines: true }) =>
  prepareHatchingGeometry(geometry, options);

const wordsOf = ({ image }: Texture): Uint32Array => (image as { data: Uint32Array }).data;

/** How many edges have a flag of the first word. */
function countOf(geometry: BufferGeometry, flag: number): number {
  const { primitives, triangleCount, edgeCount } = lineDataOf(geometry)!;
  const edges = wordsOf(primitives).subarray(4 * triangleCount, 4 * (triangleCount + edgeCount));
  return [...edges].filter((word, i) => i % 4 === 0 && (word >>> 28) & flag).length;
}

describe('options', () => {
  const rejected = (lines: unknown) =>
    prepare(new BoxGeometry(), { lines: lines as boolean }).then(
      () => 'none',
      (error: Error) => `${error.constructor.name}: ${error.message}`,
    );

  test('that are unknown are refused', async () => {
    expect(await rejected({ creaseAngles: 1 })).toBe(
      'TypeError: prepareHatchingGeometry: unknown option "creaseAngles". The known ones are creaseAngle, creaseLength.',
    );
    for (const lines of ['yes', 1, null, () => {}]) {
      expect(await rejected(lines)).toMatch(/^TypeError: prepareHatchingGeometry: the lines are /);
    }
  });

  test.each([-0.1, 3.2, Number.NaN, Infinity])('a creaseAngle of %d is refused', async (creaseAngle) => {
    expect(await rejected({ creaseAngle })).toMatch(
      `RangeError: prepareHatchingGeometry: lines.creaseAngle is ${creaseAngle}. Pass an angle in radians from 0 to π`,
    );
  });

  test.each([-1, Number.NaN, Infinity])('a creaseLength of %d is refused', async (creaseLength) => {
    expect(await rejected({ creaseLength })).toMatch(
      `RangeError: prepareHatchingGeometry: lines.creaseLength is ${creaseLength}. Pass a length in object units, 0 or more`,
    );
  });

  test.each([
    true,
    {},
    { creaseAngle: undefined, creaseLength: undefined },
    { creaseAngle: 0 },
    { creaseAngle: Math.PI, creaseLength: 0 },
  ])('%j is taken', async (lines) => {
    expect(lineDataOf(await prepare(new BoxGeometry(), { lines }))).toBeDefined();
  });

  test.each([undefined, false])('%s asks for none', async (lines) => {
    const geometry = await prepare(new BoxGeometry(), { lines });
    expect(lineDataOf(geometry)).toBeUndefined();
  });

  test('reach the bake', async () => {
    const box = new BoxGeometry();
    expect(countOf(await prepare(box), CREASE)).toBe(12);
    expect(countOf(await prepare(box, { lines: { creaseLength: 12.1 } }), CREASE)).toBe(0);
    expect(countOf(await prepare(box, { lines: { creaseLength: 11.9 } }), CREASE)).toBe(12);
    expect(countOf(await prepare(box, { lines: { creaseAngle: 1.6 } }), CREASE)).toBe(0);
    expect(countOf(await prepare(box, { lines: { creaseAngle: 1.5 } }), CREASE)).toBe(12);
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
  test('lines are counted in the bytes, and nothing else of the geometry changes', async () => {
    const source = new SphereGeometry(1, 48, 24);
    const [without, prepared] = [
      await prepare(source, { layout }),
      await prepare(source, { layout, lines: true }),
    ] as const;
    const { points, primitives, triangleCount } = lineDataOf(prepared)!;
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

describe('the data of lines', () => {
  const isFreed = (data: LineData) => {
    const freed = { points: 0, primitives: 0 };
    for (const name of ['points', 'primitives'] as const) data[name].addEventListener('dispose', () => freed[name]++);
    return freed;
  };

  test('are shared by clones, and freed with the geometry', async () => {
    const geometry = await prepare(new BoxGeometry());
    const data = lineDataOf(geometry)!;
    const clone = geometry.clone();
    expect(lineDataOf(clone)).toBe(data);
    expect(lineDataOf(reactive(geometry))).toBe(data);
    const freed = isFreed(data);
    geometry.dispose();
    expect(freed).toEqual({ points: 1, primitives: 1 });
  });

  test('are those of one geometry alone', async () => {
    const [a, b] = [await prepare(new BoxGeometry()), await prepare(new BoxGeometry())];
    expect(lineDataOf(a)).not.toBe(lineDataOf(b));
    expect(lineDataOf(new BoxGeometry())).toBeUndefined();
    const freed = isFreed(lineDataOf(b)!);
    a.dispose();
    expect(freed).toEqual({ points: 0, primitives: 0 });
  });

  test('are not those of the geometry it was prepared from', async () => {
    const geometry = await prepare(new BoxGeometry());
    expect(lineDataOf(await prepare(geometry, {}))).toBeUndefined();
    const again = await prepare(geometry);
    expect(lineDataOf(again)).not.toBe(lineDataOf(geometry));
    expect(wordsOf(lineDataOf(again)!.primitives)).toEqual(wordsOf(lineDataOf(geometry)!.primitives));
  });

  test('are lost with JSON, and no harm is done', async () => {
    const geometry = await prepare(new BoxGeometry());
    geometry.userData = JSON.parse(JSON.stringify(geometry.userData));
    expect(lineDataOf(geometry)).toBeUndefined();
    for (const hatching of [null, 3, 'x', undefined]) {
      geometry.userData = { hatching };
      expect(lineDataOf(geometry)).toBeUndefined();
    }
  });

  test('are two textures of whole rows, uploaded once, and what contours are looked for in', async () => {
    const geometry = await prepare(new SphereGeometry(1, 64, 32));
    const { points, primitives, search, triangleCount, edgeCount, radius, isSearchedInWorker } = lineDataOf(geometry)!;
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

  test('have a copy for the worker where that does the search', () => {
    const triangleCount = 100_000;
    const packed = {
      points: new Uint32Array(8 * 2048),
      primitives: new Uint32Array(4 * 2048 * 49).map((_, i) => i),
      triangleCount,
      edgeCount: 0,
      positions: new Float32Array(9),
      normals: new Float32Array(9),
      radius: 1,
    };
    const large = new LineData(packed);
    expect(large.isSearchedInWorker).toBe(true);
    expect(large.search!.primitives === wordsOf(large.primitives)).toBe(false);
    expect(isDeepStrictEqual(large.search!.primitives, wordsOf(large.primitives))).toBe(true);
    expect(new LineData({ ...packed, triangleCount: triangleCount - 1 }).isSearchedInWorker).toBe(false);
  });

  test.each(['corner', 'pull', 'indexed'] as const)(
    'know the worker that the options name, layout %s',
    async (layout) => {
      const createWorker = () => null as unknown as Worker;
      const geometry = await prepare(new BoxGeometry(), { lines: true, layout, createWorker });
      expect(lineDataOf(geometry)!.createWorker).toBe(createWorker);
      expect(lineDataOf(await prepare(new BoxGeometry(), { lines: true, layout }))!.createWorker).toBeUndefined();
    },
  );
});
