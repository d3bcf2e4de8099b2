import { BufferAttribute, BufferGeometry, TorusKnotGeometry } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { expect, test } from 'vitest';
import { checkReadTriangles, checkTriangleCount } from '../../../../../src/viewer/files/mesh/PlainMesh.js';

test('three million triangles are let through, and those that a gigabyte cannot hold are not', () => {
  expect(() => checkTriangleCount(3_000_000)).not.toThrow();
  expect(() => checkTriangleCount(6_000_000)).toThrow(
    /^The model has more than 5,200,000 triangles, for which a page has no memory\.$/,
  );
  expect(() => checkReadTriangles(10_000_000)).not.toThrow();
  expect(() => checkReadTriangles(22_000_000)).toThrow(/^The model has more than 21,000,000 triangles/);
  expect(() => checkReadTriangles(0)).toThrow('The file holds no triangles');
  expect(() => checkTriangleCount(0)).toThrow('The file holds no triangles');
});

test('a large mesh takes the bytes per triangle of the limit', async () => {
  const knot = new TorusKnotGeometry(1, 0.3, 200, 50);
  const source = new BufferGeometry().setIndex(knot.index);
  for (const name of ['position', 'normal']) source.setAttribute(name, knot.getAttribute(name));
  source.setAttribute('color', new BufferAttribute(new Float32Array(knot.getAttribute('position').array), 3));
  const baked = await prepareHatchingGeometry(source, { layout: 'pull', outlines: true });
  const { bytes, triangles } = baked.userData.hatching as HatchingStatistics;
  expect(bytes / triangles).toBeLessThan(205 * 1.03);
  expect(bytes / triangles).toBeGreaterThan(205 * 0.97);
});
