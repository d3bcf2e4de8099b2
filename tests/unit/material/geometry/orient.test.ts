import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  Float16BufferAttribute,
  Int8BufferAttribute,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';

/** Exchanges corners of some triangles of an indexed geometry. */
function turned(geometry: BufferGeometry, isTurned: (triangle: number) => boolean): BufferGeometry {
  const index = geometry.index!;
  for (let triangle = 0; triangle < index.count / 3; triangle++) {
    if (!isTurned(triangle)) continue;
    const [b, c] = [index.getX(3 * triangle + 1), index.getX(3 * triangle + 2)];
    index.setX(3 * triangle + 1, c);
    index.setX(3 * triangle + 2, b);
  }
  return geometry;
}

/** The least cosines between the normals of triangles, those of their corners, and the way out of a body around the origin. */
function facing({ index, attributes: { position, normal } }: BufferGeometry): { faces: number; normals: number } {
  let faces = 1;
  let normals = 1;
  const count = index?.count ?? position.count;
  for (let corner = 0; corner < count; corner += 3) {
    const vertices = [0, 1, 2].map((k) => (index ? index.getX(corner + k) : corner + k));
    const [a, b, c] = vertices.map((vertex) => new Vector3().fromBufferAttribute(position, vertex));
    const area = b.clone().sub(a).cross(c.clone().sub(a));
    if (area.length() < 1e-9) continue;
    const out = a.clone().add(b).add(c).normalize();
    faces = Math.min(faces, area.normalize().dot(out));
    for (const vertex of vertices)
      normals = Math.min(normals, new Vector3().fromBufferAttribute(normal, vertex).dot(area));
  }
  return { faces, normals };
}

describe('orient', () => {
  test.each(['indexed', 'corner', 'pull'] as const)(
    'turns triangles with their normals in layout %s',
    async (layout) => {
      for (const isTurned of [() => true, (triangle: number) => triangle % 3 === 0]) {
        const source = turned(new SphereGeometry(1, 24, 12), isTurned);
        const prepared = await prepareHatchingGeometry(source, { layout, orient: true, outlines: true });
        const { faces, normals } = facing(prepared);
        expect(faces).toBeGreaterThan(0.9);
        expect(normals).toBeGreaterThan(0.9);
        const all = Array.from({ length: source.index!.count / 3 }, (_, i) => i).filter(isTurned).length;
        // Those without an area stay.
        expect(prepared.userData.hatching.turnedTriangles).toBeGreaterThan(0.9 * all);
        expect(prepared.userData.hatching.inconsistentEdges).toBe(0);
      }
    },
  );

  test('turns triangles of a geometry without an index, and normals that pointed inward', async () => {
    const source = turned(new BoxGeometry(), () => true).toNonIndexed();
    const { normal } = source.attributes;
    for (let i = 0; i < normal.count; i++) normal.setXYZ(i, -normal.getX(i), -normal.getY(i), -normal.getZ(i));
    const { faces, normals } = facing(await prepareHatchingGeometry(source, { orient: true }));
    expect([faces > 0.5, normals]).toEqual([true, 1]);
  });

  test('is off by default, and leaves a right geometry as it is', async () => {
    const wrong = await prepareHatchingGeometry(turned(new BoxGeometry(), () => true));
    expect(facing(wrong).faces).toBeLessThan(-0.5);
    expect(wrong.userData.hatching.turnedTriangles).toBe(0);
    const right = await prepareHatchingGeometry(new BoxGeometry(), { orient: true });
    const plain = await prepareHatchingGeometry(new BoxGeometry());
    expect(right.userData).toEqual(plain.userData);
    expect(right.index).toEqual(plain.index);
  });

  test('keeps groups, and the values of every corner', async () => {
    const source = turned(new BoxGeometry(1, 2, 3), (triangle) => triangle % 4 === 1);
    const count = source.attributes.position.count;
    const numbered = (size: number) => Array.from({ length: size * count }, (_, i) => i % 128);
    source.setAttribute('skinIndex', new BufferAttribute(Uint16Array.from(numbered(4)), 4));
    source.setAttribute('skinWeight', new BufferAttribute(Float32Array.from(numbered(4)), 4));
    source.morphAttributes.position = [new BufferAttribute(Float32Array.from(numbered(3)), 3)];
    source.morphTargetsRelative = true;
    const values = (geometry: BufferGeometry) => {
      const { index, attributes, morphAttributes } = geometry;
      const { uv, skinIndex, skinWeight } = attributes;
      const all = [uv, skinIndex, skinWeight, morphAttributes.position![0]];
      return Array.from({ length: geometry.attributes.position.count === 0 ? 0 : source.index!.count / 3 }, (_, i) =>
        [0, 1, 2]
          .map((k) => {
            const vertex = index ? index.getX(3 * i + k) : 3 * i + k;
            const read = all.map((one) => Array.from({ length: one.itemSize }, (_, c) => one.getComponent(vertex, c)));
            return JSON.stringify(read);
          })
          .toSorted(),
      );
    };
    for (const layout of ['indexed', 'pull'] as const) {
      const prepared = await prepareHatchingGeometry(source, { layout, orient: true });
      expect(prepared.userData.hatching.turnedTriangles).toBe(3);
      expect(values(prepared)).toEqual(values(source));
      expect(prepared.groups).toEqual(source.groups);
    }
  });

  test('reverses normals of any type, those of morph targets, and the sign of tangents', async () => {
    for (const [Type, one] of [
      [Int8BufferAttribute, 127],
      [Float16BufferAttribute, 1],
    ] as const) {
      const source = turned(new BoxGeometry(), () => true);
      const normals = Array.from(source.attributes.normal.array, (value) => -value * one);
      const float16 = new Float16BufferAttribute(new Uint16Array(normals.length), 3);
      for (let i = 0; i < normals.length; i += 3) float16.setXYZ(i / 3, normals[i], normals[i + 1], normals[i + 2]);
      const normal = Type === Int8BufferAttribute ? new Int8BufferAttribute(normals, 3, true) : float16;
      source.setAttribute('normal', normal);
      source.morphAttributes.normal = [new BufferAttribute(new Float32Array(normals.length).fill(0.25), 3)];
      source.setAttribute('tangent', new BufferAttribute(new Float32Array((4 * normals.length) / 3).fill(1), 4));
      const prepared = await prepareHatchingGeometry(source, { layout: 'indexed', orient: true });
      expect(facing(prepared).normals).toBeCloseTo(1, 2);
      expect(prepared.morphAttributes.normal![0].getX(0)).toBe(-0.25);
      const { tangent } = prepared.attributes;
      expect([tangent.getX(0), tangent.getW(0)]).toEqual([1, -1]);
    }
  });

  test('refuses what is no boolean, and bad geometries with the same words', async () => {
    await expect(prepareHatchingGeometry(new BoxGeometry(), { orient: 1 as never })).rejects.toThrow('orient is 1');
    const bad = new BoxGeometry();
    bad.index!.setX(0, 99);
    await expect(prepareHatchingGeometry(bad, { orient: true })).rejects.toThrow('corner 0 refers to vertex 99');
  });
});
