import { type BufferGeometry, DoubleSide, FrontSide, type Material, type Mesh } from 'three';
import { describe, expect, test } from 'vitest';
import type { FileChangeKind } from '../../../../src/viewer/files/common/fileChanges.js';
import { parseGltf } from '../../../../src/viewer/files/gltf/parseGltf.js';
import { openCeiling } from '../../../../src/viewer/files/mesh/openCeiling.js';
import { boundsOf } from '../../../../src/viewer/files/mesh/PlainMesh.js';
import { type ReadMesh, readModel } from '../../../../src/viewer/files/readModel.js';
import { addTrack, GltfBuilder } from '../../../../tools/modelFiles/GltfBuilder.js';
import { file, PRISM_CORNERS, PRISM_FACES, triangles } from '../../../../tools/modelFiles/modelWriters.js';

type Point = readonly [x: number, y: number, z: number];
type Faces = readonly (readonly Point[])[];

/** The six sides of a box between two corners, seen from outside. */
function box([a, b, c]: Point, [d, e, f]: Point): Faces {
  const quads = [
    'abc aec dec dbc',
    'abf dbf def aef',
    'abc abf aef aec',
    'dbc dec def dbf',
    'abc dbc dbf abf',
    'aec aef def dec',
  ];
  const values: Record<string, number> = { a, b, c, d, e, f };
  return quads.map((quad) => quad.split(' ').map((at) => [...at].map((key) => values[key]) as unknown as Point));
}

/** An OBJ file with an object for each list of faces. */
function obj(objects: Record<string, Faces>, place: (point: Point) => Point = (point) => point): string {
  const lines: string[] = [];
  let count = 0;
  for (const [name, faces] of Object.entries(objects)) {
    lines.push(`o ${name}`);
    for (const face of faces) {
      for (const point of face) lines.push(`v ${place(point).join(' ')}`);
      lines.push(`f ${face.map(() => ++count).join(' ')}`);
    }
  }
  return lines.join('\n');
}

const FLOOR = box([0, 0, 0], [10, 0.2, 8]);
const CEILING = box([0, 2.8, 0], [10, 3, 8]);
/** Walls as thick as a brick is long, with a door and a window. */
const WALLS = [
  ...box([0, 0.2, 0], [10, 2.8, 0.25]),
  ...box([0, 0.2, 7.75], [4, 2.8, 8]),
  ...box([5, 0.2, 7.75], [7, 2.8, 8]),
  ...box([7, 0.2, 7.75], [9, 1.1, 8]),
  ...box([9, 0.2, 7.75], [10, 2.8, 8]),
  ...box([0, 0.2, 0.25], [0.25, 2.8, 7.75]),
  ...box([9.75, 0.2, 0.25], [10, 2.8, 7.75]),
  ...box([5, 0.2, 0.25], [5.2, 2.8, 5]),
];
const BED = box([1, 0.2, 1], [3, 0.8, 3]);
const TABLE = box([6, 0.2, 5], [8, 1, 6.5]);
const FLAT = { floor: FLOOR, walls: WALLS, bed: BED, table: TABLE };
const CLOSED = { ...FLAT, ceiling: CEILING };

/** A closed room as deep as a cupboard is. */
const CLOSED_ROW = Object.fromEntries(
  Object.entries(CLOSED).map(([name, faces]) => [
    name,
    faces.map((face) => face.map(([x, y, z]): Point => [x, y, z / 8])),
  ]),
);

async function read(content: string, ...switched: FileChangeKind[]): Promise<ReadMesh> {
  const model = await readModel([file('flat.obj', content)], () => {}, undefined, { switched });
  if (model.kind !== 'mesh') throw new Error('flat.obj is not a mesh');
  return model;
}

/** The sides of a prism that lies, seen from outside. */
const PRISM: Faces = PRISM_FACES.map((face) => face.map((corner) => PRISM_CORNERS[corner] as unknown as Point));

const sheet = (...points: Point[]): Faces => [points];
/** The sides of a box as sheets without thickness. */
const room = (high: number): Faces => box([0, 0, 0], [9, high, 7]);

describe('the ceiling of closed rooms', () => {
  test('opens walls that face outward alone, which are then drawn from both sides', () => {
    const corners = [...room(2.7), ...BED, ...TABLE];
    const mesh = {
      positions: Float32Array.from(corners.flat(2)),
      indices: Uint32Array.from(corners.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((k) => 4 * i + k))),
      normals: null,
      colors: null,
      isOneSided: true,
    };
    expect(openCeiling(mesh, 'y')).toMatchObject({ isOneSided: false });
    const ranges = [{ start: 0, count: mesh.indices.length, picture: -1, isOneSided: true }];
    expect(openCeiling({ ...mesh, ranges }, 'y')?.ranges).toMatchObject([{ isOneSided: false }]);
  });

  test('is left out, and its part with it; walls, floor and furniture stay', async () => {
    const { mesh, changes } = await read(obj(CLOSED));
    expect(changes).toEqual([{ kind: 'ceiling', sentence: 'its rooms are seen from above, without their ceiling' }]);
    expect(mesh.parts?.names).toEqual(['floor', 'walls', 'bed', 'table']);
    expect(triangles({ mesh } as ReadMesh)).toBe(triangles(await read(obj(FLAT))));
  });

  test('stays on request', async () => {
    const whole = await read(obj(CLOSED), 'ceiling');
    expect([whole.changes, triangles(whole)]).toEqual([[], 12 * 12]);
  });

  test('is found in models that lie, hang upside down or are far away', async () => {
    for (const place of [
      ([x, y, z]: Point): Point => [x, -z, y],
      ([x, y, z]: Point): Point => [1000 * x + 4e6, 1000 * y, 1000 * z - 5e6],
    ]) {
      const { changes } = await read(obj(CLOSED, place));
      expect(changes.map(({ kind }) => kind)).toContain('ceiling');
    }
  });

  test('is left out of sheets without thickness, whatever side they face', async () => {
    for (const sides of [room(2.7), room(2.7).map((face) => face.toReversed())]) {
      const { mesh, changes } = await read(obj({ room: sides, bed: BED, table: TABLE }), 'orientation');
      expect(changes.map(({ kind }) => kind)).toEqual(['ceiling']);
      const { low, high } = boundsOf(mesh.positions);
      expect((high[1] - low[1]) / (high[0] - low[0])).toBeCloseTo(2.7 / 9, 2);
    }
  });

  test.each<[string, Record<string, Faces>]>([
    ['an open hall', { floor: FLOOR, ceiling: CEILING, bed: BED, post: box([0, 0.2, 0], [0.3, 2.8, 0.3]) }],
    ['a table', { top: CEILING, legs: [...box([0, 0, 0], [0.3, 2.8, 0.3]), ...box([9.7, 0, 7.7], [10, 2.8, 8])] }],
    ['a hollow box', { outside: room(3), inside: box([0.3, 0.3, 0.3], [8.7, 2.7, 6.7]) }],
    ['a solid box', { box: room(3) }],
    ['a row of cupboards', CLOSED_ROW],
    ['a prism that lies on a side', { prism: PRISM }],
    ['a plate', { plate: CEILING }],
    [
      'a building of two floors',
      { floor: FLOOR, walls: WALLS, bed: BED, ...{ second: CEILING, roof: box([0, 6, 0], [10, 6.2, 8]) } },
    ],
    [
      'a house with a pitched roof',
      {
        ...FLAT,
        roof: [
          ...sheet([0, 2.8, 0], [0, 2.8, 8], [5, 6, 8], [5, 6, 0]),
          ...sheet([10, 2.8, 8], [10, 2.8, 0], [5, 6, 0], [5, 6, 8]),
        ],
      },
    ],
    ['a room without one', FLAT],
  ])('%s is left as it is', async (_, objects) => {
    const { mesh, changes } = await read(obj(objects), 'orientation');
    expect(changes.map(({ kind }) => kind)).toEqual([]);
    const faces = Object.values(objects).flat();
    expect(triangles({ mesh } as ReadMesh)).toBe(faces.reduce((sum, face) => sum + face.length - 2, 0));
  });
});

/** A glTF file whose parts glow, so that it stays a scene, with a node for each list of faces. */
function glb(objects: Record<string, Faces>, { moves = false } = {}): Uint8Array<ArrayBuffer> {
  const builder = new GltfBuilder();
  const { json } = builder;
  json.materials = [{ emissiveFactor: [0.1, 0.1, 0.1] }];
  json.nodes = Object.keys(objects).map((name, mesh) => ({ name, mesh }));
  json.scenes = [{ nodes: json.nodes.map((_: object, i: number) => i) }];
  json.meshes = Object.entries(objects).map(([name, faces]) => {
    const indices = Uint16Array.from(faces.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((k) => 4 * i + k)));
    const attributes = { POSITION: builder.accessor(Float32Array.from(faces.flat(2)), 'VEC3') };
    return { name, primitives: [{ attributes, indices: builder.accessor(indices, 'SCALAR'), material: 0 }] };
  });
  if (moves) {
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(new Float32Array(6), 'VEC3'));
  }
  return builder.glb() as Uint8Array<ArrayBuffer>;
}

/** The kinds of changes of a glTF file that stays a scene, and the triangles and sides of each of its meshes. */
async function scene(content: Uint8Array<ArrayBuffer>, ...switched: FileChangeKind[]) {
  const model = await readModel([file('flat.glb', content)], () => {}, undefined, { switched });
  if (model.kind !== 'parts') throw new Error('flat.glb is no scene');
  const { root } = await parseGltf(model.parts);
  const meshes = (root.getObjectsByProperty('isMesh', true) as Mesh<BufferGeometry, Material>[]).map(
    ({ name, geometry, material }) => [name, geometry.index!.count / 3, material.side],
  );
  return { changes: model.changes.map(({ kind }) => kind), meshes };
}

describe('the ceiling of closed rooms in a scene', () => {
  const rest = Object.entries(FLAT).map(([name, faces]) => [name, 2 * faces.length, DoubleSide]);

  test('is left out, and its mesh with it; what stays is drawn from both sides', async () => {
    expect(await scene(glb(CLOSED))).toEqual({ changes: ['ceiling'], meshes: rest });
  });

  test('is left out of a mesh that holds more', async () => {
    const { changes, meshes } = await scene(glb({ room: room(2.7), bed: BED, table: TABLE }));
    expect(changes).toEqual(['ceiling']);
    expect(meshes[0]).toEqual(['room', 10, DoubleSide]);
  });

  test.each([
    ['on request', glb(CLOSED), ['ceiling'] as const],
    ['where something moves', glb(CLOSED, { moves: true }), []],
  ])('stays %s', async (_, content, switched) => {
    const { changes, meshes } = await scene(content, ...switched);
    expect(changes).toEqual([]);
    expect(meshes).toContainEqual(['ceiling', 12, FrontSide]);
  });
});
