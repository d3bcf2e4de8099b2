import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { plainVrml } from '../../../../../src/viewer/files/scenes/readVrml.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../../tools/modelFiles/box.js';
import { measure, read, refusal, triangles } from '../../../../../tools/modelFiles/modelWriters.js';
import { wrl } from '../../../../../tools/modelFiles/sceneWriters.js';

const HEAD = '#VRML V2.0 utf8\n';
const faces = (points: readonly (readonly number[])[] = BOX_CORNERS, more = ''): string => `Shape {
  geometry IndexedFaceSet {
    coord Coordinate { point [ ${points.map((point) => point.join(' ')).join(', ')} ] } # "points" {
    coordIndex [ ${BOX_FACES.map((face) => `${face.join(' ')} -1`).join(' ')} ] ${more}
  }
}`;
const at = (x: number): string => faces(BOX_CORNERS.map(([a, b, c]) => [a + x, b, c]));
/** A box that is no cube, so that turns show, beside others. */
const OBLONG = BOX_CORNERS.map(([x, y, z]) => [x, 2 * y, 3 * z]);
const vrml = (...nodes: string[]) => read(['a.wrl', HEAD + nodes.join('\n')]);

/** The corners of a mesh, relative to its first box, whose edges along x are one unit long. */
const corners = ({ mesh: { positions } }: Awaited<ReturnType<typeof read>>): string[] => {
  const places = Array.from({ length: positions.length / 3 }, (_, i) => [...positions.subarray(3 * i, 3 * i + 3)]);
  return [...new Set(places.map((place) => place.map((value) => (value + 0).toFixed(3)).join()))].sort();
};

describe('VRML', () => {
  test.each([
    [[1, 2, 3], [0, 0, 1, Math.PI / 3], [1, 1, 1], undefined],
    [[1, -2, 0], [1, 1, 0, 1], [2, 1, 0.5], undefined],
    [
      [0, 0, 0],
      [0, 0, 1, 0],
      [3, 1, 1],
      [0, 0, 1, 0.7],
    ],
    [
      [4, 1e6, 3],
      [0, 1, 0, 2],
      [1, 2, 1],
      [1, 0, 1, -0.4],
    ],
  ])('turns and scales about a centre: %j, %j, %j, %j', async (centre, turn, scale, orientation) => {
    const place = [5, 6, 7];
    const fields = `center ${centre.join(' ')} rotation ${turn.join(' ')} scale ${scale.join(' ')}, translation ${place.join(' ')}${orientation ? ` scaleOrientation ${orientation.join(' ')}` : ''}`;
    const turned = ([x, y, z, angle]: readonly number[]): Matrix4 =>
      new Matrix4().makeRotationFromQuaternion(
        new Quaternion().setFromAxisAngle(new Vector3(x, y, z).normalize(), angle),
      );
    const so = turned(orientation ?? [0, 0, 1, 0]);
    const [cx, cy, cz] = centre;
    // As the standard has it.
    const matrix = new Matrix4()
      .makeTranslation(place[0], place[1], place[2])
      .multiply(new Matrix4().makeTranslation(cx, cy, cz))
      .multiply(turned(turn))
      .multiply(so)
      .multiply(new Matrix4().makeScale(scale[0], scale[1], scale[2]))
      .multiply(so.clone().invert())
      .multiply(new Matrix4().makeTranslation(-cx, -cy, -cz));
    const moved = OBLONG.map((point) => new Vector3().fromArray(point).applyMatrix4(matrix).toArray());
    const group = `DEF Turned Transform { children [ ${faces(OBLONG)} ] ${fields} }`;
    const direct = await vrml(faces(moved));
    expect(corners(await vrml(group))).toEqual(corners(direct));
    // Beside another, which shows where it is.
    expect(corners(await vrml(group, at(9)))).toEqual(corners(await vrml(faces(moved), at(9))));
  });

  test.each([
    [`Switch { whichChoice 1 choice [ ${at(2)} DEF Chosen ${at(4)} ] }`, at(4)],
    [`Switch { choice [ ${at(2)} ] whichChoice 0 }`, at(2)],
    [`Switch { choice [ ${at(2)} ] }`, ''],
    [`Switch { whichChoice 0 choice [ NULL ${at(2)} ] }`, ''],
    [`LOD { range [ 10, 20 ] level [ Group { children [ ${at(2)} ] } ${at(4)} ] }`, at(2)],
    [`LOD { level ${at(2)} }`, at(2)],
    [`Group { children [ LOD { level [ ${at(2)} ] } Billboard { children ${at(4)} } ] }`, `${at(2)} ${at(4)}`],
    [
      `Group { children [ DEF Box ${at(2)} ] } Switch { whichChoice 1 choice [ ${at(6)} USE Box ] }`,
      `${at(2)} ${at(2)}`,
    ],
  ])('of nodes that choose, what is chosen is drawn: %#', async (chosen, drawn) => {
    expect(corners(await vrml(at(0), chosen))).toEqual(corners(await vrml(at(0), drawn)));
  });

  test('grids of heights lie along x, and behind one another along z', async () => {
    const grid = 'geometry ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 height [ 0 1 2, 0 1 2 ] }';
    const { mesh } = await vrml(`Shape { ${grid} }`);
    const size = [0, 1, 2].map((axis) => {
      const values = [...mesh.positions].filter((_, i) => i % 3 === axis);
      return Math.max(...values) - Math.min(...values);
    });
    expect(size.map((value) => value / size[0])).toEqual([1, expect.closeTo(0.5, 5), expect.closeTo(0.25, 5)]);
    const [a, b, c] = [0, 1, 2].map((k) => new Vector3().fromArray(mesh.positions, 3 * mesh.indices![k]));
    expect(b.sub(a).cross(c.sub(a)).y).toBeGreaterThan(0);
  });

  test.each([
    ['Inline { url "other.wrl" }', 'parts in other files left out'],
    ['Shape { geometry Text { string [ "center" ] } }', 'text left out'],
  ])('what is not drawn is said: %s', async (node, note) => {
    const model = await vrml(at(0), node);
    expect([triangles(model), model.notes]).toEqual([12, [note]]);
  });

  test('nodes of a file of its own are refused', async () => {
    expect(await refusal(['a.wrl', `${HEAD}PROTO Thing [ ] { ${at(0)} }\nThing { }`])).toBe(
      'a.wrl defines nodes of its own (PROTO), which this page does not read.',
    );
    expect(triangles(await vrml('# PROTO', at(0)))).toBe(12);
  });

  test('a file that needs nothing, and one whose brackets do not match, stay as they are', () => {
    expect(plainVrml(wrl())).toEqual({ text: wrl(), notes: [] });
    for (const text of [`${HEAD}LOD { level [ }`, `${HEAD}${'LOD { level '.repeat(1000)}`])
      expect(plainVrml(text)).toEqual({ text, notes: [] });
  });

  test('volumes are those of the boxes', async () => {
    const one = measure(await vrml(at(0))).volume;
    expect(measure(await vrml(`Transform { center 3 3 3 scale 2 2 2 children ${at(0)} }`)).volume).toBeCloseTo(one, 5);
  });
});
