import { BoxGeometry, Group, InstancedMesh, Mesh } from 'three';
import { expect, test, vi } from 'vitest';
import { OcclusionLoader } from '../../../../src/demo/playground/OcclusionLoader.js';

/** How many bakes are begun for a model of these meshes, however often the settings change. */
function bakesOf(...meshes: Mesh[]): number {
  const run = vi.fn();
  const scene = { model: { root: new Group().add(...meshes) }, frameMilliseconds: undefined as number | undefined };
  const loader = new OcclusionLoader(scene as never, { occlusion: 50 } as never, { run, stop: vi.fn() } as never);
  loader.update();
  expect(run, 'before the model was drawn').not.toHaveBeenCalled();
  scene.frameMilliseconds = 20;
  loader.update();
  loader.update();
  return run.mock.calls.length;
}

const box = new BoxGeometry();

test('occlusion is baked once, and not for models of instances alone, which have no place to keep it', () => {
  expect(bakesOf(new Mesh(box))).toBe(1);
  expect(bakesOf(new InstancedMesh(box, undefined, 2), new Mesh(box))).toBe(1);
  expect(bakesOf(new InstancedMesh(box, undefined, 2))).toBe(0);
});
