import {
  BackSide,
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  DirectionalLight,
  DoubleSide,
  Mesh,
  PlaneGeometry,
  Scene,
  type Side,
  SphereGeometry,
} from 'three';
import { fitExposure, HatchingMaterial } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { relativeOcclusion } from '../../../../src/look/relativeOcclusion.js';

/** A mesh with a baked occlusion on its front. */
function baked(geometry: BufferGeometry, occlusion: number, side?: Side): Mesh {
  const { count } = geometry.attributes.position;
  const values = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 3 ? -occlusion : 0));
  geometry.setAttribute('hatchNormal', new BufferAttribute(values, 4));
  return new Mesh(
    geometry,
    new HatchingMaterial({ composition: { exposure: 'fit' }, ...(side !== undefined && { side }) }),
  );
}

function floor(occlusion: number, width = 6): Mesh {
  const mesh = baked(new PlaneGeometry(width, 4), occlusion);
  mesh.rotation.x = -Math.PI / 2;
  return mesh;
}

function wall(occlusion: number): Mesh {
  const mesh = baked(new PlaneGeometry(6, 3), occlusion, DoubleSide);
  mesh.position.set(0, 1.5, -2);
  return mesh;
}

const openOf = (...meshes: Mesh[]): number =>
  fitExposure(new Scene().add(...meshes, new DirectionalLight())).openOcclusion;

describe('the occlusion that counts as open', () => {
  test('is that of the floor in a room, whatever the walls', () => {
    expect(openOf(floor(0.6), wall(0.8))).toBeCloseTo(0.6, 2);
    expect(openOf(floor(0.6), wall(0.2), baked(new BoxGeometry(1, 1, 1), 0.7))).toBeCloseTo(0.6, 2);
  });

  test('is 0 in a bowl, on a table in the open, and for a body whose underside is hidden', () => {
    const bowl = new SphereGeometry(1, 64, 32, 0, 2 * Math.PI, Math.PI / 2, Math.PI / 2);
    expect(openOf(baked(bowl, 0.6, BackSide))).toBe(0);
    expect(openOf(floor(0.1), baked(new BoxGeometry(2, 0.1, 1), 0.2))).toBe(0);
    expect(openOf(baked(new SphereGeometry(1), 0.2))).toBe(0);
  });

  test('rises from 0 without a jump', () => {
    const opens = [0.28, 0.3, 0.32, 0.36, 0.42, 0.45, 0.5].map((occlusion) => openOf(floor(occlusion)));
    expect(opens.slice(0, 2)).toEqual([0, 0]);
    expect(opens[2]).toBeGreaterThan(0);
    expect(opens[2]).toBeLessThan(0.05);
    expect(opens).toEqual([...opens].sort((a, b) => a - b));
    expect(opens.at(-1)).toBeCloseTo(0.5, 2);
  });

  test('is 0 for a wall with a small shelf in a niche', () => {
    expect(openOf(wall(0.1), baked(new BoxGeometry(1, 0.1, 0.2), 0.6))).toBe(0);
  });

  test('is 0 where a room stands on open land', () => {
    expect(openOf(floor(0.58), wall(0.58), floor(0, 20))).toBe(0);
  });
});

/** A board of 1, upright, with a baked occlusion on its front. Boards lie apart. */
function board(occlusion: number, width: number, at: number, cells = 64): Mesh {
  const mesh = baked(new PlaneGeometry(width, 1, cells, cells), occlusion);
  mesh.position.set(at, 0, 0);
  return mesh;
}

describe('where much that is seen lies in deep hollows', () => {
  const outside = board(0, 1, 0);

  test('hardly any of it stays darker than a shallow hollow', () => {
    // Of what is seen the hollows are (1 − 0.8) · 3 and (1 − 0.99) · 1, beside 1: 0.37 and 0.006.
    const open = openOf(outside, board(0.8, 3, 5), board(0.99, 1, 10));
    expect(relativeOcclusion(0.8, open)).toBeCloseTo(0.3, 2);
    expect(relativeOcclusion(0.99, open)).toBeGreaterThan(0.95);
    expect(relativeOcclusion(0, open)).toBe(0);
  });

  test('a few deep hollows, many shallow ones, and the hidden inside of a closed body stay as they are', () => {
    expect(openOf(outside, board(0.8, 0.5, 5))).toBe(0);
    expect(openOf(outside, board(0.6, 9, 5))).toBe(0);
    expect(openOf(outside, board(0.99, 10, 5))).toBe(0);
  });

  test('fewer are enough where they have large walls, and walls that nothing is seen of do not count', () => {
    // Of what is seen the niche is (1 − 0.8) · 0.4, beside 1: 0.07.
    expect(openOf(outside, board(0.8, 0.4, 5))).toBe(0);
    expect(relativeOcclusion(0.8, openOf(outside, board(0.8, 0.4, 5, 1)))).toBeCloseTo(0.3, 2);
    expect(openOf(outside, board(0.8, 0.15, 5, 1))).toBe(0);
    expect(openOf(outside, board(0.98, 3, 5, 1))).toBe(0);
  });

  test('they become lighter without a jump', () => {
    const depths = [0.58, 0.619, 0.625, 0.64, 0.66, 0.7, 0.75];
    const opens = depths.map((occlusion) => openOf(outside, board(occlusion, 9, 5)));
    expect(opens.slice(0, 2)).toEqual([0, 0]);
    expect(opens[2]).toBeGreaterThan(0);
    expect(opens[2]).toBeLessThan(0.05);
    expect(opens).toEqual([...opens].sort((a, b) => a - b));
  });

  test('what lies outside has the exposure of a body whose shade is as dark', () => {
    const scaleOf = (...meshes: Mesh[]): number => {
      const light = new DirectionalLight();
      light.position.set(0, 0, 1);
      return fitExposure(new Scene().add(...meshes, light)).scale;
    };
    const cupboard = board(0.85, 3, 5);
    const turnedAway = board(0, 3, 5);
    turnedAway.rotation.y = Math.PI;
    // If boards in hollows counted as lit, nearly nothing would be dark, and the contrast would be raised.
    const raised = scaleOf(outside, cupboard) / scaleOf(outside, turnedAway);
    expect(raised).toBeGreaterThan(0.8);
    expect(raised).toBeLessThan(1.3);
    expect(openOf(outside, cupboard)).toBeGreaterThan(0.7);
  });
});

test('no surface, no hollow', () => {
  expect(openOf()).toBe(0);
});

describe('relative occlusion', () => {
  test('is nothing up to that of the open parts, and all where nothing of the sky is seen', () => {
    expect([0, 0.4, 0.5, 0.75, 1].map((occluded) => relativeOcclusion(occluded, 0.5))).toEqual([0, 0, 0, 0.5, 1]);
  });

  test('is the baked one, to the bit, outside rooms', () => {
    for (const occluded of [0, 0.1, 1 / 3, 0.7, 1]) expect(relativeOcclusion(occluded, 0)).toBe(occluded);
  });
});
