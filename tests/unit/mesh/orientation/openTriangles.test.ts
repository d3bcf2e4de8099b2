import { expect, test } from 'vitest';
import { openTriangles } from '../../../../src/mesh/orientation/openTriangles.js';
import { runToEnd } from '../../../../src/mesh/phases.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../tools/modelFiles/box.js';

type Faces = readonly (readonly number[])[];

const WITHOUT_LID = BOX_FACES.slice(1);
const turned = (faces: Faces): Faces => faces.map((face) => face.toReversed());

/** How many triangles of boxes of four-cornered faces are open, box by box. Faces share no vertices, only positions. */
function openOf(...boxes: { faces: Faces; at?: number }[]): number[] {
  const corners = boxes.flatMap(({ faces, at = 0 }) =>
    faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d].map((corner) => BOX_CORNERS[corner].map((value) => value + at))),
  );
  const positions = new Float32Array(corners.flat());
  const indices = Uint32Array.from(corners, (_, i) => i);
  const open = runToEnd(openTriangles({ positions, indices }));
  let first = 0;
  return boxes.map(({ faces }) => {
    first += 2 * faces.length;
    return open.subarray(first - 2 * faces.length, first).reduce((sum, one) => sum + one, 0);
  });
}

test('a box is closed, and is open without a lid or turned inside out', () => {
  expect(openOf({ faces: BOX_FACES })).toEqual([0]);
  expect(openOf({ faces: WITHOUT_LID })).toEqual([10]);
  expect(openOf({ faces: turned(BOX_FACES) })).toEqual([12]);
});

test('a sheet with two sides is closed', () => {
  const [, sheet] = BOX_FACES;
  expect(openOf({ faces: [sheet] }, { faces: turned([sheet]) })).toEqual([0, 0]);
});

test('each body counts by itself, also far from the origin', () => {
  expect(openOf({ faces: BOX_FACES, at: 2000 }, { faces: WITHOUT_LID }, { faces: turned(BOX_FACES), at: 9 })).toEqual([
    0, 10, 12,
  ]);
});
