import { describe, expect, test } from 'vitest';
import type { ReadMesh } from '../../../../../src/viewer/files/readModel.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../../tools/modelFiles/box.js';
import { colorsOf, read, triangles } from '../../../../../tools/modelFiles/modelWriters.js';
import { zip } from '../../../../../tools/modelFiles/sceneWriters.js';

const ROOT = '3D/3dmodel.model';
const IN_FILE = (n: number): string => `3D/Objects/object_${n}.model`;

/** An object of one box. @param of attributes of its triangles */
const box = (id: number, size: readonly number[], attributes = '', of = (_face: number): string => ''): string => {
  const vertices = BOX_CORNERS.map(([x, y, z]) => `<vertex x="${x * size[0]}" y="${y * size[1]}" z="${z * size[2]}"/>`);
  const faces = BOX_FACES.flatMap(([a, b, c, d], face) =>
    [
      [a, b, c],
      [a, c, d],
    ].map(([i, j, k]) => `<triangle v1="${i}" v2="${j}" v3="${k}" ${of(face)}/>`),
  );
  return `<object id="${id}" type="model" ${attributes}><mesh><vertices>${vertices.join('')}</vertices><triangles>${faces.join('')}</triangles></mesh></object>`;
};
const component = (id: number, from?: string, transform?: string): string =>
  `<component ${from ? `p:path="/${from}" ` : ''}objectid="${id}"${transform ? ` transform="${transform}"` : ''}/>`;
const group = (id: number, ...components: string[]): string =>
  `<object id="${id}" type="model"><components>${components.join('')}</components></object>`;
const model = (resources: string, items = '', unit = 'millimeter'): string =>
  `<?xml version="1.0"?><!-- <resources> --><model unit="${unit}" xmlns="core" xmlns:p="production"><resources>${resources}</resources><build>${items}</build></model>`;
const at = (x: number): string => `1 0 0 0 1 0 0 0 1 ${x} 0 0`;
const item = (id: number, transform = at(0)): string => `<item objectid="${id}" transform="${transform}"/>`;

const packed = (files: Readonly<Record<string, string>>): [string, Uint8Array][] => [
  [
    'parts.3mf',
    zip({
      '_rels/.rels': `<Relationships><Relationship Target="/${ROOT}" Id="r" Type="model"/></Relationships>`,
      ...files,
    }),
  ],
];

/** The sizes of the boxes, as they follow one another along x, in the unit of the file. */
function boxesIn({ mesh: { positions, indices } }: ReadMesh, width: number): number[][] {
  const corners = Array.from(indices!, (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]);
  const extent = (among: number[][], axis: number): number =>
    Math.max(...among.map((corner) => corner[axis])) - Math.min(...among.map((corner) => corner[axis]));
  const scale = width / extent(corners, 0);
  const boxes = Array.from({ length: corners.length / 36 }, (_, i) => corners.slice(36 * i, 36 * i + 36));
  return boxes
    .sort(([[a]], [[b]]) => a - b)
    .map((one) => [0, 1, 2].map((axis) => Number((scale * extent(one, axis)).toFixed(3))));
}

describe('3MF', () => {
  test('parts in files of their own, each of which counts its objects from 1', async () => {
    const read3mf = await read(
      ...packed({
        [ROOT]: model(
          group(2, component(1, IN_FILE(1))) + group(4, component(1, IN_FILE(2))),
          item(2) + item(4, at(60)),
        ),
        [IN_FILE(1)]: model(box(1, [30, 20, 40])),
        [IN_FILE(2)]: model(box(1, [15, 60, 15])),
      }),
    );
    expect(boxesIn(read3mf, 75)).toEqual([
      [30, 20, 40],
      [15, 60, 15],
    ]);
    expect(read3mf.notes).toEqual([]);
  });

  test('a part of another unit, a file that is drawn twice, items of another file, and blanks in transforms', async () => {
    const inches = await read(
      ...packed({
        [ROOT]: model(
          group(2, component(1, IN_FILE(1)), component(1, IN_FILE(1), ' 1 0 0  0 1 0\n0 0 1 100 0 0 ')),
          `${item(2)}<item p:path="/${IN_FILE(2)}" objectid="7" transform="${at(200)}"><metadatagroup/></item>`,
        ),
        [IN_FILE(1)]: model(box(1, [1, 2, 1]), '', 'inch'),
        [IN_FILE(2)]: model(box(7, [50, 10, 10])),
      }),
    );
    expect(boxesIn(inches, 250)).toEqual([
      [25.4, 50.8, 25.4],
      [25.4, 50.8, 25.4],
      [50, 10, 10],
    ]);
  });

  test('colours of every file, with triangles that have none', async () => {
    const red = '<basematerials id="5"><base name="a" displaycolor="#FF0000FF"/></basematerials>';
    const blue = '<m:colorgroup id="5"><m:color color="#0000FF"/></m:colorgroup>';
    const coloured = await read(
      ...packed({
        [ROOT]: model(group(2, component(1, IN_FILE(1)), component(1, IN_FILE(2), at(2))), item(2)),
        [IN_FILE(1)]: model(red + box(1, [1, 1, 1], '', (face) => (face < 2 ? 'pid="5" p1="0"' : ''))),
        [IN_FILE(2)]: model(blue + box(1, [1, 1, 1], 'pid="5"')),
      }),
    );
    const counts = new Map<string, number>();
    for (const colour of colorsOf(coloured)) counts.set(colour, (counts.get(colour) ?? 0) + 1);
    expect(counts).toEqual(
      new Map([
        ['255,0,0', 4],
        ['255,255,255', 8],
        ['0,0,255', 12],
      ]),
    );
  });

  test('a colour with an alpha is seen through', async () => {
    const colour = (alpha: string): string =>
      `<basematerials id="5"><base name="a" displaycolor="#FF0000${alpha}"/></basematerials>`;
    const seenThrough = async (alpha: string): Promise<boolean> => {
      const resources = colour(alpha) + box(1, [1, 1, 1], 'pid="5" pindex="0"') + box(2, [2, 2, 2]);
      const { mesh } = await read(...packed({ [ROOT]: model(resources, item(1) + item(2, at(4))) }));
      return mesh.ranges?.some(({ isSeeThrough }) => isSeeThrough) ?? false;
    };
    expect(await Promise.all(['40', 'FF'].map(seenThrough))).toEqual([true, false]);
  });

  test('a colour group with alpha has one colour per triangle, and is see-through', async () => {
    const colours = '<m:colorgroup id="9"><m:color color="#0000FF40"/><m:color color="#FF0000"/></m:colorgroup>';
    const painted = box(1, [1, 1, 1], 'pid="9" pindex="1"', (face) =>
      face === 0 ? ' pid="9" p1="0" p2="0" p3="0"' : '',
    );
    const { mesh } = await read(...packed({ [ROOT]: model(colours + painted, item(1)) }));
    expect(mesh.ranges!.map(({ count, isSeeThrough = false }) => [count / 3, isSeeThrough])).toEqual([
      [10, false],
      [2, true],
    ]);
    expect(colorsOf({ mesh } as ReadMesh).slice(-2)).toEqual(['0,0,255', '0,0,255']);
  });

  test.each(['support', 'solidsupport', 'other'])('objects of the type %s are no part of the model', async (type) => {
    const helper = box(2, [2, 2, 2]).replace('type="model"', `type="${type}"`);
    expect(helper).toContain(type);
    const resources = box(1, [1, 1, 1]) + helper;
    const drawn = await read(...packed({ [ROOT]: model(resources, item(1) + item(2, at(4))) }));
    expect([triangles(drawn), drawn.notes]).toEqual([12, ['1 helper of the slicer left out']]);
  });

  test.each([
    ['paint_color="8"', ['painted colours left out']],
    ['slic3rpe:mmu_segmentation="8"', ['painted colours left out']],
    ['paint_color=""', []],
    ['paint_supports="8" paint_seam="4"', []],
  ])('paint by triangle, %s, is said where it is a colour', async (attribute, notes) => {
    const painted = box(1, [1, 1, 1], '', (face) => (face === 0 ? ` ${attribute}` : ''));
    expect((await read(...packed({ [ROOT]: model(painted, item(1)) }))).notes).toEqual(notes);
  });

  test('properties that are no plain colours leave the triangles, and are named', async () => {
    const mixed = '<m:multiproperties id="5" pids="1 2"><m:multi pindices="0 0"/></m:multiproperties>';
    const drawn = await read(...packed({ [ROOT]: model(mixed + box(1, [1, 1, 1], 'pid="5" pindex="0"'), item(1)) }));
    expect(triangles(drawn)).toBe(12);
    expect(drawn.notes).toEqual(['mixed colours left out']);
  });

  test('the colours of filaments, where there are several, and no volumes that are not printed', async () => {
    const settings = (second: number): Record<string, string> => ({
      [ROOT]: model(
        group(2, component(1, IN_FILE(1)), component(2, IN_FILE(1), at(2)), component(3, IN_FILE(1))),
        item(2),
      ),
      [IN_FILE(1)]: model(box(1, [1, 1, 1]) + box(2, [1, 1, 1]) + box(3, [9, 9, 9])),
      'Metadata/project_settings.config': '{"filament_colour": ["#00FF00", "#FF0000FF"]}',
      'Metadata/model_settings.config': `<config><object id="2"><metadata key="extruder" value="1"/>
        <part id="1" subtype="normal_part"/><part id="2" subtype="normal_part"><metadata key="extruder" value="${second}"/></part>
        <part id="3" subtype="modifier_part"/></object></config>`,
    });
    const two = await read(...packed(settings(2)));
    expect([new Set(colorsOf(two)), triangles(two)]).toEqual([new Set(['0,255,0', '255,0,0']), 24]);
    expect(two.notes).toEqual(['1 helper of the slicer left out']);
    expect((await read(...packed(settings(1)))).mesh.colors).toBe(null);
  });

  test('a part whose file is missing is counted', async () => {
    const { notes } = await read(
      ...packed({ [ROOT]: model(box(1, [1, 1, 1]) + group(2, component(1), component(1, IN_FILE(9))), item(2)) }),
    );
    expect(notes).toEqual(['1 part left out: not in its file']);
  });
});
