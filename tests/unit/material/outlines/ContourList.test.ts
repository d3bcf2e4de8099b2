import { Sphere, Vector3, Vector4 } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { OutlineData } from '../../../../src/material/geometry/OutlineData.js';
import { ContourList } from '../../../../src/material/outlines/ContourList.js';
import { bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { findCandidates } from '../../../../src/mesh/features/contourCandidates.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { disposeHatchingWorkers } from '../../../../src/worker/runTask.js';
import { finish } from '../../mesh/meshes.js';
import { torus } from '../../mesh/shapes.js';
import { eventually } from '../../patience.js';
import { FakeWorker } from '../../worker/FakeWorker.js';

afterEach(() => disposeHatchingWorkers());

const packedOf = (mesh: TriangleMesh) =>
  finish(
    bakeCorners({
      label: 'test',
      mesh,
      creaseAngle: Math.PI / 2,
      wantsNormals: false,
      attributes: [],
      outlines: { triangleGroups: null },
    }),
  ).outlines!;

const packed = packedOf(torus(40, 20));
const otherPacked = packedOf(torus(30, 16));

const SINE = Math.sin((0.75 * Math.PI) / 180);
const DISTANCE = 3;
const eye = new Vector4(0, 0, 4.4, 1);
/** At the same distance from that eye. */
const BOUNDS = new Sphere(new Vector3(), eye.z - DISTANCE);

const listOf = ({ texture, count }: ContourList): number[] => [
  ...(texture!.image.data as Uint32Array).subarray(0, count),
];

const expected = (at: Vector4, sine = SINE, outlines = packed): number[] => {
  const search = new OutlineData(outlines).search!;
  const count = findCandidates(search, [at.x, at.y, at.z, at.w], sine);
  return [...search.list.subarray(0, count)];
};

describe('a small mesh is searched at once', () => {
  test('and again only when the eye has moved too far', () => {
    const [list, data] = [new ContourList(), new OutlineData(packed)];
    expect(list.update(data, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye));
    expect(list.count).toBeGreaterThan(10);
    expect(list.count).toBeLessThan(packed.triangleCount / 2);
    const version = list.texture!.version;
    const moved = (share: number) => eye.clone().add(new Vector4(share * SINE * DISTANCE, 0, 0, 0));
    // The distance at which the list was made counts.
    expect(list.update(data, moved(0.99), new Sphere(new Vector3(), 0.1))).toBe(true);
    expect(list.texture!.version).toBe(version);
    expect(list.update(data, moved(1.01), BOUNDS)).toBe(true);
    expect(list.texture!.version).toBe(version + 1);
    expect(listOf(list)).toEqual(expected(moved(1.01)));
    expect(list.update(data, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye));
  });

  test('but not from inside its bounding sphere', () => {
    const [list, data] = [new ContourList(), new OutlineData(packed)];
    for (const radius of [eye.z, eye.z + 1, Number.NaN])
      expect(list.update(data, eye, new Sphere(new Vector3(), radius))).toBe(false);
    expect(list.texture).toBeNull();
  });

  test('by direction alone with an orthographic camera, wherever it is', () => {
    const [list, data] = [new ContourList(), new OutlineData(packed)];
    const turned = (angle: number) => new Vector4(Math.sin(angle), 0, Math.cos(angle), 0);
    expect(list.update(data, turned(0), BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(turned(0)));
    const version = list.texture!.version;
    list.update(data, turned(0.99 * SINE), BOUNDS);
    expect(list.texture!.version).toBe(version);
    list.update(data, turned(1.02 * SINE), BOUNDS);
    expect(list.texture!.version).toBe(version + 1);
    // Another kind of camera at the same position.
    list.update(
      data,
      new Vector4(
        ...turned(1.02 * SINE)
          .toArray()
          .slice(0, 3),
        1,
      ),
      new Sphere(new Vector3(), 0.9),
    );
    expect(list.texture!.version).toBe(version + 2);
  });

  test('and again for another geometry, wherever the eye is', () => {
    const [list, data, other] = [new ContourList(), new OutlineData(packed), new OutlineData(otherPacked)];
    list.update(data, eye, BOUNDS);
    expect(list.update(other, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye, SINE, otherPacked));
    expect(listOf(list)).not.toEqual(expected(eye));
    expect(list.update(data, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye));
  });

  test('into a texture that grows and is then kept', () => {
    const [list, data] = [new ContourList(), new OutlineData(packed)];
    const side = new Vector4(4.4, 0, 0, 1);
    const [few, many] = [eye, side].sort((a, b) => expected(a).length - expected(b).length);
    list.update(data, many, BOUNDS);
    const { texture } = list;
    list.update(data, few, BOUNDS);
    expect(list.texture).toBe(texture);
    const freed = vi.fn();
    texture!.addEventListener('dispose', freed);
    list.dispose();
    expect(freed).toHaveBeenCalledOnce();
    expect(list.texture).toBeNull();
  });
});

describe('a large mesh is searched in the worker', () => {
  /** The same data, marked as large. */
  function largeData(outlines = packed) {
    const worker = new FakeWorker();
    const data = new OutlineData(outlines);
    Object.defineProperty(data, 'isSearchedInWorker', { value: true });
    const createWorker = vi.fn(() => FakeWorker.asWorker(worker));
    data.createWorker = createWorker;
    const start = async () => {
      await eventually(() => expect(createWorker).toHaveBeenCalled());
      worker.say({ type: 'ready' });
    };
    const answer = () => {
      const { id, request } = worker.received.at(-1) as unknown as {
        id: number;
        request: { search: NonNullable<OutlineData['search']>; eye: [number, number, number, number]; sine: number };
      };
      const count = findCandidates(request.search, request.eye, request.sine);
      worker.say({ type: 'done', id, result: { search: request.search, count } });
    };
    return { worker, data: data as OutlineData, answer, start };
  }

  /** A search transfers its arrays, so they must not be shared. */
  const own = (data: OutlineData) => {
    const search = data.search!;
    data.search = {
      ...search,
      positions: search.positions.slice(),
      normals: search.normals.slice(),
      primitives: search.primitives.slice(),
    };
  };

  const settled = () => new Promise((resolve) => setImmediate(resolve));
  const WIDE = Math.sin((3 * Math.PI) / 180);

  test('and everything is tested until the list comes', async () => {
    const { worker, data, answer, start } = largeData();
    own(data);
    const list = new ContourList();
    expect(list.update(data, eye, BOUNDS)).toBe(false);
    expect(data.search).toBeNull();
    await start();
    await settled();
    expect(list.update(data, eye, BOUNDS)).toBe(false);
    // Neither this nor another camera requests a search while the arrays are away.
    expect(new ContourList().update(data, eye, BOUNDS)).toBe(false);
    expect(worker.ids).toHaveLength(1);
    answer();
    await settled();
    expect(data.search).not.toBeNull();
    expect(list.update(data, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye, WIDE));
    expect(worker.ids).toHaveLength(1);
  });

  test('and a new list is requested at half the reach of the old one', async () => {
    const { worker, data, answer, start } = largeData();
    own(data);
    const list = new ContourList();
    list.update(data, eye, BOUNDS);
    await start();
    await settled();
    answer();
    await settled();
    const moved = (share: number) => eye.clone().add(new Vector4(0, share * WIDE * DISTANCE, 0, 0));
    expect(list.update(data, moved(0.49), BOUNDS)).toBe(true);
    expect(worker.ids).toHaveLength(1);
    // The renderer reuses its vector.
    const reused = moved(0.6);
    expect(list.update(data, reused, BOUNDS)).toBe(true);
    await settled();
    expect(worker.ids).toHaveLength(2);
    expect(list.update(data, reused.copy(moved(1.01)), BOUNDS)).toBe(false);
    answer();
    await settled();
    // The list is for the eye position of the request.
    expect(listOf(list)).toEqual(expected(moved(0.6), WIDE));
    expect(list.update(data, moved(1.01), BOUNDS)).toBe(true);
    expect(list.update(data, moved(-0.3), BOUNDS)).toBe(true);
    expect(list.update(data, moved(-0.5), BOUNDS)).toBe(false);
  });

  test('and if the worker fails, everything is tested and the search is repeated, but not for ever', async () => {
    const { worker, data, start } = largeData();
    own(data);
    const list = new ContourList();
    list.update(data, eye, BOUNDS);
    await start();
    await settled();
    for (let i = 0; i < 6; i++) {
      if (worker.ids[i] === undefined) break;
      worker.say({ type: 'failed', id: worker.ids[i], error: { name: 'Error', message: 'out of memory' } });
      await settled();
      expect(list.update(data, eye, BOUNDS)).toBe(false);
      await settled();
    }
    expect(worker.ids).toHaveLength(4);
    expect(data.search).toBeNull();
  });

  test('and a late list for the former geometry is ignored', async () => {
    const [first, second] = [largeData(), largeData(otherPacked)];
    own(first.data);
    own(second.data);
    const list = new ContourList();
    list.update(first.data, eye, BOUNDS);
    await first.start();
    await settled();
    expect(list.update(second.data, eye, BOUNDS)).toBe(false);
    first.answer();
    await settled();
    expect(first.data.search).not.toBeNull();
    expect(list.texture).toBeNull();
    expect(list.update(second.data, eye, BOUNDS)).toBe(false);
    await second.start();
    await settled();
    second.answer();
    await settled();
    expect(list.update(second.data, eye, BOUNDS)).toBe(true);
    expect(listOf(list)).toEqual(expected(eye, WIDE, otherPacked));
  });

  test('and a list that arrives after disposal makes no texture', async () => {
    const { data, answer, start } = largeData();
    own(data);
    const list = new ContourList();
    list.update(data, eye, BOUNDS);
    await start();
    await settled();
    list.dispose();
    answer();
    await settled();
    expect(list.texture).toBeNull();
    expect(data.search).not.toBeNull();
  });
});
