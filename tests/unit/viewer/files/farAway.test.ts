import { expect, test } from 'vitest';
import { BOX_CORNERS, BOX_FACES } from '../../../../tools/modelFiles/box.js';
import { asciiStl, type Content, ply, read } from '../../../../tools/modelFiles/modelWriters.js';
import { dae, fbx, threeMf, usda, wrl } from '../../../../tools/modelFiles/sceneWriters.js';

/** Web Mercator, with a fraction that single precision has no room for there. */
const FAR = [1.2e7 + 0.137, 4.5e6 + 0.291, 100.713];

type Corner = readonly number[];
const moved = (far: boolean): Corner[] =>
  BOX_CORNERS.map((corner) => corner.map((value, axis) => 0.25 * value + (far ? FAR[axis] : 0)));
/** The text of a file with the corners of the small box in the place of those of the large one. */
const withCorners = (text: string, far: boolean, write: (corners: readonly Corner[]) => string): string => {
  expect(text).toContain(write(BOX_CORNERS));
  return text.replaceAll(write(BOX_CORNERS), write(moved(far)));
};
const faces = (first: number): string[] => BOX_FACES.map((face) => face.map((corner) => corner + first).join(' '));
const spaced = (corners: readonly Corner[], between: string): string =>
  corners.map((corner) => corner.join(' ')).join(between);

const plyBox = (far: boolean, format: 'ascii' | 'binary_little_endian', type: string, scale = 1): Uint8Array =>
  ply(
    [
      {
        name: 'vertex',
        properties: ['x', 'y', 'z'].map((axis) => `${type} ${axis}`),
        // One that no face uses, as programs leave behind.
        rows: [...moved(far), [0, 0, 0]].map((corner) => corner.map((value) => scale * value)),
      },
      { name: 'face', properties: ['list uchar int vertex_indices'], rows: BOX_FACES.map((face) => [face]) },
    ],
    format,
  );

const files: [name: string, write: (far: boolean) => Content][] = [
  [
    'box.obj',
    (far) =>
      ['v 0 0 0', ...moved(far).map((corner) => `v ${corner.join(' ')}`), ...faces(2).map((f) => `f ${f}`)].join('\n'),
  ],
  [
    'box.stl',
    (far) =>
      BOX_FACES.map((face) =>
        asciiStl(
          '0 0 0',
          face.map((i) => moved(far)[i].join(' ')),
        ),
      ).join('\n'),
  ],
  ['text.ply', (far) => plyBox(far, 'ascii', 'float')],
  ['doubles.ply', (far) => plyBox(far, 'binary_little_endian', 'double')],
  ['integers.ply', (far) => plyBox(far, 'binary_little_endian', 'int', 100)],
  [
    'box.off',
    (far) =>
      ['OFF', '9 6 0', ...moved(far).map((c) => c.join(' ')), '0 0 0', ...faces(0).map((f) => `4 ${f}`)].join('\n'),
  ],
  ['box.dae', (far) => withCorners(dae(), far, (corners) => spaced(corners, ' '))],
  ['box.wrl', (far) => withCorners(wrl(), far, (corners) => spaced(corners, ', '))],
  ['box.usda', (far) => withCorners(usda(), far, (corners) => corners.map((c) => `(${c.join(', ')})`).join(', '))],
  ['box.fbx', (far) => withCorners(fbx(), far, (corners) => corners.flat().join())],
  [
    'box.3mf',
    (far) =>
      threeMf(9, (text) =>
        withCorners(text, far, (corners) =>
          corners.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join(''),
        ),
      ),
  ],
];

test.each(files)('%s at coordinates of a map is drawn as it is at the origin', async (name, write) => {
  const [near, far] = await Promise.all([false, true].map(async (isFar) => (await read([name, write(isFar)])).mesh));
  const triangles = ({ positions, indices }: typeof near): number[][] =>
    Array.from(indices!, (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]);
  const expected = triangles(near);
  expect(triangles(far)).toHaveLength(expected.length);
  // The numbers are written with eight digits after the point at most, and integers in hundredths.
  const allowed = name.startsWith('integers') ? 0.05 : 1e-6;
  for (const [corner, place] of triangles(far).entries())
    for (const [axis, value] of place.entries()) expect(Math.abs(value - expected[corner][axis])).toBeLessThan(allowed);
});
