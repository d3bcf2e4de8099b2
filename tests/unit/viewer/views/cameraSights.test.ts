import { BoxGeometry, type BufferGeometry, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import type { FileCamera } from '../../../../src/viewer/files/common/ModelExtras.js';
import { type CameraSight, cameraSights, sightedCameras } from '../../../../src/viewer/views/cameraSights.js';
import type { ViewTriangles } from '../../../../src/viewer/views/viewSurface.js';

const ofGeometry = ({ attributes, index }: BufferGeometry, isSingleSided = false): ViewTriangles => ({
  positions: attributes.position.array,
  indices: index!.array,
  isSingleSided: isSingleSided ? new Uint8Array(index!.count / 3).fill(1) : null,
});

const AHEAD: FileCamera = {
  name: 'ahead',
  position: [0, 0, 4],
  forwards: [0, 0, -1],
  up: [0, 1, 0],
  high: 0.3,
  isOrthographic: false,
  aspect: 1,
};

const sightOf = (triangles: ViewTriangles, camera: Partial<FileCamera>): CameraSight =>
  cameraSights(triangles, [{ ...AHEAD, ...camera }])[0];

const sphere = ofGeometry(new SphereGeometry(1, 24, 12));

test.each<[string, Partial<FileCamera>, CameraSight]>([
  ['ahead', {}, 'model'],
  ['turned away', { forwards: [0, 0, 1] }, 'nothing'],
  ['past the model', { position: [3, 0, 4] }, 'nothing'],
  ['past the model, with a wider picture', { position: [3, 0, 4], aspect: 4 }, 'model'],
  ['past the model, with a higher picture', { position: [0, 3, 4], high: 1 }, 'model'],
  ['flat, past the model', { position: [2, 0, 4], high: 0.5, isOrthographic: true }, 'nothing'],
  ['flat, at its edge', { position: [1.4, 0, 4], high: 0.5, isOrthographic: true }, 'model'],
  ['rolled, so that it sees past the model', { position: [0, 3, 4], up: [1, 0, 0], high: 0.3, aspect: 1 }, 'nothing'],
  ['rolled, so that it sees the model', { position: [0, 3, 4], up: [1, 0, 0], high: 0.3, aspect: 4 }, 'model'],
])('a camera %s', (_, camera, sight) => {
  expect(sightOf(sphere, camera)).toBe(sight);
});

test('a camera inside a wall sees its backs close by, and one in a room does not', () => {
  const wall = new BoxGeometry(2, 1, 0.1);
  const inside: Partial<FileCamera> = { position: [0, 0, 0], high: 0.5 };
  expect(sightOf(ofGeometry(wall), inside)).toBe('wall');
  // What is beyond the hidden backs would be drawn, but there is nothing.
  expect(sightOf(ofGeometry(wall, true), inside)).toBe('nothing');
  const room = new BoxGeometry(1.2, 1, 1.2);
  expect(sightOf(ofGeometry(room), inside)).toBe('model');
  expect(sightOf(ofGeometry(room.scale(-1, 1, 1), true), inside)).toBe('model');
});

test('cameras that do not see the model are left out, and counted by what they see', () => {
  const cameras = ['a', 'b', 'c', 'd'].map((name) => ({ ...AHEAD, name }));
  const { cameras: kept, details } = sightedCameras(cameras, ['nothing', 'model', 'wall', 'nothing']);
  expect(kept.map(({ name }) => name)).toEqual(['b']);
  expect(details).toEqual([
    '2 cameras left out, from which nothing of the model is seen',
    '1 camera left out, inside a wall',
  ]);
  expect(sightedCameras(cameras, ['model', 'model', 'model', 'model']).details).toEqual([]);
});
