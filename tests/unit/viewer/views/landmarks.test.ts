import { expect, test } from 'vitest';
import { landmarksOf } from '../../../../src/viewer/views/landmarks.js';

/** One vertex for each name, at x = its number. */
const marks = (...names: string[]) =>
  landmarksOf(Float32Array.from(names.flatMap((_, i) => [i, 0, -i])), {
    names,
    ofVertices: Uint32Array.from(names.keys()),
  }).map(({ x, sign }) => [names[x], sign]);

test('names of the front and the back are found as words, in whatever way these are joined', () => {
  const front = ['Headlights_Chrome', 'RL_L_Eye.002', 'frontGlass', 'WINDSHIELD-2', 'Nase', 'Œil yeux'];
  const back = ['backBus_Plane.005', 'car tail', 'Rear_seats', 'Arrière'];
  expect(marks(...front, ...back)).toEqual([...front.map((name) => [name, 1]), ...back.map((name) => [name, -1])]);
});

test('parts of words, and names that say both, say nothing', () => {
  expect(marks('surface', 'backpack', 'nosebleed', 'tailor', 'front and back', '', 'wheel_1')).toEqual([]);
});

test('a landmark lies in the middle of its vertices', () => {
  const positions = Float32Array.from([0, 9, 2, 4, 9, 6, 100, 9, 100]);
  const parts = { names: ['eyes', 'body'], ofVertices: Uint32Array.from([0, 0, 1]) };
  expect(landmarksOf(positions, parts)).toEqual([{ x: 2, z: 4, sign: 1 }]);
  expect(
    landmarksOf(positions, { ...parts, names: ['body', 'eyes'], ofVertices: Uint32Array.from([0, 0, 0]) }),
  ).toEqual([]);
});
