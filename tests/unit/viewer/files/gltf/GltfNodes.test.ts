import { expect, test } from 'vitest';
import { GltfNodes } from '../../../../../src/viewer/files/gltf/GltfNodes.js';

/** Writes a node with a mesh of so many triangles. */
async function write(triangles: number): Promise<GltfNodes> {
  const mesh = { json: { primitives: [{}] }, vertices: 3, triangles, shapes: 0, isSkinned: false };
  const geometry = { writeMesh: async () => mesh };
  const nodes = new GltfNodes({ meshes: [{}] } as never, {} as never, geometry as never, [], {} as never);
  await nodes.write({ mesh: 0 }, true);
  return nodes;
}

test('more triangles can be read than are drawn, since they are simplified, but no more than memory allows', async () => {
  expect((await write(10_000_000)).sums.triangles).toBe(10_000_000);
  await expect(write(22_000_000)).rejects.toThrow(/^The model has more than 21,000,000 triangles/);
});
