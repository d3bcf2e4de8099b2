import {
  type BufferGeometry,
  CapsuleGeometry,
  CatmullRomCurve3,
  ConeGeometry,
  CylinderGeometry,
  LatheGeometry,
  SphereGeometry,
  TorusGeometry,
  TubeGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';

class Circle extends CatmullRomCurve3 {
  override getPoint(t: number, target = new Vector3()): Vector3 {
    return target.set(Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t), 0);
  }
}

const closed: [string, BufferGeometry][] = [
  ['sphere', new SphereGeometry()],
  ['torus', new TorusGeometry()],
  ['capsule', new CapsuleGeometry()],
  ['cylinder with its caps', new CylinderGeometry()],
  ['cone', new ConeGeometry()],
  ['closed tube', new TubeGeometry(new Circle(), 64, 0.2, 8, true)],
  ['lathe', new LatheGeometry()],
];

describe('three’s own shapes are closed', () => {
  test.each(closed)('%s', async (_, geometry) => {
    for (const size of [1, 1e-3, 1e4]) {
      const scaled = geometry.clone().scale(size, size, size);
      const exact = (await prepareHatchingGeometry(scaled, { weldTolerance: 0 })).userData.hatching;
      const joined = (await prepareHatchingGeometry(scaled, { adjacency: true })).userData.hatching;
      expect(exact.borderEdges).toBeGreaterThan(0);
      expect(joined).toMatchObject({ borderEdges: 0, nonManifoldEdges: 0, inconsistentEdges: 0 });
    }
  });
});

test('drawn positions stay, in every layout', async () => {
  const source = new SphereGeometry();
  for (const layout of ['corner', 'pull', 'indexed'] as const) {
    const exact = await prepareHatchingGeometry(source, { layout, weldTolerance: 0 });
    const joined = await prepareHatchingGeometry(source, { layout });
    expect(joined.getAttribute('position').array).toEqual(exact.getAttribute('position').array);
  }
});

test('stroke normals and added normals are the same on both sides of the seam', async () => {
  const source = new SphereGeometry(1, 16, 8).deleteAttribute('normal');
  const prepared = await prepareHatchingGeometry(source, { layout: 'indexed' });
  for (const name of ['hatchNormal', 'normal']) {
    const normals = prepared.getAttribute(name);
    for (let row = 1; row < 8; row++) {
      const [first, last] = [17 * row, 17 * row + 16];
      for (const get of ['getX', 'getY', 'getZ'] as const) expect(normals[get](last)).toBe(normals[get](first));
    }
  }
});
