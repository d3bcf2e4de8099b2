import { BufferGeometry, InstancedMesh, Matrix4, MeshBasicMaterial, Sphere, Vector3, Vector4 } from 'three';
import { describe, expect, test } from 'vitest';
import { OutlineData } from '../../../../src/material/geometry/OutlineData.js';
import { InstanceList } from '../../../../src/material/outlines/InstanceList.js';
import { bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { findCandidates } from '../../../../src/mesh/features/contourCandidates.js';
import { finish } from '../../mesh/meshes.js';
import { torus } from '../../mesh/shapes.js';

const packed = finish(
  bakeCorners({
    label: 'test',
    mesh: torus(40, 20),
    creaseAngle: Math.PI / 2,
    wantsNormals: false,
    attributes: [],
    outlines: { triangleGroups: null },
  }),
).outlines!;
const data = new OutlineData(packed);
const PRIMITIVES = data.triangleCount + data.edgeCount;

function instances(matrices: readonly Matrix4[]): InstancedMesh {
  const geometry = new BufferGeometry();
  geometry.boundingSphere = new Sphere(new Vector3(), packed.radius);
  const mesh = new InstancedMesh(geometry, new MeshBasicMaterial(), matrices.length);
  matrices.forEach((matrix, i) => {
    mesh.setMatrixAt(i, matrix);
  });
  return mesh;
}

/** A row of rotated and squeezed tori, away from the eye. */
const row = (count: number): InstancedMesh =>
  instances(
    Array.from({ length: count }, (_, i) =>
      new Matrix4()
        .makeRotationX(i)
        .scale(new Vector3(1, 0.7, 1.2))
        .setPosition(4 * i, 0, -30),
    ),
  );

/** The indices of the primitives of each instance. */
function listed({ texture, count }: InstanceList): Map<number, Set<number>> {
  const words = texture!.image.data as Uint32Array;
  const byInstance = new Map<number, Set<number>>();
  for (let i = 0; i < count; i++) {
    const [primitive, instance] = words.subarray(2 * i, 2 * i + 2);
    byInstance.set(instance, (byInstance.get(instance) ?? new Set()).add(primitive));
  }
  return byInstance;
}

/** The primitives that hold a contour for exactly this eye. */
function needed(mesh: InstancedMesh, instance: number, { x, y, z, w }: Vector4): number[] {
  const matrix = new Matrix4();
  mesh.getMatrixAt(instance, matrix);
  const eye = new Vector3(x, y, z).applyMatrix4(matrix.invert());
  const search = new OutlineData(packed).search!;
  return [...search.list.subarray(0, findCandidates(search, [eye.x, eye.y, eye.z, w], 0))];
}

const EYE = new Vector4(3, 1, 0, 1);

describe('what may hold an outline of any instance', () => {
  test('is listed with its instance, and little else is', () => {
    const mesh = row(10);
    const list = new InstanceList();
    expect(list.update(data, mesh, EYE)).toBe(true);
    const pairs = listed(list);
    for (let i = 0; i < 10; i++) {
      for (const primitive of needed(mesh, i, EYE)) expect(pairs.get(i)!.has(primitive)).toBe(true);
    }
    expect(list.count).toBeLessThan(0.5 * 10 * PRIMITIVES);
    expect([...(list.places!.image.data as Float32Array).subarray(0, 160)]).toEqual([
      ...(mesh.instanceMatrix.array as Float32Array),
    ]);
  });

  test('is listed for every eye position before the next list', () => {
    const mesh = row(6);
    const list = new InstanceList();
    list.update(data, mesh, EYE);
    const { texture } = list;
    const moved = EYE.clone();
    let steps = 0;
    // Different eyes: none rests, so none causes a new list.
    for (; steps < 200; steps++) {
      moved.x += 0.05;
      moved.y += 0.02;
      if (!list.update(data, mesh, moved)) break;
      expect(list.texture).toBe(texture);
      const pairs = listed(list);
      for (let i = 0; i < 6; i++) {
        for (const primitive of needed(mesh, i, moved)) expect(pairs.get(i)!.has(primitive)).toBe(true);
      }
    }
    expect(steps).toBeGreaterThan(3);
    expect(steps).toBeLessThan(200);
    // The eye rests here.
    expect(list.update(data, mesh, moved)).toBe(true);
    expect(list.texture).not.toBe(texture);
  });

  test('is every primitive of an instance around the eye, flat or not', () => {
    const mesh = instances([
      new Matrix4().setPosition(3, 1, 0.5),
      new Matrix4().makeScale(1, 0, 1).setPosition(0, 0, -30),
      new Matrix4().setPosition(0, 0, -30),
    ]);
    const list = new InstanceList();
    expect(list.update(data, mesh, EYE)).toBe(true);
    const pairs = listed(list);
    expect([pairs.get(0)!.size, pairs.get(1)!.size]).toEqual([PRIMITIVES, PRIMITIVES]);
    expect(pairs.get(2)!.size).toBeLessThan(PRIMITIVES / 2);
  });

  test('is listed for an orthographic direction, and again for another', () => {
    const mesh = row(3);
    const list = new InstanceList();
    const direction = new Vector4(0, 0, 1, 0);
    expect(list.update(data, mesh, direction)).toBe(true);
    expect(list.count).toBeLessThan(0.5 * 3 * PRIMITIVES);
    const other = new Vector4(0, 1, 0, 0);
    expect([list.update(data, mesh, other), list.update(data, mesh, other)]).toEqual([false, true]);
  });
});

describe('a list', () => {
  test('is not made while instances move, but when they rest', () => {
    const mesh = row(3);
    const list = new InstanceList();
    list.update(data, mesh, EYE);
    const { texture } = list;
    for (let i = 0; i < 3; i++) {
      mesh.instanceMatrix.needsUpdate = true;
      expect(list.update(data, mesh, EYE)).toBe(false);
      expect(list.texture).toBe(texture);
    }
    expect(list.update(data, mesh, EYE)).toBe(true);
    expect(list.texture).not.toBe(texture);
    mesh.count = 2;
    expect([list.update(data, mesh, EYE), list.update(data, mesh, EYE)]).toEqual([false, true]);
    expect([...listed(list).keys()]).toEqual([0, 1]);
  });

  test('is not made for too many primitives', () => {
    const mesh = row(1);
    mesh.count = 8_000_001;
    expect(new InstanceList().update(data, mesh, EYE)).toBe(false);
  });
});
