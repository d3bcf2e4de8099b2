import { BoxGeometry, Mesh, type Object3D, PlaneGeometry, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/geometry/prepareHatchingGeometry.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { drawSVG } from '../../../src/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../vector/hatchedScene.js';
import { pathsOf } from '../vector/paths.js';

const SIDE = 60;

interface Circle {
  x: number;
  y: number;
  radius: number;
}

/** The circles of a drawing. */
const circlesOf = (svg: string): Circle[] =>
  pathsOf(svg, 'stipple').flatMap((data) =>
    [...data.matchAll(/M(\S+) (\S+?)a(\S+) /g)].map(([, left, y, radius]) => ({
      x: Number(left) + Number(radius),
      y: Number(y),
      radius: Number(radius),
    })),
  );

async function stippledPlane(tone: number): Promise<Mesh> {
  const geometry = await prepareHatchingGeometry(new PlaneGeometry(3, 3, 4, 4), { technique: 'anchored' });
  const material = new HatchingMaterial({
    ...{ technique: 'anchored', medium: 'stipple', sizedOnScreen: 1, strokeWidth: 2, strokeLayers: 'single' },
    reflectedLight: 0,
    toneCurve: [
      [0, tone],
      [1, tone],
    ],
  });
  return new Mesh(geometry, material);
}

const draw = async (mesh: Object3D, kind: 'print' | 'pen' = 'print') =>
  drawSVG(sceneOf(mesh as Mesh), cameraAt(0, 0, 1), {
    ...{ kind, sheet: [SIDE, SIDE], margin: 0 },
    penWidth: kind === 'pen' ? 0.65 : undefined,
  });

describe('dots', () => {
  test.each([0.1, 0.3, 0.5])('cover tone %s', async (tone) => {
    const { svg, leftOut, paths } = await draw(await stippledPlane(tone));
    expect(leftOut).toEqual([]);
    const circles = circlesOf(svg);
    // Of squares of 10 mm.
    expect(paths).toBe(36);
    const area = circles.reduce((sum, { radius }) => sum + Math.PI * radius ** 2, 0);
    expect(Math.abs(area / SIDE ** 2 - tone)).toBeLessThan(0.02);
  });

  test('lie evenly: none of them twice, none upon another', async () => {
    const circles = circlesOf((await draw(await stippledPlane(0.3))).svg);
    expect(circles.length).toBeGreaterThan(2000);
    const far = circles
      .slice(0, 400)
      .map((one) =>
        Math.min(...circles.filter((other) => other !== one).map(({ x, y }) => Math.hypot(x - one.x, y - one.y))),
      );
    // A dot is 0.53 mm wide at half tone, and 0.66 away from the next.
    expect(Math.min(...far)).toBeGreaterThan(0.15);
    far.sort((a, b) => a - b);
    expect(far[200]).toBeGreaterThan(0.4);
  });

  test('hide behind what lies before them, and stay within their surface', async () => {
    const plane = await stippledPlane(0.4);
    plane.scale.set(0.4, 0.4, 1);
    const before = await hatchedMesh(new BoxGeometry(0.4, 0.4, 0.1), { outlines: false });
    before.position.z = 0.4;
    const { svg } = await drawSVG(sceneOf(plane, before), cameraAt(0, 0, 1, true), { sheet: [105, 105], margin: 0 });
    // 50 mm a unit: within 30 mm around the middle, and nothing within 10.
    const circles = circlesOf(svg);
    expect(circles.length).toBeGreaterThan(1000);
    for (const { x, y } of circles) {
      const away = Math.max(Math.abs(x - 52.5), Math.abs(y - 52.5));
      expect(away).toBeLessThan(30.01);
      expect(away).toBeGreaterThan(9.99);
    }
  });

  test('of a pen are circles within the width of the dot, and fewer where dots are too small for it', async () => {
    // Leaning, so that some dots are being born.
    const plane = await stippledPlane(0.3);
    plane.rotation.x = 0.9;
    const print = circlesOf((await draw(plane)).svg);
    const { svg, travelBefore, travelAfter } = await draw(plane, 'pen');
    const pen = circlesOf(svg);
    expect(pen.length).toBeLessThan(print.length);
    expect(pen.length).toBeGreaterThan(100);
    // Half of the pen stays clear of the rim, so the picture is a little smaller.
    const large = print.filter(({ radius }) => 2 * radius > 0.7 * 0.65).length;
    expect(Math.abs(pen.length / large - 1)).toBeLessThan(0.03);
    for (const { radius } of pen) expect(radius).toBeGreaterThanOrEqual(0.02);
    expect(travelAfter).toBeLessThan(0.6 * travelBefore);
  });

  test('stay where they are on the object while the light moves', async () => {
    const geometry = await prepareHatchingGeometry(new SphereGeometry(1, 32, 24), { technique: 'anchored' });
    const material = new HatchingMaterial({
      technique: 'anchored',
      medium: 'stipple',
      sizedOnScreen: 0,
      strokeLayers: 'single',
      strokeWidth: 3,
    });
    const drawn = async (x: number) => {
      const scene = sceneOf(new Mesh(geometry, material));
      scene.children[0].position.set(x, 0.75, 0.6);
      return circlesOf((await drawSVG(scene, cameraAt(0, 0, 1), { sheet: [SIDE, SIDE] })).svg);
    };
    const [one, other] = [await drawn(-0.55), await drawn(-0.5)];
    const places = new Set(other.map(({ x, y }) => `${x.toFixed(2)} ${y.toFixed(2)}`));
    const same = one.filter(({ x, y }) => places.has(`${x.toFixed(2)} ${y.toFixed(2)}`));
    expect(one.length).toBeGreaterThan(300);
    expect(same.length / one.length).toBeGreaterThan(0.7);
  });
});
