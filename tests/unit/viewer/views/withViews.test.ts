import { BoxGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { type FileCamera, NO_EXTRAS } from '../../../../src/viewer/files/common/ModelExtras.js';
import type { PlainMesh } from '../../../../src/viewer/files/mesh/PlainMesh.js';
import type { ReadMesh } from '../../../../src/viewer/files/readModel.js';
import { withViews } from '../../../../src/viewer/views/withViews.js';

/** Walls, floor and ceiling that face inward. */
function room(): PlainMesh {
  const { attributes, index } = new BoxGeometry(2, 1, 2).scale(-1, 1, 1);
  return {
    positions: Float32Array.from(attributes.position.array),
    normals: null,
    colors: null,
    indices: Uint32Array.from(index!.array),
  };
}

const firstElevation = (mesh: PlainMesh): number => {
  const read = withViews({ kind: 'mesh', mesh, upAxis: 'y' } as ReadMesh, 'y', () => {}) as ReadMesh;
  return read.views![0].elevation;
};

describe('a room is seen from above through what is not drawn', () => {
  test('where all of its surfaces are one-sided', () => {
    expect(firstElevation({ ...room(), isOneSided: true })).toBeGreaterThanOrEqual(30);
  });

  test('where ranges of it are', () => {
    const ranges = [0, 18].map((start) => ({ start, count: 18, picture: -1, isOneSided: true }));
    expect(firstElevation({ ...room(), ranges })).toBeGreaterThanOrEqual(30);
  });
});

test('cameras that see nothing are left out, and that is said', () => {
  const camera: FileCamera = {
    name: 'inside',
    position: [0, 0, 0],
    forwards: [0, 0, -1],
    up: [0, 1, 0],
    high: 0.5,
    isOrthographic: false,
    aspect: undefined,
  };
  const above: FileCamera = { ...camera, name: 'above', position: [0, 3, 0] };
  const extras = { ...NO_EXTRAS, cameras: [above, camera], variants: ['red'] };
  const given = { kind: 'mesh', mesh: room(), upAxis: 'y', extras, details: ['first'] } as unknown as ReadMesh;
  const stages: string[] = [];
  const read = withViews(given, 'y', (stage) => void stages.push(stage));
  expect(read.extras).toEqual({ ...extras, cameras: [camera] });
  expect(read.details).toEqual(['first', '1 camera left out, from which nothing of the model is seen']);
  expect(stages[0]).toBe('looking for a view');
});

test('a model in parts has no views yet', () => {
  const parts = { kind: 'parts' } as never;
  expect(withViews(parts, 'y', () => {})).toBe(parts);
});
