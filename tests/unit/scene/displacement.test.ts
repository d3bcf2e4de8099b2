import {
  BatchedMesh,
  BoxGeometry,
  type BufferGeometry,
  DataTexture,
  Group,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  RepeatWrapping,
  Texture,
  Vector3,
} from 'three';
import { expect, test } from 'vitest';
import { applyHatching } from '../../../src/scene/applyHatching.js';

const options = { tonalArtMap: null, outlines: true, material: { technique: 'hatching' } } as const;
const SIZE = 8;

/** A picture that rises from 0 on the left to 1 on the right. */
function slope(): DataTexture {
  const data = new Uint8Array(4 * SIZE * SIZE);
  for (let i = 0; i < data.length; i++) data[i] = (255 * ((i >> 2) % SIZE)) / (SIZE - 1);
  return new DataTexture(data, SIZE, SIZE);
}

const terrain = (map: Texture, material = {}): Mesh<BufferGeometry, MeshStandardMaterial> =>
  new Mesh<BufferGeometry, MeshStandardMaterial>(
    new PlaneGeometry(2, 2, 16, 16),
    new MeshStandardMaterial({ displacementMap: map, displacementScale: 1.5, displacementBias: -0.25, ...material }),
  );

/** The height of a terrain over a place. */
function heightAt({ attributes: { position } }: BufferGeometry, x: number): number {
  for (let i = 0; i < position.count; i++) if (Math.abs(position.getX(i) - x) < 1e-6) return position.getZ(i);
  throw new Error(`Nothing lies over ${x}.`);
}

test('heights of a map are in the geometry that is hatched, with the slopes they make, and gone with the look', async () => {
  const mesh = terrain(slope());
  const flat = mesh.geometry;
  const hatched = await applyHatching(new Group().add(mesh), options);
  expect(hatched.skipped).toEqual([]);
  expect(heightAt(mesh.geometry, -1)).toBeCloseTo(-0.25, 5);
  expect(heightAt(mesh.geometry, 0)).toBeCloseTo(0.5, 2);
  expect(heightAt(mesh.geometry, 1)).toBeCloseTo(1.25, 5);
  // Between the centres of the pixels next to the edges it rises by 1.5 over 2 times 7/8.
  const middle = [...Array(mesh.geometry.attributes.normal.count).keys()].find(
    (i) => Math.abs(mesh.geometry.attributes.position.getX(i)) < 1e-6,
  )!;
  const normal = new Vector3().fromBufferAttribute(mesh.geometry.attributes.normal as never, middle);
  expect(normal.x / normal.z).toBeCloseTo(-1.5 / 1.75, 1);
  hatched.restore();
  expect(mesh.geometry).toBe(flat);
  expect(heightAt(flat, 1)).toBe(0);
});

test('a map is turned and repeated as its texture says, and meshes that share all share the result', async () => {
  const map = slope();
  map.wrapS = RepeatWrapping;
  map.offset.x = 0.5;
  const [mesh, other] = [terrain(map), terrain(map)];
  other.geometry = mesh.geometry;
  other.material = mesh.material;
  await applyHatching(new Group().add(mesh, other), options);
  expect(heightAt(mesh.geometry, -1)).toBeCloseTo(0.5, 1);
  expect(other.geometry).toBe(mesh.geometry);
});

test('of several materials each displaces its own triangles', async () => {
  const mesh = terrain(slope()) as unknown as Mesh<BufferGeometry, MeshStandardMaterial[]>;
  mesh.material = [mesh.material as unknown as MeshStandardMaterial, new MeshStandardMaterial()];
  const { count } = mesh.geometry.index!;
  mesh.geometry.addGroup(0, count / 2, 0);
  mesh.geometry.addGroup(count / 2, count / 2, 1);
  await applyHatching(new Group().add(mesh), options);
  const { position } = mesh.geometry.attributes;
  const raised = [...Array(position.count).keys()].filter((i) => position.getZ(i) !== 0).map((i) => position.getY(i));
  expect(Math.min(...raised)).toBeCloseTo(0);
  expect(Math.max(...raised)).toBeCloseTo(1);
});

test('what cannot be displaced is left as it is, with the reason', async () => {
  const unread = terrain(new Texture());
  const bare = terrain(slope());
  bare.geometry.deleteAttribute('uv');
  const batch = new BatchedMesh(1, 100, 100, unread.material);
  batch.addInstance(batch.addGeometry(new BoxGeometry()));
  const { skipped } = await applyHatching(new Group().add(terrain(slope()), unread, bare, batch), options);
  expect(skipped.map(({ reason }) => reason)).toEqual([
    expect.stringMatching(/pixels of its displacementMap cannot be read here/),
    expect.stringMatching(/displacementMap has no texture coordinates/),
    expect.stringMatching(/displacementMap would move all geometries of the batch/),
  ]);
});
