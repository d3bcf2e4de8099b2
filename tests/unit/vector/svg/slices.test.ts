import { TorusGeometry } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { Bvh } from '../../../../src/vector/Bvh.js';
import { TriangleSplitter } from '../../../../src/vector/buildBvh.js';
import { drawLines } from '../../../../src/vector/drawLines.js';
import { planOf } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { readScene } from '../../../../src/vector/svg/readScene.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

/** Counts array reads in place of time. */
class Counter {
  most = 0;
  private since = 0;

  /** A proxy of an array that counts reads. */
  counted<Numbers extends object>(numbers: Numbers): Numbers {
    const note = () => {
      this.since++;
    };
    return new Proxy(numbers, {
      get(target, name) {
        note();
        const value = Reflect.get(target, name, target);
        return typeof value === 'function' ? value.bind(target) : value;
      },
    });
  }

  /** Runs a generator to its end, and returns its progress and result. */
  run<Result>(task: Generator<number, Result, void>): { progress: number[]; result: Result } {
    const progress: number[] = [];
    for (;;) {
      this.since = 0;
      const step = task.next();
      this.most = Math.max(this.most, this.since);
      if (step.done) return { progress, result: step.value };
      progress.push(step.value);
    }
  }
}

const SIZES = [
  [24, 48],
  [96, 192],
] as const;
const scenes: ReturnType<typeof sceneOf>[] = [];
const camera = cameraAt(0.4, 1, 2.8);

beforeAll(async () => {
  for (const [tubular, radial] of SIZES) {
    const mesh = await hatchedMesh(new TorusGeometry(0.7, 0.3, tubular, radial), { material: { direction: 'light' } });
    scenes.push(sceneOf(mesh));
  }
});

describe('a drawing goes on in small steps', () => {
  test.each(['print', 'pen'] as const)(
    'no step reads more of a scene of sixteen times as many triangles: %s',
    (kind) => {
      const counts = scenes.map((scene) => {
        const counter = new Counter();
        const { drawn } = counter.run(readScene(scene, camera, false)).result;
        const [{ surface }] = drawn.surfaces;
        surface.vertices = counter.counted(surface.vertices);
        surface.triangles = counter.counted(surface.triangles);
        const [{ mesh }] = drawn.outlines;
        mesh.positions = counter.counted(mesh.positions);
        mesh.triangles = counter.counted(mesh.triangles);
        counter.run(drawLines(drawn, planOf({ kind, sheet: [60, 60] })));
        return counter.most;
      });
      expect(counts[1]).toBeLessThan(200_000);
      expect(counts[1]).toBeLessThan(3 * counts[0]);
    },
  );

  test('boxes are built over so many triangles at a time', () => {
    const count = 100_000;
    const corners = Float64Array.from({ length: 9 * count }, (_, i) => Math.sin(i * i));
    const steps: number[] = [];
    const task = Bvh.build(corners, new Uint8Array(count).fill(1));
    for (let step = task.next(); !step.done; step = task.next()) steps.push(step.value);
    // Each level visits every triangle three times, at most 16,384 per step.
    expect(steps.length).toBeGreaterThan((3 * count * Math.log2(count / 16_384)) / 16_384);
    expect([...steps].sort((a, b) => a - b)).toEqual(steps);
    const splitter = new TriangleSplitter(100);
    splitter.readBoxes(corners, 0, 100);
    splitter.begin(0, 100);
    expect([splitter.measure(60), splitter.measure(60)]).toEqual([true, false]);
    expect([splitter.fillBins(60), splitter.fillBins(60)]).toEqual([true, false]);
    splitter.chooseBorder();
    expect([splitter.part(60), splitter.part(60)]).toEqual([true, false]);
  });

  test('its progress rises without a leap, and passes through the middle', () => {
    const counter = new Counter();
    const { drawn } = counter.run(readScene(scenes[1], camera, false)).result;
    const { progress } = counter.run(drawLines(drawn, planOf({ sheet: [60, 60] })));
    let highest = 0;
    for (const value of progress) {
      expect(value).toBeGreaterThan(highest - 0.03);
      expect(value).toBeLessThan(highest + 0.12);
      highest = Math.max(highest, value);
    }
    expect(highest).toBeGreaterThan(0.9);
    expect(highest).toBeLessThanOrEqual(1);
    expect(progress.filter((value) => value > 0.4 && value < 0.6).length).toBeGreaterThan(20);
  });

  test('it ends at once where it is aborted: with the next report of its progress', async () => {
    const controller = new AbortController();
    const shown: number[] = [];
    const drawing = drawSVG(scenes[1], camera, {
      sheet: [60, 60],
      signal: controller.signal,
      onProgress: (progress) => {
        shown.push(progress);
        if (progress > 0.3) controller.abort(new Error('enough'));
      },
    });
    await expect(drawing).rejects.toThrow('enough');
    expect(shown.filter((progress) => progress > 0.3).length).toBe(1);
    expect(shown.at(-1)).toBeLessThan(0.9);
  });
});
