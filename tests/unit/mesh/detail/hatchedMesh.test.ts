import { expect, test } from 'vitest';
import { hatchedMesh } from '../../../../src/mesh/detail/simplifyHatched.js';
import { finish } from '../meshes.js';

test('normals, coordinates of maps, colours and lines of the form stand side by side, with weights in object units', () => {
  const made = finish(
    hatchedMesh(
      {
        positions: new Float32Array(6),
        hatchNormals: new Int16Array([32767, 0, -32767, -5, 0, 32767, 0, -9]),
        uvs: new Float32Array([0.25, 0.5, 0.75, 1]),
        colors: new Float32Array([0, 0.5, 1, 1, 1, 0]),
        forms: new Float32Array([7, 8, 9, 10]),
      },
      10,
    ),
  );
  expect([...made.attributes]).toEqual([1, 0, -1, 0.25, 0.5, 0, 0.5, 1, 7, 8, 0, 1, 0, 0.75, 1, 1, 1, 0, 9, 10]);
  expect(made.weights).toEqual([0.2, 0.2, 0.2, 5, 5, 0.5, 0.5, 0.5, 0.625, 0.625]);
});

test('without map, colours and form only normals count', () => {
  const positions = new Float32Array(3);
  const made = finish(
    hatchedMesh({ positions, hatchNormals: new Int16Array(4), uvs: null, colors: null, forms: null }, 1),
  );
  expect(made.weights).toHaveLength(3);
  expect(made.attributes).toHaveLength(3);
  expect(made.positions).toBe(positions);
});
