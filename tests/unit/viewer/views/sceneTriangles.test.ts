import { BufferAttribute, BufferGeometry, Group, Mesh } from 'three';
import { expect, test } from 'vitest';
import { partsOfMesh } from '../../../../src/viewer/drawing/ModelParts.js';
import type { PlainMesh } from '../../../../src/viewer/files/mesh/PlainMesh.js';
import { sceneTriangles } from '../../../../src/viewer/views/sceneTriangles.js';
import { viewSurface } from '../../../../src/viewer/views/viewSurface.js';

/** A square body, a small triangle before it, and one behind it. */
const MESH: PlainMesh = {
  positions: Float32Array.from(
    [
      [-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 1, 0],
      [0, 0.4, 1, 0.3, 0.4, 1, 0, 0.7, 1],
      [0, 0.4, -0.8, 0.3, 0.4, -0.8, 0, 0.7, -0.8],
    ].flat(),
  ),
  normals: null,
  colors: null,
  indices: Uint32Array.from([0, 1, 2, 0, 2, 3, 4, 5, 6, 7, 8, 9]),
  parts: {
    names: ['body', 'eyes', 'tail'],
    ofVertices: Uint32Array.from([0, 0, 0, 0, 1, 1, 1, 2, 2, 2]),
  },
};

/** The mesh as a model draws it: moved, made smaller, and its parts joined. */
function joined(hidden: readonly number[]) {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(MESH.positions, 3));
  geometry.setIndex(new BufferAttribute(MESH.indices!, 1));
  const root = new Group().add(new Mesh(geometry));
  root.position.set(3, 2, 1);
  root.scale.setScalar(0.5);
  new Group().add(root).scale.setScalar(2);
  root.parent!.updateMatrixWorld();
  return sceneTriangles(root, partsOfMesh(MESH, hidden, root));
}

const landmarks = (triangles: Parameters<typeof viewSurface>[0]) =>
  viewSurface(triangles, 'y').landmarks.map(({ x, z, sign }) => ({ x: x.toFixed(5), z: z.toFixed(5), sign }));

test('the names of parts that were joined to one mesh tell front and back as in the file', () => {
  const inFile = landmarks({ ...MESH, isSingleSided: null });
  expect(inFile.map(({ sign }) => sign)).toEqual([1, -1]);
  expect(landmarks(joined([]))).toEqual(inFile);
  expect(landmarks(joined([1]))).toEqual([inFile[1]]);
});
