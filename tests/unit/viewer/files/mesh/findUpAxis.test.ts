import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { findUpAxis, type UsualUp } from '../../../../../src/viewer/files/mesh/findUpAxis.js';
import { GltfBuilder } from '../../../../../tools/modelFiles/GltfBuilder.js';
import { asciiStl, read } from '../../../../../tools/modelFiles/modelWriters.js';

const Y_UP: UsualUp = { up: 'y', liesFlat: false };
const PRINTED: UsualUp = { up: 'y', liesFlat: true };
const Z_UP: UsualUp = { up: 'z', liesFlat: true };
const standingOf = (geometry: BufferGeometry) =>
  findUpAxis(geometry.getAttribute('position').array, geometry.index?.array ?? null, Y_UP);
const upOf = (geometry: BufferGeometry, usual = Y_UP) =>
  findUpAxis(geometry.getAttribute('position').array, geometry.index?.array ?? null, usual)?.up;
/** Stands on its base, with its axis along y. */
const cone = () => new ConeGeometry(1, 2, 48);
const quarter = Math.PI / 2;

/** Half of an egg along z, cut flat across x, on four wheels. */
function vehicle(): BufferGeometry {
  const body = new SphereGeometry(1, 48, 24).scale(1.4, 0.4, 1.4).toNonIndexed();
  const xs = body.getAttribute('position');
  for (let i = 0; i < xs.count; i++) xs.setX(i, Math.min(xs.getX(i), 0));
  const wheels = [-1.1, -0.1].flatMap((x) =>
    [-0.8, 0.8].map((z) =>
      new CylinderGeometry(0.3, 0.3, 0.1, 24).rotateZ(quarter).translate(x, -0.3, z).toNonIndexed(),
    ),
  );
  return mergeGeometries([body, ...wheels]);
}

/** A round plate on four thin legs. */
const table = (): BufferGeometry =>
  mergeGeometries([
    new CylinderGeometry(1, 1, 0.1, 48).translate(0, 1, 0),
    ...[0, 1, 2, 3].map((i) => new CylinderGeometry(0.05, 0.05, 1.5).translate(0.8, 0.2, 0).rotateY(i * quarter)),
  ]);

/** A box for a back or a top, on four legs at the corners of a rectangle. */
const seat = (): BufferGeometry =>
  mergeGeometries([
    new BoxGeometry(1, 0.1, 1),
    new BoxGeometry(1, 1, 0.1).translate(0, 0.5, -0.45),
    ...[-0.45, 0.45].flatMap((x) => [-0.45, 0.45].map((z) => new BoxGeometry(0.1, 1, 0.1).translate(x, -0.5, z))),
  ]);

describe('the axis that points up', () => {
  test.each([
    ['-y', cone().rotateX(Math.PI)],
    ['z', cone().rotateX(quarter)],
    ['-z', cone().rotateX(-quarter)],
    ['-x', cone().rotateZ(quarter)],
    ['x', cone().rotateZ(-quarter)],
  ])('is %s by the flat side below, where models lie on printer beds', (up, geometry) => {
    expect(upOf(geometry, PRINTED)).toBe(up);
    expect(upOf(geometry.toNonIndexed(), PRINTED)).toBe(up);
  });

  test.each([
    ['z', 'z', cone().rotateX(quarter)],
    ['z, though it is above', 'z', cone().rotateX(-quarter)],
    ['that of the format, though it is above', 'y', cone().rotateX(Math.PI)],
    ['that of the format, though it is to the left', undefined, cone().rotateZ(quarter)],
  ])('is elsewhere by the flat side %s', (_, up, geometry) => {
    expect(upOf(geometry)).toBe(up);
  });

  test('is told with what the model stands on', () => {
    expect(standingOf(cone().rotateX(quarter))).toEqual({ up: 'z', on: 'flat side' });
    expect(standingOf(seat().rotateX(quarter))).toEqual({ up: 'z', on: 'feet' });
  });

  test('is that of a column, whichever end is up', () => {
    expect(upOf(new CylinderGeometry(0.5, 0.5, 3, 32).rotateX(quarter))).toBe('z');
  });

  test.each([
    ['no side is flat', new SphereGeometry(1, 32, 16)],
    ['no side is flat', new TorusKnotGeometry()],
    ['every side is', new BoxGeometry(1, 2, 3)],
    ['it may as well hang on a wall', new CylinderGeometry(0.9, 1, 0.2, 32).rotateX(quarter)],
    ['there is nothing', new SphereGeometry(1, 32, 16).setIndex([])],
  ])('is not told where %s', (_, geometry) => {
    expect(upOf(geometry)).toBeUndefined();
  });

  test.each([
    ['a cone on its base', cone()],
    ['a vehicle on its wheels, one side of which is flat', vehicle()],
    ['a table, though the flat side of it is above', table()],
  ])('is believed of what stands firmly: %s', (_, geometry) => {
    expect(upOf(geometry)).toBeUndefined();
    expect(upOf(geometry.clone().rotateX(quarter), Z_UP)).toBeUndefined();
  });

  test.each([
    ['z', seat().rotateX(quarter)],
    ['-y', seat().rotateX(Math.PI)],
    ['z', mergeGeometries([seat(), seat().scale(0.5, 1, 0.5).translate(0, 0, 1.5)]).rotateX(quarter)],
  ])('is %s by feet, though it would lie firmly on its back', (up, geometry) => {
    expect(upOf(geometry)).toBe(up);
    expect(upOf(geometry.toNonIndexed())).toBe(up);
  });

  test('is across the width by feet only in a format for printers', () => {
    const side = seat().rotateZ(-quarter);
    expect(upOf(side, PRINTED)).toBe('x');
    expect(upOf(side)).toBeUndefined();
  });

  test('is not by the flat back of what is higher than wide, unless it is deep', () => {
    const onBack = (width: number, depth: number) => cone().scale(width, depth, 1).rotateX(quarter);
    expect(upOf(onBack(0.7, 0.5))).toBeUndefined();
    expect(upOf(onBack(1.3, 0.65))).toBe('z');
    expect(upOf(onBack(0.7, 0.7))).toBe('z');
  });

  test('is believed of what stands on feet, or would on either end', () => {
    expect(upOf(seat())).toBeUndefined();
    const posts = mergeGeometries([
      new BoxGeometry(1, 0.1, 1),
      ...[-0.45, 0.45].flatMap((x) => [-0.45, 0.45].map((z) => new BoxGeometry(0.1, 2, 0.1).translate(x, 0, z))),
    ]);
    expect(upOf(posts)).toBeUndefined();
    expect(upOf(posts, Z_UP)).toBe('y');
  });

  test('is not by the brackets of a railing, which would lie on them', () => {
    const bracketed = (depth: number) =>
      mergeGeometries([
        new BoxGeometry(2, 1, depth),
        ...[-0.8, 0.8].flatMap((x) =>
          [-0.4, 0.4].map((y) => new BoxGeometry(0.1, 0.1, 0.1).translate(x, y, -depth / 2 - 0.05)),
        ),
      ]);
    expect(upOf(bracketed(0.4))).toBe('z');
    expect(upOf(bracketed(0.05))).toBeUndefined();
  });

  test('is not by contacts out of line', () => {
    const tips = [0, 1, 2, 3, 4].map((i) =>
      new ConeGeometry(0.1, 1, 8)
        .rotateX(Math.PI)
        .translate(1, -0.5, 0)
        .rotateY((2 * Math.PI * i) / 5),
    );
    const star = mergeGeometries([new SphereGeometry(0.6, 24, 12).translate(0, 0.1, 0), ...tips]);
    expect(upOf(star.rotateX(quarter))).toBeUndefined();
  });

  test('is by the wheels of a vehicle on its roof, though one side of it is flat', () => {
    expect(upOf(vehicle().rotateX(Math.PI))).toBe('-y');
  });

  test('is across a plate that stands on its edge, in a format for printers alone', () => {
    const plate = new BoxGeometry(2, 0.06, 1.5);
    expect(upOf(plate, Z_UP)).toBe('y');
    expect(upOf(plate.clone().rotateZ(quarter), Z_UP)).toBe('x');
    expect(upOf(plate.clone().rotateX(quarter), Z_UP)).toBeUndefined();
    expect(upOf(plate, { ...Z_UP, liesFlat: false })).toBeUndefined();
    expect(upOf(new CylinderGeometry(1, 1, 0.2, 48), Z_UP)).toBe('y');
  });
});

describe('of a file', () => {
  const points = (geometry: BufferGeometry): number[][] => {
    const { array } = (geometry.index ? geometry.toNonIndexed() : geometry).getAttribute('position');
    return Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
  };
  const obj = (geometry: BufferGeometry): string =>
    points(geometry)
      .map((point, i) => `v ${point.join(' ')}${i % 3 === 2 ? '\nf -3 -2 -1' : ''}`)
      .join('\n');
  const stl = (geometry: BufferGeometry): string => {
    const corners = points(geometry).map((point) => point.join(' '));
    return corners.map((_, i) => (i % 3 === 0 ? asciiStl('0 0 0', corners.slice(i, i + 3)) : '')).join('');
  };
  const glb = (geometry: BufferGeometry): Uint8Array => {
    const builder = new GltfBuilder();
    const POSITION = builder.accessor(Float32Array.from(points(geometry).flat()), 'VEC3');
    builder.json.meshes[0].primitives[0] = { attributes: { POSITION } };
    return builder.glb();
  };
  const lyingCone = cone().rotateX(quarter);
  const plate = new BoxGeometry(2, 0.06, 1.5);

  test.each<[name: string, content: string | Uint8Array, stands: string | undefined]>([
    ['cone.obj', obj(lyingCone), 'z'],
    ['cone.glb', glb(lyingCone), undefined],
    ['cone.stl', stl(lyingCone), undefined],
    ['vehicle.obj', obj(vehicle()), undefined],
    ['vehicle.stl', stl(vehicle().rotateX(quarter)), undefined],
    ['plate.stl', stl(plate), 'y'],
    ['plate.obj', obj(plate), undefined],
  ])('%s', async (name, content, stands) => {
    expect((await read([name, content])).stands).toBe(stands);
  });
});
