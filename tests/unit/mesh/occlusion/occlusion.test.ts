import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Matrix4,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import { addDirections } from '../../../../src/mesh/occlusion/addDirections.js';
import { BACK, FRONT, type OcclusionMesh, type OcclusionScene } from '../../../../src/mesh/occlusion/OcclusionScene.js';
import { occlusionOf, packedSide, packedSides } from '../../../../src/mesh/occlusion/occlusionSides.js';
import { startOcclusion } from '../../../../src/mesh/occlusion/startOcclusion.js';
import { finish } from '../meshes.js';

/** The default of `bakeOcclusion`. */
const PAIRS = 192;

function meshOf(geometry: BufferGeometry, options: Partial<OcclusionMesh> = {}): OcclusionMesh {
  const { position, normal } = geometry.attributes;
  return {
    positions: Float32Array.from(position.array),
    indices: geometry.index
      ? Uint32Array.from(geometry.index.array)
      : Uint32Array.from({ length: position.count }, (_, i) => i),
    normals: Float32Array.from(normal.array),
    toWorld: new Matrix4().toArray(),
    sides: 'front',
    occluding: new Uint8Array((geometry.index ?? position).count / 3).fill(FRONT + BACK),
    ...options,
  };
}

/** The numbers of `count` pairs of directions. */
const pairsFrom = (first: number, count: number): number[] => Array.from({ length: count }, (_, i) => first + i);

const sideOf = (values: Int16Array, isBack: boolean): number[] =>
  Array.from(values, (value) => occlusionOf(value / 32767, isBack));
const frontsOf = (values: Int16Array): number[] => sideOf(values, false);

/** The occlusion of each vertex of each mesh with normals, and the state afterwards. */
function bakeOf(meshes: OcclusionMesh[], pairs = PAIRS): { occlusions: number[][]; scene: OcclusionScene } {
  const { scene, occlusions } = finish(
    addDirections({ scene: finish(startOcclusion({ meshes })), pairs: pairsFrom(0, pairs) }),
  );
  return { scene, occlusions: occlusions.map(frontsOf) };
}

const bake = (...meshes: OcclusionMesh[]): number[][] => bakeOf(meshes).occlusions;

const largest = (values: readonly number[]): number => Math.max(...values);
const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;

/** A floor from x = 0 to 2 and a wall of height 1 over its edge, both 4 wide and of cells of 1/32. */
function corner(): [floor: BufferGeometry, wall: BufferGeometry] {
  const floor = new PlaneGeometry(2, 4, 64, 128).rotateX(-Math.PI / 2).translate(1, 0, 0);
  const wall = new PlaneGeometry(4, 1, 128, 32).rotateY(Math.PI / 2).translate(0, 0.5, 0);
  return [floor, wall];
}

/** The form factor of the wall of `corner` at a point of the floor: the cosine-weighted share of the sky that it hides. */
function hiddenByWall(x: number, z: number): number {
  const beyond = Math.hypot(x, 1);
  const to = (end: number) => Math.atan2(end, x) - (x / beyond) * Math.atan2(end, beyond);
  return (to(2 - z) - to(-2 - z)) / (2 * Math.PI);
}

describe('compared with exact form factors', () => {
  test('two planes at 90°: the form factor of the wall, right up to the edge', () => {
    const [floor, wall] = corner();
    const [values] = bake(meshOf(floor), meshOf(wall));
    const { position } = floor.attributes;
    // It jumps at the ends of the edge.
    const errors = values
      .map((value, i) => Math.abs(value - hiddenByWall(position.getX(i), position.getZ(i))))
      .filter((_, i) => Math.abs(position.getZ(i)) < 1.85);
    expect(mean(errors)).toBeLessThan(0.01);
    expect(largest(errors)).toBeLessThan(0.05);
    expect(mean(values.filter((_, i) => position.getX(i) < 0.001 && Math.abs(position.getZ(i)) < 1.85))).toBeCloseTo(
      0.5,
      1,
    );
  });

  // Inside a sphere every piece of it has the same form factor, seen from anywhere on it: its share of the area.
  test.each([90, 60, 30])('a round pit that opens by %d° to each side: every place in it sees as much', (degrees) => {
    const opening = (degrees * Math.PI) / 180;
    const pit = new SphereGeometry(1, 64, 64, 0, 2 * Math.PI, opening, Math.PI - opening);
    const [values] = bake(meshOf(pit, { sides: 'back' }));
    const closed = (1 + Math.cos(opening)) / 2;
    const errors = values.map((value) => Math.abs(value - closed));
    const { position } = pit.attributes;
    const bottom = values.filter((_, i) => position.getY(i) < -0.999);
    expect(bottom.length).toBeGreaterThan(0);
    expect(largest(bottom.map((value) => Math.abs(value - closed)))).toBeLessThan(0.03);
    expect(mean(errors)).toBeLessThan(0.012);
    expect(largest(errors)).toBeLessThan(0.06);
  });

  test('a ball over a plane: its form factor, and the plane occludes the underside of the ball', () => {
    const plane = meshOf(new PlaneGeometry(6, 6, 64, 64));
    const ball = meshOf(new SphereGeometry(0.5, 48, 32), { toWorld: new Matrix4().makeTranslation(0, 0, 1).toArray() });
    const [onPlane, onBall] = bake(plane, ball);
    const errors = onPlane.map((value, i) => {
      const [x, y] = plane.positions.subarray(3 * i);
      return Math.abs(value - 0.25 / (x * x + y * y + 1) ** 1.5);
    });
    expect(mean(errors)).toBeLessThan(0.01);
    expect(largest(errors)).toBeLessThan(0.06);
    const lowest = onBall.filter((_, i) => ball.positions[3 * i + 2] < -0.499);
    const highest = onBall.filter((_, i) => ball.positions[3 * i + 2] > 0.499);
    // A square of side 6 hides nearly all of the lower sky.
    expect(mean(lowest)).toBeGreaterThan(0.95);
    expect(largest(highest)).toBe(0);
  });

  test('more directions give a smaller error', () => {
    const [floor, wall] = corner();
    const { position } = floor.attributes;
    const errors = [8, 32, 128].map((pairs) =>
      mean(
        bakeOf([meshOf(floor), meshOf(wall)], pairs).occlusions[0].map((value, i) =>
          Math.abs(value - hiddenByWall(position.getX(i), position.getZ(i))),
        ),
      ),
    );
    expect(errors[1]).toBeLessThan(0.6 * errors[0]);
    expect(errors[2]).toBeLessThan(0.6 * errors[1]);
  });
});

describe('what must not darken', () => {
  test.each([
    ['a box of 12 triangles', new BoxGeometry()],
    ['a coarse ball', new SphereGeometry(1, 8, 6)],
    ['a fine ball', new SphereGeometry(1, 96, 64)],
    ['an open plane', new PlaneGeometry(1, 1, 7, 7)],
    ['an open plane of two triangles', new PlaneGeometry(1, 1)],
  ])('%s alone', (_, geometry) => {
    expect(largest(bakeOf([meshOf(geometry)], 64).occlusions[0])).toBe(0);
  });

  test('a plane below a mesh that occludes nothing', () => {
    const roof = meshOf(new PlaneGeometry(3, 3).translate(0, 0, 0.5), { occluding: new Uint8Array(2) });
    const [ground, above] = bakeOf([meshOf(new PlaneGeometry(1, 1, 4, 4)), roof], 32).occlusions;
    expect(largest(ground)).toBe(0);
    expect(largest(above)).toBe(0);
  });

  test('vertices that no triangle uses', () => {
    const roof = meshOf(new PlaneGeometry(3, 3).rotateX(Math.PI).translate(0, 0, 0.5));
    const plane = meshOf(new PlaneGeometry(1, 1, 2, 2));
    plane.positions = Float32Array.from([...plane.positions, NaN, NaN, NaN]);
    plane.normals = Float32Array.from([...plane.normals!, 0, 0, 1]);
    const [values] = bakeOf([plane, roof], 16).occlusions;
    expect(Math.min(...values.slice(0, 9))).toBeGreaterThan(0.7);
    expect(values[9]).toBe(0);
  });
});

describe('a floor of two triangles', () => {
  const floor = () => new PlaneGeometry(2, 2).rotateX(-Math.PI / 2);
  const posts = () =>
    [-1, 1].flatMap((x) => [-1, 1].map((z) => meshOf(new BoxGeometry(0.3, 0.4, 0.3).translate(x, 0.2, z))));

  test.each<[string, OcclusionMesh]>([
    ['its front', meshOf(floor())],
    ['its back', meshOf(floor().rotateX(Math.PI), { sides: 'back' })],
  ])('whose corners lie under posts is lit, since it is open between them: %s', (_, mesh) => {
    const [values] = bakeOf([mesh, ...posts()], 64).occlusions;
    // The corners themselves see nothing, and do not count; two places within each triangle see nearly everything.
    for (const value of values) expect(value).toBeLessThan(0.16);
    expect(Math.min(...values)).toBeGreaterThan(0.01);
  });

  test('that is drawn from both sides is lit on each', () => {
    const below = posts().map((post) => ({ ...post, toWorld: new Matrix4().makeTranslation(0, -0.4, 0).toArray() }));
    const scene = finish(startOcclusion({ meshes: [meshOf(floor(), { sides: 'both' }), ...posts(), ...below] }));
    const { occlusions } = finish(addDirections({ scene, pairs: pairsFrom(0, 64) }));
    for (const isBack of [false, true]) expect(largest(sideOf(occlusions[0], isBack))).toBeLessThan(0.16);
  });

  test('under a roof is dark, although its corners reach beyond', () => {
    const roof = meshOf(new PlaneGeometry(1.9, 1.9).rotateX(Math.PI / 2).translate(0, 0.05, 0));
    const [values] = bakeOf([meshOf(floor()), roof], 64).occlusions;
    for (const value of values) expect(value).toBeGreaterThan(0.5);
  });
});

describe('a wall of two triangles', () => {
  // Of the size of a part: neither large nor slender.
  const wall = () => meshOf(new PlaneGeometry(0.4, 0.4).translate(0, 0.15, 0));
  const ground = () => meshOf(new BoxGeometry(4, 1, 4, 16, 1, 16).translate(0, -0.5, 0));

  test('whose foot lies in the ground is lit down to the ground', () => {
    const values = bakeOf([wall(), ground()], 64).occlusions[0];
    expect(largest(values)).toBeLessThan(0.55);
    // The ground hides half of the sky, and nothing hides the rest.
    expect(Math.min(...values)).toBeGreaterThan(0.35);
  });

  test('that lies in the ground as a whole is dark', () => {
    const buried = { ...wall(), toWorld: new Matrix4().makeTranslation(0, -0.6, 0).toArray() };
    expect(Math.min(...bakeOf([buried, ground()], 64).occlusions[0])).toBeGreaterThan(0.98);
  });
});

describe('a rod', () => {
  const rod = () => meshOf(new CylinderGeometry(0.05, 0.05, 2, 12, 1, true));
  const balls = () => [-1, 1].map((y) => meshOf(new SphereGeometry(0.3, 24, 16).translate(0, y, 0)));

  test('whose ends lie in balls is lit, since it is seen between them', () => {
    const [values] = bakeOf([rod(), ...balls()], 24).occlusions;
    for (const value of values) expect(value).toBeLessThan(0.1);
    // The balls hide a little of the sky.
    expect(mean(values)).toBeGreaterThan(0.005);
  });

  test('that is a wide blade, slightly bent, is lit too', () => {
    // Its normals deviate from those of its triangles, which are large.
    const blade = meshOf(new CylinderGeometry(0.4, 0.4, 2, 6, 1, true, 0, Math.PI));
    const [values] = bakeOf(
      [blade, ...balls().map((ball) => ({ ...ball, toWorld: new Matrix4().makeScale(2, 1, 2).toArray() }))],
      24,
    ).occlusions;
    expect(largest(values)).toBeLessThan(0.6);
  });

  test('that is drawn from both sides is lit outside, and dark within', () => {
    const both = meshOf(new CylinderGeometry(0.05, 0.05, 2, 12, 1, true), { sides: 'both' });
    const scene = finish(startOcclusion({ meshes: [both, ...balls()] }));
    const [values] = finish(addDirections({ scene, pairs: pairsFrom(0, 24) })).occlusions;
    expect(largest(sideOf(values, false))).toBeLessThan(0.5);
    expect(Math.min(...sideOf(values, true))).toBeGreaterThan(0.9);
  });

  test('that lies in a body as a whole is dark, and one with free ends is hardly darker where it passes a ring', () => {
    const [within] = bakeOf([rod(), meshOf(new BoxGeometry(1, 3, 1))], 24).occlusions;
    expect(Math.min(...within)).toBeGreaterThan(0.98);
    const ring = meshOf(new TorusGeometry(0.12, 0.06, 12, 24).rotateX(Math.PI / 2));
    const [free] = bakeOf([rod(), ring], 24).occlusions;
    expect(largest(free)).toBeLessThan(0.15);
  });
});

describe('a box seen from within', () => {
  const floorOf = (sides: number, options: Partial<OcclusionMesh> = {}) => {
    const geometry = new BoxGeometry(1, 1, 1, 4, 4, 4).toNonIndexed();
    const mesh = meshOf(geometry, { sides: sides === FRONT ? 'front' : 'back', ...options });
    mesh.occluding.fill(sides);
    const [values] = bakeOf([mesh], 64).occlusions;
    const { normal } = geometry.attributes;
    return mean(values.filter((_, vertex) => normal.getY(vertex) < 0));
  };

  test('is dark where both sides occlude', () => {
    const mesh = meshOf(new BoxGeometry(1, 1, 1, 4, 4, 4), { sides: 'back' });
    expect(mean(bakeOf([mesh], 64).occlusions[0])).toBeGreaterThan(0.98);
  });

  test.each<[string, number, Partial<OcclusionMesh>]>([
    ['backs', BACK, {}],
    ['mirrored backs', BACK, { toWorld: new Matrix4().makeScale(1, 1, -1).toArray() }],
  ])('gets light through the side that is not drawn: %s', (_, sides, options) => {
    expect(floorOf(sides, options)).toBeLessThan(0.02);
  });

  test('is open outside where its fronts alone are drawn', () => {
    expect(floorOf(FRONT)).toBeLessThan(0.02);
  });

  test('is shadowed by what stands in it', () => {
    const room = meshOf(new BoxGeometry(1, 1, 1, 4, 4, 4), { sides: 'back' });
    room.occluding.fill(BACK);
    const table = meshOf(new BoxGeometry(0.6, 0.05, 0.6).translate(0, -0.4, 0));
    const [floor] = bakeOf([room, table], 64).occlusions;
    expect(largest(floor)).toBeGreaterThan(0.35);
  });
});

describe('both sides', () => {
  /** The occlusion of front and back of each vertex of each mesh. */
  const sidesOf = (...meshes: OcclusionMesh[]): [front: number[], back: number[]][] => {
    const scene = finish(startOcclusion({ meshes }));
    const { occlusions } = finish(addDirections({ scene, pairs: pairsFrom(0, 64) }));
    return occlusions.map((values) => [sideOf(values, false), sideOf(values, true)]);
  };
  const box = () => new BoxGeometry(1, 1, 1, 4, 4, 4);
  const bowl = () => new SphereGeometry(1, 32, 16, 0, 2 * Math.PI, Math.PI / 2, Math.PI / 2);
  const mirrored = new Matrix4().makeScale(-1, 1, 1).toArray();

  test.each<[string, BufferGeometry, Partial<OcclusionMesh>, limits: [front: number[], back: number[]]]>([
    [
      'a closed box',
      box(),
      {},
      [
        [0, 0],
        [0.98, 1],
      ],
    ],
    [
      'a mirrored closed box',
      box(),
      { toWorld: mirrored },
      [
        [0, 0],
        [0.98, 1],
      ],
    ],
    [
      'a bowl',
      bowl(),
      {},
      [
        [0, 0.03],
        [0.4, 0.6],
      ],
    ],
    [
      'a sheet',
      new PlaneGeometry(1, 1, 8, 8),
      {},
      [
        [0, 0],
        [0, 0],
      ],
    ],
  ])('%s: outside and inside each have their own', (_, geometry, options, [front, back]) => {
    const [[fronts, backs]] = sidesOf(meshOf(geometry, { ...options, sides: 'both' }));
    for (const [values, [least, most]] of [
      [fronts, front],
      [backs, back],
    ] as const) {
      const inner = mean(values);
      expect(inner).toBeGreaterThanOrEqual(least);
      expect(inner).toBeLessThanOrEqual(most);
    }
  });

  test('each is what a bake of that side alone gives, to half a level', () => {
    const [floor, wall] = corner();
    const bakeOfSide = (sides: 'front' | 'back') => bakeOf([meshOf(floor, { sides }), meshOf(wall, { sides })], 64);
    const alone = [bakeOfSide('front'), bakeOfSide('back')];
    for (const [mesh, both] of sidesOf(meshOf(floor, { sides: 'both' }), meshOf(wall, { sides: 'both' })).entries()) {
      for (const [side, values] of both.entries()) {
        const errors = values.map((value, i) => Math.abs(value - alone[side].occlusions[mesh][i]));
        expect(largest(errors)).toBeLessThan(0.5 / 180 + 1e-4);
      }
    }
  });

  test('they change nothing where one side is drawn', () => {
    const ground = meshOf(new PlaneGeometry(400, 400).rotateX(-Math.PI / 2).translate(0, -0.01, 0));
    const [floor, wall] = corner();
    const oneSided = () => meshOf(floor, { sides: 'front' });
    const [before] = bakeOf([oneSided(), meshOf(wall, { sides: 'front' }), ground], 32).occlusions;
    const [after] = bakeOf([oneSided(), meshOf(wall, { sides: 'both' }), ground], 32).occlusions;
    expect(after).toEqual(before);
  });
});

test('two levels of occlusion survive in one component, whatever they are; a missing attribute has none', () => {
  const wrong: number[][] = [];
  for (let front = 0; front <= 180; front++) {
    for (let back = 0; back <= 180; back++) {
      const packed = packedSides(front / 180, back / 180);
      const [one, other] = [false, true].map((isBack) => occlusionOf(packed / 32767, isBack));
      if (!(packed < 32767 && one === front / 180 && other === back / 180)) wrong.push([front, back]);
    }
  }
  expect(wrong).toEqual([]);
  for (const isBack of [false, true]) {
    expect(occlusionOf(1, isBack)).toBe(0);
    expect(occlusionOf(packedSide(0.4321) / 32767, isBack)).toBeCloseTo(0.4321, 4);
  }
});

describe('meshes', () => {
  const below = () => meshOf(new PlaneGeometry(1, 1, 2, 2));
  const roof = (options: Partial<OcclusionMesh> = {}) => meshOf(new PlaneGeometry(9, 9).translate(0, 0, 0.5), options);

  test('occlude from both sides, with or without normals', () => {
    const [front, back, mute] = [
      roof(),
      meshOf(new PlaneGeometry(9, 9).rotateX(Math.PI).translate(0, 0, 0.5)),
      roof({ normals: null }),
    ].map((one) => bakeOf([below(), one], 32).occlusions);
    expect(mean(front[0])).toBeGreaterThan(0.9);
    expect(back[0]).toEqual(front[0]);
    expect(mute).toEqual([front[0]]);
  });

  test('turned inside out show their backs', () => {
    const [values] = bakeOf([meshOf(new BoxGeometry(1, 1, 1, 4, 4, 4), { sides: 'back' })], 32).occlusions;
    expect(Math.min(...values)).toBeGreaterThan(0.98);
  });

  test('are transformed by their matrices, normals too, even mirrored or squeezed ones', () => {
    const matrix = new Matrix4().makeScale(-1, 2, 0.5).premultiply(new Matrix4().makeRotationX(1)).setPosition(3, 4, 5);
    const moved = matrix.toArray();
    const stays = [below(), roof()];
    const made = stays.map((mesh) => ({
      ...mesh,
      positions: Float32Array.from(mesh.positions, (_, i) =>
        [0, 4, 8].reduce(
          (sum, column, k) => sum + moved[column + (i % 3)] * mesh.positions[i - (i % 3) + k],
          moved[12 + (i % 3)],
        ),
      ),
      normals: Float32Array.from(mesh.normals!, (_, i) => [0, -Math.sin(1), Math.cos(1)][i % 3]),
    }));
    const expected = bakeOf(made, 32).occlusions;
    const values = bakeOf(
      stays.map((mesh) => ({ ...mesh, toWorld: moved })),
      32,
    ).occlusions;
    expect(mean(values[0])).toBeGreaterThan(0.9);
    for (const [i, value] of values[0].entries()) expect(value).toBeCloseTo(expected[0][i], 2);
  });

  test('a wide ground does not blur the objects on it', () => {
    const [floor, wall] = corner();
    const ground = meshOf(new PlaneGeometry(400, 400).rotateX(-Math.PI / 2).translate(0, -0.01, 0));
    const { occlusions, scene } = bakeOf([meshOf(floor), meshOf(wall), ground], 64);
    // Two places stand for each corner of the two triangles of the ground.
    expect(scene.views.map(({ samples }) => samples.length)).toEqual([65 * 129 + 129 * 33, 4 + 2 * 6]);
    const [alone] = bakeOf([meshOf(floor), meshOf(wall)], 64).occlusions;
    expect(mean(occlusions[0].map((value, i) => Math.abs(value - alone[i])))).toBeLessThan(0.01);
    expect(largest(occlusions[2])).toBe(0);
  });
});

test('continues where it stopped: the same directions give the same result at once and in parts', () => {
  const [floor, wall] = corner();
  const whole = bakeOf([meshOf(floor), meshOf(wall)], 24);
  const part = bakeOf([meshOf(floor), meshOf(wall)], 8);
  const { occlusions } = finish(addDirections({ scene: part.scene, pairs: pairsFrom(8, 16) }));
  expect(occlusions.map(frontsOf)).toEqual(whole.occlusions);
});

test('sums of another copy of the scene are added like directions', () => {
  const meshes = () => corner().map((geometry) => meshOf(geometry));
  const whole = bakeOf(meshes(), 24);
  const { scene } = bakeOf(meshes(), 8);
  const other = finish(startOcclusion({ meshes: meshes() }));
  const { sums } = finish(addDirections({ scene: other, pairs: pairsFrom(8, 16) })).scene;
  const { occlusions } = finish(addDirections({ scene, pairs: [], sums: [sums] }));
  const errors = occlusions.flatMap((values, mesh) =>
    frontsOf(values).map((value, i) => Math.abs(value - whole.occlusions[mesh][i])),
  );
  expect(largest(errors)).toBeLessThan(1e-4);
});
