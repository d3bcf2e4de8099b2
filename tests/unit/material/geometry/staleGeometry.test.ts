import { BufferAttribute, type BufferGeometry, SphereGeometry } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { isStale } from '../../../../src/material/geometry/staleGeometry.js';
import { reactive } from './reactive.js';

const prepare = (layout: 'corner' | 'pull' | 'indexed') => prepareHatchingGeometry(new SphereGeometry(), { layout });

/** Replaces the positions of a geometry. */
function exchangePositions(geometry: BufferGeometry, change: (x: number, i: number) => number): void {
  const { array } = geometry.attributes.position;
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(array, change), 3));
}

describe.each(['corner', 'pull', 'indexed'] as const)('positions of the layout %s', (layout) => {
  test('are those of the bake, also in clones, behind a proxy and in an equal array', async () => {
    const geometry = await prepare(layout);
    for (const same of [geometry, geometry.clone(), reactive(geometry), reactive(geometry.clone())]) {
      expect(isStale(same)).toBe(false);
      exchangePositions(same, (x) => x);
      expect(isStale(same)).toBe(false);
    }
  });

  test('differ once they are replaced, also in a clone before its first use', async () => {
    const geometry = await prepare(layout);
    for (const other of [geometry.clone(), geometry, geometry.clone()]) {
      exchangePositions(other, (x, i) => (i === 4 ? x + 0.01 : x));
      expect(isStale(other)).toBe(true);
      expect(isStale(other)).toBe(true);
    }
  });

  test('differ in a clone of a changed geometry', async () => {
    const geometry = await prepare(layout);
    expect(isStale(geometry.translate(0, 1, 0).clone())).toBe(true);
  });

  test('differ if there are fewer or more', async () => {
    const geometry = await prepare(layout);
    const { array } = geometry.attributes.position;
    for (const other of [array.slice(0, 30), Float32Array.of(...array, 0, 0, 0)]) {
      const clone = geometry.clone();
      clone.setAttribute('position', new BufferAttribute(other, 3));
      expect(isStale(clone)).toBe(true);
    }
  });
});

test('reordered vertices keep their stroke normals', async () => {
  const merged = mergeVertices(await prepare('indexed'));
  expect(isStale(merged)).toBe(false);
});

test('a geometry without a known bake counts as fresh at first use', async () => {
  const loaded = (await prepare('corner')).clone();
  loaded.userData = structuredClone(loaded.userData);
  exchangePositions(loaded, (x) => x + 1);
  expect(isStale(loaded)).toBe(false);
  exchangePositions(loaded, (x) => x + 1);
  expect(isStale(loaded)).toBe(true);
});

test.each([undefined, null, 5, 'none'])('a geometry with %s for statistics is not judged', async (hatching) => {
  const geometry = (await prepare('corner')).translate(1, 0, 0);
  geometry.userData = { hatching };
  expect(isStale(geometry)).toBe(false);
});
