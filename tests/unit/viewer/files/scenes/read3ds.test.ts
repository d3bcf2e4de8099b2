import { expect, test } from 'vitest';
import { BOX_CORNERS, BOX_FACES } from '../../../../../tools/modelFiles/box.js';
import { colorsOf, measure, read, triangles } from '../../../../../tools/modelFiles/modelWriters.js';
import { chunk, shorts, text } from '../../../../../tools/modelFiles/sceneWriters.js';

const longs = (...values: number[]): Uint8Array => new Uint8Array(Uint32Array.from(values).buffer);
const floats = (...values: number[]): Uint8Array => new Uint8Array(Float32Array.from(values).buffer);
const colour = (id: number, ...rgb: number[]): Uint8Array => chunk(id, chunk(0x0011, rgb));
const material = (name: string, ...parts: Uint8Array[]): Uint8Array =>
  chunk(0xafff, chunk(0xa000, text(name)), ...parts);
const FACES = BOX_FACES.flatMap(([a, b, c, d]) => [
  [a, b, c],
  [a, c, d],
]);

/** An object that is a box. @param groups parts of its faces @param parts of its mesh @param hidden of the object */
function box({
  groups = [],
  parts = [],
  hidden = [],
  points = BOX_CORNERS,
}: Partial<Record<'groups' | 'parts' | 'hidden', Uint8Array[]>> & { points?: number[][] } = {}): Uint8Array {
  const faces = chunk(0x4120, shorts(FACES.length, ...FACES.flatMap((face) => [...face, 7])), ...groups);
  const places = chunk(0x4110, shorts(points.length), floats(...points.flat()));
  return chunk(0x4000, text('box'), ...hidden, chunk(0x4100, places, ...parts, faces));
}

const tds = (...parts: Uint8Array[]): [string, Uint8Array] => [
  'box.3ds',
  chunk(0x4d4d, chunk(0x0002, [3, 0, 0, 0]), chunk(0x3d3d, ...parts)),
];
const VOLUME = (2 / Math.sqrt(3)) ** 3;

test('faces have their own materials, in any order, and those without one are drawn', async () => {
  const red = material('red', colour(0xa020, 255, 0, 0), colour(0xa010, 9, 9, 9));
  const named = chunk(0x4130, text('red'), shorts(3, 1, 5, 11));
  const unknown = chunk(0x4130, text('lost'), shorts(1, 0));
  const model = await read(tds(red, box({ groups: [unknown, named] })));
  expect(triangles(model)).toBe(12);
  expect(measure(model).volume).toBeCloseTo(VOLUME, 4);
  const colours = colorsOf(model);
  expect([colours.filter((one) => one === '255,0,0').length, new Set(colours)]).toEqual([
    3,
    new Set(['255,0,0', '255,255,255']),
  ]);
  const { positions, indices } = model.mesh;
  // The faces 1 and 5 to the sides of x and y, and 11 at the end of z.
  const isRed = (triangle: number): boolean => colours[triangle] === '255,0,0';
  const sides = [...Array(12).keys()].filter(isRed).map((triangle) => {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices![3 * triangle + k]));
    return [0, 1, 2].find((axis) => a[axis] === b[axis] && b[axis] === c[axis]);
  });
  expect(sides).toEqual([0, 1, 2]);
});

test('edges are smooth within a smoothing group, and sharp between groups and without one', async () => {
  const smoothing = (...groups: number[]): Uint8Array[] => [chunk(0x4150, longs(...groups))];
  const normals = async (groups: Uint8Array[]): Promise<Set<string>> => {
    const { mesh } = await read(tds(box({ groups })));
    return new Set(
      Array.from({ length: mesh.normals!.length / 3 }, (_, i) => {
        const normal = [...mesh.normals!.subarray(3 * i, 3 * i + 3)].map(Math.abs);
        return normal
          .map((value) => value.toFixed(2))
          .sort()
          .join();
      }),
    );
  };
  expect(await normals(smoothing(...Array(12).fill(1)))).toEqual(new Set(['0.58,0.58,0.58']));
  expect(await normals(smoothing(...Array(12).fill(0)))).toEqual(new Set(['0.00,0.00,1.00']));
  // The sides of x and y share a bit, and the ends have one of their own.
  expect(await normals(smoothing(...Array(4).fill(3), ...Array(4).fill(6), ...Array(4).fill(8)))).toEqual(
    new Set(['0.00,0.71,0.71', '0.00,0.00,1.00']),
  );
  expect((await read(tds(box()))).mesh.normals).toBe(null);
});

test.each([
  ['flat', [1, 0, 0, 0, 1, 0, 0, 0, 0, 5, 6, 7]],
  ['askew', [1, 0.5, 0, 0, 1, 0, 0.3, 0, 1, 5, 6, 7]],
])('axes that are %s leave the points where they are', async (_, axes) => {
  const parts = [chunk(0x4160, floats(...axes))];
  expect(measure(await read(tds(box({ parts })))).volume).toBeCloseTo(VOLUME, 4);
});

test('hidden objects are not there', async () => {
  const other = box({ points: BOX_CORNERS.map(([x, y, z]) => [x + 5, y, z]), hidden: [chunk(0x4010)] });
  const model = await read(tds(box(), other));
  expect(triangles(model)).toBe(12);
  expect(measure(model).volume).toBeCloseTo(VOLUME, 4);
});
