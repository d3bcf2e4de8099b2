import { BoxGeometry, IcosahedronGeometry, PlaneGeometry } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { expect, test } from 'vitest';
import { isClosed } from '../../../../../src/viewer/files/mesh/plainNormals.js';

/** The triangles of a shape, with its vertices joined. */
function trianglesOf(shape: BoxGeometry): Uint32Array {
  shape.deleteAttribute('normal');
  shape.deleteAttribute('uv');
  return new Uint32Array(mergeVertices(shape).index!.array);
}

test.each([
  ['a box', trianglesOf(new BoxGeometry(1, 1, 1, 9, 8, 7))],
  ['a ball', trianglesOf(new IcosahedronGeometry(1, 20) as unknown as BoxGeometry)],
  ['two sides of a sheet', new Uint32Array([0, 1, 2, 2, 1, 0])],
  // Four triangles at an edge, two each way.
  [
    'two tetrahedra with an edge in common',
    new Uint32Array([0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2, 0, 1, 4, 0, 4, 5, 0, 5, 1, 1, 5, 4]),
  ],
])('%s is closed', (_, indices) => {
  expect(isClosed({ indices })).toBe(true);
  const opened = indices.slice(3);
  expect(isClosed({ indices: opened })).toBe(false);
  const turned = indices.slice();
  turned.subarray(0, 3).reverse();
  expect(isClosed({ indices: turned }), 'one triangle turned over').toBe(false);
});

test('a sheet, and triangles that share no vertices, are open', () => {
  expect(isClosed({ indices: trianglesOf(new PlaneGeometry(1, 1, 5, 5) as unknown as BoxGeometry) })).toBe(false);
  expect(isClosed({ indices: null })).toBe(false);
});
