import { BoxGeometry, type Mesh, Plane, SphereGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

const SHEET = { sheet: [60, 60] as const, margin: 0 };
const draw = (mesh: Mesh, options: DrawSVGOptions = {}) =>
  drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), { ...SHEET, ...options });

/** Clips everything left of the middle. */
const RIGHT_ALONE = () => new Plane(new Vector3(1, 0, 0), 0);
const UPPER_ALONE = () => new Plane(new Vector3(0, 1, 0), 0);

const numbersOf = (svg: string, axis: number): number[] =>
  pathsOf(svg, 'lines').flatMap((data) => ringsOf(data).flatMap((ring) => ring.filter((_, i) => i % 2 === axis)));

describe('clipping planes', () => {
  test('of a material: a box has neither lines nor outlines beyond them', async () => {
    const mesh = await hatchedMesh(new BoxGeometry(1.2, 1.2, 1.2), {
      material: { composition: { exposure: 1 }, direction: 'slant' },
    });
    mesh.rotation.set(0.4, 0.5, 0);
    const whole = await draw(mesh, { kind: 'pen' });
    expect(Math.min(...numbersOf(whole.svg, 0))).toBeLessThan(15);
    mesh.material.clippingPlanes = [RIGHT_ALONE()];
    (mesh.children[0] as Mesh).material = Object.assign((mesh.children[0] as Mesh<never>).material, {
      clippingPlanes: [RIGHT_ALONE()],
    });
    const { svg, leftOut } = await draw(mesh, { kind: 'pen' });
    expect(leftOut).toEqual([]);
    const across = pathsOf(svg).flatMap((data) => ringsOf(data).flatMap((ring) => ring.filter((_, i) => i % 2 === 0)));
    // The file rounds to hundredths of a millimetre.
    expect(Math.min(...across)).toBeGreaterThan(29.98);
    expect(Math.min(...across)).toBeLessThan(30.2);
    expect(pathsOf(svg, 'outlines').length).toBeGreaterThan(2);
  });

  test('of the drawing clip everything, and are checked', async () => {
    const mesh = await planeOfTone(0.5);
    const { svg } = await draw(mesh, { clippingPlanes: [UPPER_ALONE()] });
    expect(coverageOf(pathsOf(svg), [6, 6, 48, 23.4])).toBeCloseTo(0.5, 1);
    expect(coverageOf(pathsOf(svg), [6, 30.5, 48, 24])).toBe(0);
    await expect(draw(mesh, { clippingPlanes: ['x' as never] })).rejects.toThrow(
      'drawSVG: clippingPlanes must be a list of Planes of three.js, or left out.',
    );
  });

  test('with clipIntersection cut only what lies beyond all of them', async () => {
    const mesh = await planeOfTone(0.5);
    mesh.material.clippingPlanes = [RIGHT_ALONE(), UPPER_ALONE()];
    const quarters = async (): Promise<boolean[]> => {
      const { svg } = await draw(mesh);
      return [
        [33, 3],
        [3, 3],
        [33, 33],
        [3, 33],
      ].map(([left, top]) => coverageOf(pathsOf(svg), [left, top, 24, 24]) > 0.1);
    };
    expect(await quarters()).toEqual([true, false, false, false]);
    mesh.material.clipIntersection = true;
    expect(await quarters()).toEqual([true, true, true, false]);
  });

  test('what is clipped hides nothing, and casts its shadow unless shadows are clipped too', {
    tags: ['all'],
  }, async () => {
    const wall = await planeOfTone(0, { toneCurve: 'linear', composition: { exposure: 1 } });
    const ball = await hatchedMesh(new SphereGeometry(0.5, 24, 16), { outlines: false, material: { ink: 'red' } });
    ball.position.z = 0.7;
    ball.material.clippingPlanes = [new Plane(new Vector3(0, 0, -1), -5)];
    wall.receiveShadow = ball.castShadow = true;
    const scene = sceneOf(wall, ball);
    scene.children[0].castShadow = true;
    const inkOf = async (shadows: boolean) =>
      (await drawSVG(scene, cameraAt(0, 0, 1), { sheet: [30, 30], margin: 0, kind: 'pen', shadows })).drawn;
    const without = await inkOf(false);
    expect(await inkOf(true)).toBeGreaterThan(without + 18);
    ball.material.clipShadows = true;
    expect(await inkOf(true)).toBe(without);
  });

  test('lines inside of a cut body are seen through the cut where no other triangle lies before them', {
    tags: ['all'],
  }, async () => {
    const mesh = await hatchedMesh(new SphereGeometry(0.9, 32, 24), {
      outlines: false,
      material: { composition: { exposure: 1 }, side: 2 },
    });
    mesh.material.clippingPlanes = [new Plane(new Vector3(0, 0, -1), 0.2)];
    const { svg } = await draw(mesh);
    expect(coverageOf(pathsOf(svg), [24, 24, 12, 12])).toBeGreaterThan(0.05);
  });
});

describe('flat faces', () => {
  const facetted = (look: object) =>
    hatchedMesh(new SphereGeometry(0.9, 8, 6), {
      outlines: false,
      material: { composition: { exposure: 1 }, direction: 'z', irregularity: 0, crossFrom: 1, ...look },
    });

  test('have one tone each, by either property', async () => {
    const [smooth, face, flat] = await Promise.all([
      facetted({}),
      facetted({ toneNormal: 'face' }),
      facetted({ flatShading: true }),
    ]);
    const [one, other, third] = [await draw(smooth), await draw(face), await draw(flat)];
    expect(other.leftOut).toEqual([]);
    expect(third.svg).toBe(other.svg);
    expect(other.svg).not.toBe(one.svg);
    // A body with face normals as attributes gives the same, except for the positions of lines.
    const hard = await hatchedMesh(new SphereGeometry(0.9, 8, 6).toNonIndexed(), {
      outlines: false,
      material: { composition: { exposure: 1 }, direction: 'z', irregularity: 0, crossFrom: 1 },
    });
    hard.geometry.computeVertexNormals();
    const box = [18, 18, 24, 24] as const;
    const tones = [other, await draw(hard)].map(({ svg }) => coverageOf(pathsOf(svg), box));
    expect(Math.abs(tones[0] - tones[1])).toBeLessThan(0.01);
  });

  test('of a plane look like the plane', { tags: ['all'] }, async () => {
    const [plain, flat] = await Promise.all([planeOfTone(0.4), planeOfTone(0.4, { toneNormal: 'face' })]);
    // Points on edges of triangles are written twice.
    expect((await draw(flat)).drawn / (await draw(plain)).drawn).toBeCloseTo(1, 2);
  });
});
