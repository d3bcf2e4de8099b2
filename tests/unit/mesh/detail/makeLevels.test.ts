import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import { PlaneGeometry, SphereGeometry } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { beforeAll, expect, test } from 'vitest';
import { type DetailLevels, makeLevels } from '../../../../src/mesh/detail/makeLevels.js';
import { type SimplifiableMesh, simplifyTriangles } from '../../../../src/mesh/detail/simplifyTriangles.js';
import { finish } from '../meshes.js';

beforeAll(() => MeshoptSimplifier.ready);

/** A sphere of radius 1 with its normals, whose strokes count as they do in a hatched scene. */
function sphere(columns: number): { mesh: SimplifiableMesh; indices: Uint32Array<ArrayBuffer> } {
  const geometry = new SphereGeometry(1, columns, columns / 2).deleteAttribute('uv').deleteAttribute('normal');
  const joined = mergeVertices(geometry, 1e-5);
  const positions = new Float32Array(joined.attributes.position.array);
  return {
    mesh: { positions, attributes: positions, weights: [0.02, 0.02, 0.02] },
    indices: new Uint32Array(joined.index!.array),
  };
}

const levelsOf = (columns: number): DetailLevels => {
  const { mesh, indices } = sphere(columns);
  return finish(makeLevels(mesh, indices, 1, MeshoptSimplifier));
};

/** How deep the triangles of a range lie inside the unit sphere, at their corners, edges and centres. */
function depthBelowSphere(positions: Float32Array, indices: Uint32Array): number {
  let deepest = 0;
  const at = (corner: number, axis: number): number => positions[3 * indices[corner] + axis];
  for (let i = 0; i < indices.length; i += 3) {
    for (const [u, v] of [
      [1 / 3, 1 / 3],
      [0.5, 0],
      [0, 0.5],
      [0.5, 0.5],
    ]) {
      const place = [0, 1, 2].map((axis) => (1 - u - v) * at(i, axis) + u * at(i + 1, axis) + v * at(i + 2, axis));
      deepest = Math.max(deepest, 1 - Math.hypot(...place));
    }
  }
  return deepest;
}

test('every level of a sphere lies as near to it as the level says, and has at most 70 % of the triangles before', () => {
  const { mesh, indices } = sphere(256);
  const { indices: all, levels } = finish(makeLevels(mesh, indices, 1, MeshoptSimplifier));
  expect(levels.length).toBeGreaterThan(4);
  expect(levels[0]).toEqual({ start: 0, count: indices.length, error: 0 });
  expect(all.subarray(0, indices.length)).toEqual(indices);
  const own = depthBelowSphere(mesh.positions, indices);
  for (const [i, { start, count, error }] of levels.entries()) {
    if (i > 0) expect(count).toBeLessThanOrEqual(0.7 * levels[i - 1].count);
    expect(depthBelowSphere(mesh.positions, all.subarray(start, start + count))).toBeLessThanOrEqual(own + error);
  }
  // The levels are no mere copies: the last one is coarse, and says so.
  const last = levels.at(-1)!;
  expect(depthBelowSphere(mesh.positions, all.subarray(last.start, last.start + last.count))).toBeGreaterThan(
    0.2 * last.error,
  );
});

test('levels stand one after another, with growing errors, and each uses vertices of the level before it alone', () => {
  const { indices, levels } = levelsOf(128);
  let before = new Set(indices);
  let end = 0;
  for (const [i, { start, count, error }] of levels.entries()) {
    expect(start).toBe(end);
    expect(count % 3).toBe(0);
    end += count;
    if (i > 0) expect(error).toBeGreaterThan(levels[i - 1].error);
    const own = new Set(indices.subarray(start, end));
    expect([...own].every((vertex) => before.has(vertex))).toBe(true);
    before = own;
  }
  expect(end).toBe(indices.length);
});

test('cells give a closed surface within the error, and a shifted grid simplifies their borders', {
  tags: ['all'],
}, () => {
  const { mesh, indices } = sphere(512);
  const own = depthBelowSphere(mesh.positions, indices);
  const cells = finish(simplifyTriangles(mesh, indices, 0.0005, MeshoptSimplifier));
  expect(cells.error).toBeLessThanOrEqual(0.0005);
  expect(cells.indices.length).toBeLessThan(0.3 * indices.length);
  expect(borderEdges(cells.indices)).toBe(0);
  expect(depthBelowSphere(mesh.positions, cells.indices)).toBeLessThan(own + cells.error);
  const again = finish(simplifyTriangles(mesh, cells.indices, 0.0005, MeshoptSimplifier, 0.5));
  expect(again.indices.length).toBeLessThan(0.9 * cells.indices.length);
  expect(borderEdges(again.indices)).toBe(0);
});

test('a flat sheet keeps its border and loses what lies within', () => {
  const plane = new PlaneGeometry(2, 2, 60, 60);
  const positions = new Float32Array(plane.attributes.position.array);
  const attributes = new Float32Array(plane.attributes.normal.array);
  const mesh = { positions, attributes, weights: [0.02, 0.02, 0.02] };
  const made = finish(simplifyTriangles(mesh, new Uint32Array(plane.index!.array), 0.02, MeshoptSimplifier));
  expect(made.indices.length / 3).toBeLessThan(100);
  let area = 0;
  for (let i = 0; i < made.indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [0, 1].map((axis) => positions[3 * made.indices[i + k] + axis]));
    area += ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  }
  expect(area).toBeCloseTo(4, 3);
});

test('turning strokes keep triangles on flat shapes', () => {
  const plane = new PlaneGeometry(2, 2, 60, 60);
  const positions = new Float32Array(plane.attributes.position.array);
  const turning = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) turning[i] = Math.sin(3 * positions[i]);
  const indices = new Uint32Array(plane.index!.array);
  const trianglesWith = (weight: number): number =>
    finish(
      simplifyTriangles({ positions, attributes: turning, weights: [weight, 0, 0] }, indices, 0.02, MeshoptSimplifier),
    ).indices.length / 3;
  expect(trianglesWith(1)).toBeGreaterThan(2 * trianglesWith(0));
});

/** Edges that one triangle alone has. */
function borderEdges(indices: Uint32Array): number {
  const seen = new Map<string, number>();
  for (let i = 0; i < indices.length; i++) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    const key = [indices[i], indices[next]].sort((a, b) => a - b).join();
    seen.set(key, (seen.get(key) ?? 0) + 1);
  }
  return [...seen.values()].filter((count) => count === 1).length;
}
