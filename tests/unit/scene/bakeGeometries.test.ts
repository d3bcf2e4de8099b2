import { BoxGeometry, BufferAttribute, type BufferGeometry, PlaneGeometry } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { bakeGeometries } from '../../../src/scene/bakeGeometries.js';

const boxes = (count: number) =>
  new Map(Array.from({ length: count }, () => [new BoxGeometry() as BufferGeometry, { layout: 'indexed' as const }]));
const nothing = { onBaked: () => {} };

afterEach(() => vi.unstubAllGlobals());

describe.each([1, 3])('with %s cores', (hardwareConcurrency) => {
  const start = () => vi.stubGlobal('navigator', { hardwareConcurrency });

  test('progress rises to 1, and finished geometries are counted', async () => {
    start();
    const progress: number[] = [];
    const counts: [number, number][] = [];
    const layouts = boxes(7);
    const results = await bakeGeometries(
      layouts,
      { onProgress: (value) => progress.push(value) },
      { onBaked: () => {}, onCount: (...count) => counts.push(count) },
    );
    expect([...results.keys()]).toEqual([...layouts.keys()]);
    expect(progress.at(-1)).toBe(1);
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(counts).toEqual([1, 2, 3, 4, 5, 6, 7].map((done) => [done, 7]));
  });

  test('a faulty geometry stops no other', async () => {
    start();
    const layouts = boxes(4);
    const [, faulty] = layouts.keys();
    faulty.attributes.position.setX(0, Number.NaN);
    const results = [...(await bakeGeometries(layouts, {}, nothing)).values()];
    expect(results.map((result) => result instanceof RangeError)).toEqual([false, true, false, false]);
  });

  test('an abort stops all, and every baked geometry was reported', async () => {
    start();
    const controller = new AbortController();
    const baked: BufferGeometry[] = [];
    const task = bakeGeometries(
      boxes(9),
      { signal: controller.signal },
      { onBaked: (geometry) => baked.push(geometry), onCount: () => controller.abort(new Error('enough')) },
    );
    await expect(task).rejects.toThrow('enough');
    const known = baked.length;
    expect(known).toBeGreaterThan(0);
    expect(known).toBeLessThanOrEqual(hardwareConcurrency);
    // In the time of as many others they would have been baked.
    await bakeGeometries(boxes(9), {}, nothing);
    expect(baked).toHaveLength(known);
  });

  test('a listener that throws stops all', async () => {
    start();
    const fail = () => {
      throw new TypeError('in the listener');
    };
    await expect(bakeGeometries(boxes(5), { onProgress: fail }, nothing)).rejects.toThrow('in the listener');
    await expect(bakeGeometries(boxes(5), {}, { ...nothing, onCount: fail })).rejects.toThrow('in the listener');
  });
});

test('as many are baked at a time as there are cores, but fewer large ones, and one of small ones', {
  tags: ['all'],
}, async () => {
  vi.stubGlobal('navigator', { hardwareConcurrency: 4 });
  /** The greatest number of `count` geometries that are being baked at a time. */
  const mostAtOnce = async (count: number, make: () => BufferGeometry) => {
    let begun = 0;
    let done = 0;
    let most = 0;
    const layouts = new Map(
      Array.from({ length: count }, () => {
        const geometry = make();
        const { attributes } = geometry;
        let isKnown = false;
        // A bake starts with the first read of a geometry's attributes.
        Object.defineProperty(geometry, 'isBufferGeometry', {
          get: () => {
            if (!isKnown) most = Math.max(most, ++begun - done);
            isKnown = true;
            return attributes !== undefined;
          },
        });
        return [geometry, { layout: 'indexed' as const }];
      }),
    );
    await bakeGeometries(layouts, {}, { onBaked: () => done++ });
    return most;
  };
  /** All triangles but two are degenerate, so that a bake is fast. */
  const plane = (corners: number) => () => {
    const index = new Uint32Array(corners);
    index.set([0, 2, 1, 2, 3, 1]);
    return new PlaneGeometry().setIndex(new BufferAttribute(index, 1));
  };
  expect(await mostAtOnce(3, plane(6))).toBe(1);
  expect(await mostAtOnce(3, plane(300_000))).toBe(2);
  expect(await mostAtOnce(5, plane(900_000))).toBe(4);
  expect(await mostAtOnce(3, plane(2_499_999))).toBe(2);
});
