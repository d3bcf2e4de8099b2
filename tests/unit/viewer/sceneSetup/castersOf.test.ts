import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { castersOf } from '../../../../src/viewer/sceneSetup/groundShadow.js';

const box = (size: readonly [number, number, number], parameters = {}): Mesh =>
  new Mesh(new BoxGeometry(...size), new MeshBasicMaterial(parameters));

/** Pieces as x, z and both heights. */
function piecesOf(...meshes: Mesh[]): number[][] {
  const casters = castersOf(new Group().add(...meshes));
  return Array.from({ length: casters.length / 4 }, (_, i) => [...casters.subarray(4 * i, 4 * i + 4)]);
}

describe('what casts shadows', () => {
  test('is a post from its foot to its top, of however few triangles', () => {
    const post = box([0.01, 1.8, 0.01]);
    const pieces = piecesOf(post);
    expect(pieces.length).toBeLessThanOrEqual(4);
    for (const [x, z, low, high] of pieces) {
      expect(Math.hypot(x, z)).toBeLessThan(0.05);
      expect(low).toBeCloseTo(-0.9, 6);
      expect(high).toBeCloseTo(0.9, 6);
    }
  });

  test('is each edge of a slanted bar, without a gap in its heights', () => {
    const bar = box([0.01, 1.6, 0.01]);
    bar.rotation.z = 0.9;
    const heights = piecesOf(bar).sort((a, b) => a[2] - b[2]);
    let top = heights[0][3];
    for (const [, , low, high] of heights) {
      expect(low).toBeLessThan(top + 1e-6);
      top = Math.max(top, high);
    }
  });

  test('excludes hidden, unused and see-through parts', () => {
    const hidden = box([1, 1, 1]);
    hidden.visible = false;
    const inner = box([1, 1, 1]);
    const holder = new Mesh().add(inner);
    holder.visible = false;
    expect(piecesOf(hidden, holder, box([1, 1, 1], { visible: false }), box([1, 1, 1], { transparent: true }))).toEqual(
      [],
    );
    expect(piecesOf(box([1, 1, 1]))).not.toEqual([]);
  });

  test('includes each instance; points far outside count in the outermost cells, and NaN ones are ignored', () => {
    const instances = new InstancedMesh(new BoxGeometry(0.01, 0.5, 0.01), new MeshBasicMaterial(), 3);
    for (const [i, x] of [-0.5, 9, Number.NaN].entries())
      instances.setMatrixAt(i, new Matrix4().makeTranslation(x, 0, 0));
    const places = piecesOf(instances).map(([x]) => x);
    expect(Math.min(...places)).toBeCloseTo(-0.5, 1);
    expect(Math.max(...places)).toBeCloseTo(1.25, 1);
    expect(places.every(Number.isFinite)).toBe(true);
  });

  test('is each edge of a small mesh beside a large one, of which some triangles are left out', () => {
    const plane = new Mesh(new PlaneGeometry(1.6, 1.6, 500, 500), new MeshBasicMaterial());
    const post = box([0.01, 1.8, 0.01]);
    post.position.z = 0.5;
    const pieces = piecesOf(plane, post);
    const ofPost = pieces.filter(([, z]) => z > 0.4);
    expect(Math.min(...ofPost.map(([, , low]) => low))).toBeCloseTo(-0.9, 6);
    expect(Math.max(...ofPost.map(([, , , high]) => high))).toBeCloseTo(0.9, 6);
    const tops = pieces.filter(([, z]) => z < 0.4).map(([, , , high]) => high);
    expect(tops.length).toBeGreaterThan(30);
    expect(Math.min(...tops)).toBeGreaterThan(0.75);
  });
});
