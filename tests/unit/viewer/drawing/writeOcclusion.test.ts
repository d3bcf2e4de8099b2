import { IcosahedronGeometry, type Mesh } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { expect, test } from 'vitest';
import { occlusionOf } from '../../../../src/mesh/occlusion/occlusionSides.js';
import { bakeMesh } from '../../../../src/viewer/drawing/bakeMesh.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { modelOfMesh, writeOcclusion } from '../../../../src/viewer/drawing/modelOfMesh.js';
import type { PlainMesh } from '../../../../src/viewer/files/mesh/PlainMesh.js';

const OPTIONS = { signal: new AbortController().signal, onProgress: () => {} };

function someMesh(): PlainMesh & { indices: Uint32Array } {
  const sphere = new IcosahedronGeometry(1, 1);
  for (const name of ['uv', 'normal']) sphere.deleteAttribute(name);
  const { attributes, index } = mergeVertices(sphere);
  const positions = Float32Array.from(attributes.position.array);
  return { positions, indices: Uint32Array.from(index!.array), normals: null, colors: null };
}

/** A byte that tells where a vertex lies. */
const byteOf = (x: number, y: number): number => Math.round(100 + 60 * x + 30 * y);

const bytesOf = ({ positions }: PlainMesh): Uint8Array<ArrayBuffer> =>
  Uint8Array.of(1, ...verticesOf(positions).map(([x, y]) => byteOf(x, y)));

const verticesOf = (positions: Float32Array): number[][] =>
  Array.from({ length: positions.length / 3 }, (_, i) => Array.from(positions.subarray(3 * i, 3 * i + 3)));

function expectWritten({ geometry }: Pick<Mesh, 'geometry'>): void {
  const { position, hatchNormal } = geometry.attributes;
  for (let i = 0; i < position.count; i++)
    expect(-255 * hatchNormal.getW(i)).toBeCloseTo(byteOf(position.getX(i), position.getY(i)), 1);
}

test('precomputed occlusion is written to every corner of its vertex', async () => {
  const mesh = someMesh();
  const model = await modelOfMesh(mesh, OPTIONS, { occlusion: bytesOf(mesh) });
  expect(model.isOccluded).toBe(true);
  expectWritten(meshesOf(model.root)[0]);
});

test('it is also written to shared vertices', async () => {
  const mesh = someMesh();
  const { geometry } = await bakeMesh(mesh, OPTIONS);
  const shared = mergeVertices(geometry.clone());
  expect(shared.index).not.toBeNull();
  writeOcclusion(shared, mesh, bytesOf(mesh));
  expectWritten({ geometry: shared });
});

test('a corner may differ from its vertex', async () => {
  const mesh = someMesh();
  const { geometry } = await bakeMesh(mesh, OPTIONS);
  writeOcclusion(geometry, mesh, Uint8Array.of(...bytesOf(mesh), 7, 0, 0, 255, 59, 0, 0, 3));
  const { hatchNormal, position } = geometry.attributes;
  expect(hatchNormal.getW(7)).toBeCloseTo(-1, 4);
  expect(hatchNormal.getW(59)).toBeCloseTo(-3 / 255, 4);
  expect(-255 * hatchNormal.getW(8)).toBeCloseTo(byteOf(position.getX(8), position.getY(8)), 1);
});

test('a surface that is drawn from both sides has two bytes for each vertex and corner', async () => {
  const mesh = someMesh();
  const { geometry } = await bakeMesh(mesh, OPTIONS);
  const bytes = verticesOf(mesh.positions).flatMap(([x, y]) => [byteOf(x, y), byteOf(y, x)]);
  writeOcclusion(geometry, mesh, Uint8Array.of(2, ...bytes, 7, 0, 0, 255, 51));
  const { hatchNormal, position } = geometry.attributes;
  const sidesOf = (vertex: number): number[] =>
    [false, true].map((isBack) => 255 * occlusionOf(hatchNormal.getW(vertex), isBack));
  for (let i = 0; i < position.count; i++) {
    const [x, y] = [position.getX(i), position.getY(i)];
    const expected = i === 7 ? [255, 51] : [byteOf(x, y), byteOf(y, x)];
    // The geometry keeps 181 levels of each.
    for (const [side, byte] of sidesOf(i).entries()) expect(Math.abs(byte - expected[side])).toBeLessThan(0.75);
  }
});

test('an incomplete file is not taken', async () => {
  const mesh = someMesh();
  const model = await modelOfMesh(mesh, OPTIONS, { occlusion: bytesOf(mesh).subarray(0, -1) });
  expect(model.isOccluded).toBe(false);
  expect(meshesOf(model.root)[0].geometry.attributes.hatchNormal.getW(0)).toBe(0);
});
