import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  ExtrudeGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Shape,
  Vector2,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { NodeSurroundings } from '../../../../src/command/draw/NodeSurroundings.js';
import { runToEnd } from '../../../../src/mesh/phases.js';
import { makeFish } from '../../../../src/playground/models/makeFish.js';
import { makeFox } from '../../../../src/playground/models/makeFox.js';
import { dataOf } from '../../../../src/viewer/files/common/ModelFile.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { type ChosenView, chooseViews } from '../../../../src/viewer/views/chooseViews.js';
import { sceneTriangles } from '../../../../src/viewer/views/sceneTriangles.js';
import type { ViewTriangles } from '../../../../src/viewer/views/viewSurface.js';

const angleBetween = (a: number, b: number): number => Math.abs(((((a - b) % 360) + 540) % 360) - 180);

const viewsOf = (triangles: ViewTriangles): ChosenView[] => runToEnd(chooseViews(triangles, 'y'));

/** The triangles of a geometry, turned about the up axis by an angle in degrees. */
function turned({ positions, ...rest }: ViewTriangles, degrees: number): ViewTriangles {
  const [cos, sin] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
  const points = Float32Array.from(positions);
  for (let i = 0; i < points.length; i += 3) {
    points[i] = cos * positions[i] + sin * positions[i + 2];
    points[i + 2] = cos * positions[i + 2] - sin * positions[i];
  }
  return { positions: points, ...rest };
}

const ofGeometry = (geometry: BufferGeometry): ViewTriangles => ({
  positions: geometry.attributes.position.array,
  indices: geometry.index?.array ?? null,
  isSingleSided: null,
});

async function suzanne(): Promise<ViewTriangles> {
  const { default: uri } = await import('@pmndrs/assets/models/suzi.glb.js');
  const read = await readModel(
    [{ name: 'suzanne.glb', content: new Blob([dataOf(uri)!]) }],
    () => {},
    new NodeSurroundings('.'),
  );
  if (read.kind !== 'mesh') throw new Error('expected a mesh');
  return { positions: read.mesh.positions, indices: read.mesh.indices, isSingleSided: null };
}

/** Divides the triangles that lie behind x = 0 in four. */
function finerBehind({ positions, indices }: ViewTriangles): ViewTriangles {
  const points: number[] = [];
  const at = (corner: number): number[] =>
    [0, 1, 2].map((k) => positions[3 * (indices ? indices[corner] : corner) + k]);
  const count = indices?.length ?? positions.length / 3;
  for (let corner = 0; corner < count; corner += 3) {
    const [a, b, c] = [at(corner), at(corner + 1), at(corner + 2)];
    const middle = (p: number[], q: number[]): number[] => p.map((value, k) => (value + q[k]) / 2);
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    if (a[2] + b[2] + c[2] > 0) points.push(...a, ...b, ...c);
    else points.push(...a, ...ab, ...ca, ...ab, ...b, ...bc, ...ca, ...bc, ...c, ...ab, ...bc, ...ca);
  }
  return { positions: points, indices: null, isSingleSided: null };
}

describe('the first view of', () => {
  test.each([0, 90, 180, 230])('a head is on its face, wherever that is: turned by %i°', async (degrees) => {
    const [first] = viewsOf(turned(await suzanne(), degrees));
    expect(angleBetween(first.azimuth, degrees)).toBeLessThanOrEqual(45);
  });

  test.each([0, 180])('an animal is three-quarter from its head, wherever that is: turned by %i°', async (degrees) => {
    const fox = viewsOf(turned(sceneTriangles((await makeFox()).root), degrees));
    expect(angleBetween(fox[0].azimuth, degrees)).toBeLessThanOrEqual(45);
    const fish = viewsOf(turned(sceneTriangles((await makeFish()).root), degrees));
    const fromHead = angleBetween(fish[0].azimuth, 270 + degrees);
    expect(fromHead).toBeGreaterThanOrEqual(20);
    expect(fromHead).toBeLessThanOrEqual(80);
  });

  test('a head is on its face, also where its back has four times as many triangles', async () => {
    const [first] = viewsOf(finerBehind(await suzanne()));
    expect(angleBetween(first.azimuth, 0)).toBeLessThanOrEqual(45);
  });

  test.each([0, 90, 40])('a plate shows its broad side: turned by %i°', (degrees) => {
    const [first] = viewsOf(turned(ofGeometry(new BoxGeometry(1, 1, 0.06)), degrees));
    const off = angleBetween(first.azimuth, degrees);
    expect(Math.min(off, 180 - off)).toBeLessThanOrEqual(45);
  });

  /** A long body with a low bonnet and a windscreen at +z, and a cab with an upright rear. */
  const car = (): ViewTriangles => {
    const side = new Shape(
      [
        [-2, 0],
        [2, 0],
        [2, 0.7],
        [1, 0.8],
        [0.3, 1.4],
        [-1.9, 1.4],
        [-2, 0.8],
      ].map(([x, y]) => new Vector2(x, y)),
    );
    const body = new ExtrudeGeometry(side, { depth: 1.6, bevelEnabled: false }).translate(0, 0, -0.8);
    return ofGeometry(body.rotateY(-Math.PI / 2));
  };
  /** A seat with a back at −z. */
  const chair = (): ViewTriangles =>
    ofGeometry(
      mergeGeometries([
        new BoxGeometry(1, 0.1, 1),
        new BoxGeometry(1, 1, 0.1).translate(0, 0.5, -0.45),
        ...[-0.45, 0.45].flatMap((x) => [-0.45, 0.45].map((z) => new BoxGeometry(0.1, 1, 0.1).translate(x, -0.5, z))),
      ]),
    );

  test.each([0, 90, 180, 270])('a car is on its bonnet and a chair on its seat: turned by %i°', (degrees) => {
    expect(angleBetween(viewsOf(turned(car(), degrees))[0].azimuth, degrees)).toBeLessThanOrEqual(85);
    expect(angleBetween(viewsOf(turned(chair(), degrees))[0].azimuth, degrees)).toBeLessThanOrEqual(50);
  });

  test.each([
    ['headlight', 0],
    ['tail light, rear', 180],
  ])(
    'a box is on its side with a part that is named for the front, or against one for the back: %s',
    (name, azimuth) => {
      const box = new BoxGeometry(1, 0.6, 2).toNonIndexed();
      const lamp = new BoxGeometry(0.2, 0.2, 0.02).translate(0, 0, 1).toNonIndexed();
      const triangles = ofGeometry(mergeGeometries([box, lamp]));
      const ofVertices = Uint32Array.from({ length: triangles.positions.length / 3 }, (_, i) => Number(i >= 36));
      const [first] = viewsOf({ ...triangles, parts: { names: ['body', name], ofVertices } });
      expect(angleBetween(first.azimuth, azimuth)).toBeLessThanOrEqual(85);
    },
  );

  test('a mug shows its handle', () => {
    const mug = new Group();
    const material = new MeshBasicMaterial();
    const handle = new Mesh(new BoxGeometry(0.6, 0.7, 0.12), material);
    handle.position.x = -1.1;
    mug.add(new Mesh(new CylinderGeometry(0.9, 0.9, 2, 32), material), handle);
    expect(angleBetween(viewsOf(sceneTriangles(mug))[0].azimuth, 270)).toBeLessThanOrEqual(75);
  });

  test('terrain is from above', () => {
    const plane = new PlaneGeometry(2, 2, 20, 20).rotateX(-Math.PI / 2);
    const { position } = plane.attributes;
    for (let i = 0; i < position.count; i++)
      position.setY(i, 0.15 * Math.sin(5 * position.getX(i)) * Math.cos(4 * position.getZ(i)));
    const [first] = viewsOf(ofGeometry(plane));
    expect(first.elevation).toBeGreaterThanOrEqual(30);
  });

  test('a room whose walls are single-sided is from above, and sees inside', () => {
    const room = new BoxGeometry(2, 1, 2).scale(-1, 1, 1);
    const triangles = ofGeometry(room);
    const [first] = viewsOf({ ...triangles, isSingleSided: new Uint8Array(12).fill(1) });
    expect(first.elevation).toBeGreaterThanOrEqual(30);
  });
});

test('four views are offered, from sides that differ', async () => {
  const views = viewsOf(await suzanne());
  expect(views).toHaveLength(4);
  for (const [i, view] of views.entries()) {
    for (const other of views.slice(i + 1))
      expect(angleBetween(view.azimuth, other.azimuth)).toBeGreaterThanOrEqual(60);
  }
});

test('one of the first three views is from behind the first one', async () => {
  for (const triangles of [await suzanne(), ofGeometry(new BoxGeometry(1, 0.6, 2))]) {
    const [first, ...others] = viewsOf(triangles);
    const behind = others.filter(({ azimuth }) => angleBetween(azimuth, first.azimuth) >= 140);
    expect(behind.length).toBeGreaterThan(0);
  }
});

test('a surface without area has no views', () => {
  expect(viewsOf({ positions: [0, 0, 0, 1, 0, 0, 2, 0, 0], indices: null, isSingleSided: null })).toEqual([]);
  expect(viewsOf({ positions: [], indices: null, isSingleSided: null })).toEqual([]);
});

test('the progress rises to its end', () => {
  const steps = [...chooseViews(ofGeometry(new BoxGeometry()), 'y')];
  expect(steps).toEqual(steps.toSorted((a, b) => a - b));
  expect(steps.at(-1)).toBeLessThanOrEqual(1);
});
