import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  DataTexture,
  Mesh,
  type Object3D,
  Plane,
  PlaneGeometry,
  RGBAFormat,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

const SIDE = 60;

interface Circle {
  x: number;
  y: number;
  radius: number;
}

/** The dots of a drawing: polygons of their area, or of the area inside a pen's line. */
const circlesOf = (svg: string): Circle[] => pathsOf(svg, 'stipple').flatMap((data) => ringsOf(data).map(discOf));

function discOf(ring: readonly number[]): Circle {
  const count = ring.length / 2;
  let [x, y, area] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const next = (i + 1) % count;
    x += ring[2 * i] / count;
    y += ring[2 * i + 1] / count;
    area += 0.5 * (ring[2 * i] * ring[2 * next + 1] - ring[2 * next] * ring[2 * i + 1]);
  }
  return { x, y, radius: Math.sqrt(area / Math.PI) };
}

async function stippledPlane(tone: number): Promise<Mesh<BufferGeometry, HatchingMaterial>> {
  const geometry = await prepareHatchingGeometry(new PlaneGeometry(3, 3, 4, 4), { technique: 'hatching' });
  const material = new HatchingMaterial({
    ...{ technique: 'stipple', screenSpaceShare: 1, strokeWidth: 2, strokeLayers: 'single' },
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
  test.each(cases([0.3], [0.1, 0.3, 0.5]))('cover tone %s', { tags: ['more'] }, async (tone) => {
    const { svg, leftOut, paths } = await draw(await stippledPlane(tone));
    expect(leftOut).toEqual([]);
    const circles = circlesOf(svg);
    // One path per square of 10 mm.
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
    // A dot is 0.53 mm wide at half tone, and 0.66 mm from the next.
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
    // At 50 mm per unit: inside a radius of 30 mm, and nothing inside 10.
    const circles = circlesOf(svg);
    expect(circles.length).toBeGreaterThan(1000);
    for (const { x, y } of circles) {
      const away = Math.max(Math.abs(x - 52.5), Math.abs(y - 52.5));
      expect(away).toBeLessThan(30.01);
      expect(away).toBeGreaterThan(9.99);
    }
  });

  test('of a pen are circles within the width of the dot, and fewer where dots are too small for it', async () => {
    // At a slant, so that dots of all ages appear.
    const plane = await stippledPlane(0.3);
    plane.rotation.x = 0.9;
    const print = circlesOf((await draw(plane)).svg);
    const { svg, travelBefore, travelAfter } = await draw(plane, 'pen');
    const pen = circlesOf(svg);
    expect(pen.length).toBeLessThan(print.length);
    expect(pen.length).toBeGreaterThan(100);
    // The picture is slightly smaller, so that the pen stays within the sheet.
    const large = print.filter(({ radius }) => 2 * radius > 0.7 * 0.65).length;
    expect(Math.abs(pen.length / large - 1)).toBeLessThan(0.03);
    for (const { radius } of pen) expect(radius).toBeGreaterThan(0.017);
    expect(travelAfter).toBeLessThan(0.6 * travelBefore);
  });

  test('stay where they are on the object while the light moves', async () => {
    const geometry = await prepareHatchingGeometry(new SphereGeometry(1, 32, 24), { technique: 'hatching' });
    const material = new HatchingMaterial({
      technique: 'stipple',
      screenSpaceShare: 0,
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

/** The area of dots inside a rectangle of the sheet, without overlaps. */
const inkIn = (circles: readonly Circle[], left: number, right: number): number =>
  circles.filter(({ x }) => x > left && x < right).reduce((sum, { radius }) => sum + Math.PI * radius ** 2, 0) /
  ((right - left) * SIDE);

/** Black on the left, white on the right. */
function halfBlack(alpha = 255): DataTexture {
  const texture = new DataTexture(Uint8Array.from([0, 0, 0, alpha, 255, 255, 255, 255]), 2, 1, RGBAFormat);
  texture.needsUpdate = true;
  return texture;
}

describe('dots follow textures and colours', () => {
  const halves = async (material: HatchingMaterialParameters) => {
    const plane = await stippledPlane(0.2);
    plane.material.setValues(material);
    const { svg, leftOut } = await draw(plane);
    expect(leftOut).toEqual([]);
    const circles = circlesOf(svg);
    return [inkIn(circles, 3, 27), inkIn(circles, 33, 57)] as const;
  };
  const local: HatchingMaterialParameters = {
    colorHatching: 0.5,
    composition: { exposure: 1 },
    toneCurve: [
      [0, 0.1],
      [1, 0.5],
    ],
  };

  test('a texture darkens them', async () => {
    const [white] = await halves(local);
    const [left, right] = await halves({ ...local, map: halfBlack() });
    expect(Math.abs(right - white)).toBeLessThan(0.02);
    expect(Math.abs(left - (white + 0.5 * (0.5 - white)))).toBeLessThan(0.02);
  });

  test('emissive maps, ambient light and normal maps', { tags: ['all'] }, async () => {
    const linear: HatchingMaterialParameters = {
      composition: { exposure: 1 },
      toneCurve: 'linear',
      colorHatching: 0,
      highlightThreshold: 0,
    };
    const [plain] = await halves(linear);
    const [dark, lit] = await halves({
      ...linear,
      emissive: 'white',
      emissiveIntensity: 0.2,
      emissiveMap: halfBlack(),
    });
    expect(Math.abs(dark - plain)).toBeLessThan(0.02);
    expect(Math.abs(dark - lit - 0.2)).toBeLessThan(0.02);
    const toLight = new Vector3(-0.55, 0.75, 0.6).normalize();
    const leaning = new DataTexture(Uint8Array.from([64, 128, 237, 255]), 1, 1, RGBAFormat);
    leaning.needsUpdate = true;
    const [bent] = await halves({ ...linear, normalMap: leaning });
    expect(Math.abs(bent - plain + toLight.dot(new Vector3(-0.5, 0, 0.866)) - toLight.z)).toBeLessThan(0.02);
  });

  test('there are none where alpha is too low or a plane clips', async () => {
    const [left, right] = await halves({ map: halfBlack(0), alphaTest: 0.5 });
    expect(left).toBe(0);
    expect(right).toBeGreaterThan(0.15);
    const [kept, clipped] = await halves({ clippingPlanes: [new Plane(new Vector3(-1, 0, 0), 0)] });
    expect(kept).toBeGreaterThan(0.15);
    expect(clipped).toBe(0);
  });

  test('the colours of vertices', async () => {
    const plane = await stippledPlane(0.2);
    plane.material.setValues({ ...local, vertexColors: true });
    const { position } = plane.geometry.attributes;
    const grey = Float32Array.from({ length: 3 * position.count }, (_, i) =>
      position.getX(Math.floor(i / 3)) < 0 ? 0 : 1,
    );
    plane.geometry.setAttribute('color', new BufferAttribute(grey, 3));
    const circles = circlesOf((await draw(plane)).svg);
    expect(inkIn(circles, 1, 8)).toBeGreaterThan(inkIn(circles, 45, 57) + 0.08);
  });

  test('several layers have the tone together, where their dots lie in turn', async () => {
    const plane = await stippledPlane(0.4);
    const one = circlesOf((await draw(plane)).svg);
    plane.material.setValues({ strokeLayers: 'tone', crossFrom: 0.2 });
    const { svg, leftOut } = await draw(plane);
    expect(leftOut).toEqual([]);
    const placeOf = ({ x, y }: Circle) => `${x.toFixed(2)} ${y.toFixed(2)}`;
    const before = new Set(one.map(placeOf));
    const several = circlesOf(svg);
    // The first layer is where a single one is, and the others elsewhere.
    const elsewhere = several.filter((dot) => !before.has(placeOf(dot))).length / several.length;
    expect(elsewhere).toBeGreaterThan(0.2);
    expect(elsewhere).toBeLessThan(0.7);
    expect(Math.abs(coverageOf(pathsOf(svg), [20, 20, 12, 12], 100) - 0.4)).toBeLessThan(0.03);
  });
});
