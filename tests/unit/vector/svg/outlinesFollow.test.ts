import {
  BoxGeometry,
  type BufferGeometry,
  DataTexture,
  DoubleSide,
  EqualStencilFunc,
  FrontSide,
  GreaterDepth,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  Plane,
  PlaneGeometry,
  type Side,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** Outlines follow the properties of meshes that three.js reads, as on the canvas. */

const EVEN = {
  weights: { innerContours: 1, creases: 1, materialBorders: 0, lit: 1, shade: 1 },
  lostEdges: 0,
  accents: 0,
} as const;
const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};
const SHEET = { sheet: [60, 60], margin: 0 } as const;

const boxOf = (outlines = {}) =>
  hatchedMesh(new BoxGeometry(1.2, 1.2, 1.2), { outlines: { ...EVEN, outlineWidth: 3, ...outlines }, material: BLANK });

async function draw(mesh: Mesh, camera = cameraAt(2.2, 1.7, 2.9)) {
  const { svg, leftOut } = await drawSVG(sceneOf(mesh), camera, SHEET);
  return {
    svg,
    ink: coverageOf(pathsOf(svg), [0, 0, 60, 60]),
    reasons: leftOut.map(({ reason }) => reason),
  };
}

const blank = (parameters = {}) => new HatchingMaterial({ technique: 'engraving', ...BLANK, ...parameters });

test('they fade to the same ink, and are not there at 0', async () => {
  const mesh = await boxOf();
  const { ink: whole } = await draw(mesh);
  Object.assign(mesh.material, { transparent: true, opacity: 0.5 });
  const { ink: half } = await draw(mesh);
  // The sides are see-through: twelve edges are visible instead of nine.
  expect(half / whole).toBeGreaterThan(0.5);
  expect(half / whole).toBeLessThan(0.75);
  mesh.material.opacity = 0;
  expect((await draw(mesh)).ink).toBe(0);
  mesh.material.transparent = false;
  expect((await draw(mesh)).ink).toBeCloseTo(whole, 6);
  mesh.material.colorWrite = false;
  expect((await draw(mesh)).ink).toBe(0);
});

test('they leave a layer with their mesh', async () => {
  const mesh = await boxOf();
  const { ink } = await draw(mesh);
  mesh.layers.set(1);
  expect((await draw(mesh)).ink).toBe(0);
  const camera = cameraAt(2.2, 1.7, 2.9);
  camera.layers.set(1);
  expect((await draw(mesh, camera)).ink).toBeCloseTo(ink, 6);
});

describe('groups', () => {
  test('that nothing draws have no outlines', async () => {
    const mesh = await boxOf();
    const { ink: whole } = await draw(mesh);
    const materials: Material[] = Array.from({ length: 6 }, () => blank());
    mesh.material = materials as never;
    expect((await draw(mesh)).ink).toBeCloseTo(whole, 6);
    for (const material of materials) material.visible = material === materials[4];
    const { ink: alone } = await draw(mesh);
    expect(alone).toBeGreaterThan(0.2 * whole);
    expect(alone).toBeLessThan(0.6 * whole);
  });

  test('fade one by one', async () => {
    const mesh = await boxOf();
    const materials: Material[] = Array.from({ length: 6 }, () => blank());
    for (const i of [0, 2]) Object.assign(materials[i], { transparent: true, opacity: 0.25 });
    mesh.material = materials as never;
    const { svg } = await draw(mesh);
    const bounds = pathsOf(svg, 'outlines').flatMap((data) => ringsOf(data));
    expect(bounds.length).toBeGreaterThan(0);
    const { ink } = await draw(mesh);
    mesh.material = blank() as never;
    expect(ink).toBeLessThan((await draw(mesh)).ink);
  });
});

test('a draw range cuts them, with a border', async () => {
  const mesh = await hatchedMesh(new PlaneGeometry(1.2, 1.2, 2, 1), {
    outlines: { ...EVEN, outlineWidth: 3 },
    material: BLANK,
  });
  const camera = cameraAt(0, 0, 1, true);
  const middle = async () => coverageOf(pathsOf((await draw(mesh, camera)).svg), [29, 25, 2, 10]);
  expect(await middle()).toBe(0);
  const { ink: whole } = await draw(mesh, camera);
  mesh.geometry.setDrawRange(0, 6);
  expect(await middle()).toBeGreaterThan(0.2);
  expect((await draw(mesh, camera)).ink / whole).toBeCloseTo(0.75, 1);
});

test('borders follow the side that a surface is drawn from', async () => {
  const outlines = { ...EVEN, weights: { ...EVEN.weights, contours: 0 }, outlineWidth: 3 };
  const inkFrom = async (source: BufferGeometry, side: Side, height: number, away: number) => {
    const mesh = await hatchedMesh(source, { outlines, material: { ...BLANK, side } });
    return (await draw(mesh, cameraAt(0, height, away, true))).ink;
  };
  const sheet = new PlaneGeometry(1.2, 1.2);
  const whole = await inkFrom(sheet, FrontSide, 0, 1);
  expect(whole).toBeGreaterThan(0);
  expect(await inkFrom(sheet, FrontSide, 0, -1)).toBe(0);
  expect(await inkFrom(sheet, DoubleSide, 0, -1)).toBeCloseTo(whole, 6);
  // The dome hides the far half of its rim, from silhouette to silhouette.
  const dome = new SphereGeometry(0.8, 48, 24, 0, 2 * Math.PI, 0, 0.5 * Math.PI);
  const rim = await inkFrom(dome, DoubleSide, 0.4, 1);
  expect(rim).toBeGreaterThan(0);
  expect((await inkFrom(dome, FrontSide, 0.4, 1)) / rim).toBeCloseTo(1, 1);
});

test('the clipping planes of a material cut them', async () => {
  const mesh = await boxOf();
  const { ink } = await draw(mesh);
  mesh.material.clippingPlanes = [new Plane(new Vector3(1, 0, 0), 0)];
  expect((await draw(mesh)).ink).toBeLessThan(0.8 * ink);
  mesh.material.clippingPlanes = [new Plane(new Vector3(1, 0, 0), -9)];
  expect((await draw(mesh)).ink).toBe(0);
});

describe('where a picture cuts the surface away', () => {
  /** Opaque in its left half only. */
  const half = new DataTexture(Uint8Array.of(255, 255, 255, 255, 255, 255, 255, 0), 2, 1);
  const card = async (material = {}, outlines = {}) => {
    const mesh = await hatchedMesh(new PlaneGeometry(1.2, 1.2), {
      outlines: { ...EVEN, outlineWidth: 3, ...outlines },
      material: BLANK,
    });
    Object.assign(mesh.material, material);
    return mesh;
  };
  const camera = cameraAt(0, 0, 1, true);
  const drawn = async (mesh: Mesh, ...others: Mesh[]) => {
    const { svg } = await drawSVG(sceneOf(mesh, ...others), camera, SHEET);
    const sides = (paths: readonly string[]) => [coverageOf(paths, [0, 0, 29, 60]), coverageOf(paths, [31, 0, 29, 60])];
    return { seen: sides(pathsOf(svg, 'outlines')), hidden: sides(pathsOf(svg, 'hidden')) };
  };

  test('there are none', async () => {
    const { seen: whole } = await drawn(await card());
    for (const material of [{ alphaTest: 0.5 }, { alphaHash: true }, { transparent: true }]) {
      const { seen } = await drawn(await card({ map: half, ...material }));
      expect(seen[0] / whole[0], JSON.stringify(material)).toBeCloseTo(1, 1);
      expect(seen[1], JSON.stringify(material)).toBe(0);
    }
    for (const material of [{ map: half }, { alphaTest: 0.5 }, { map: half, alphaTest: 0.5, depthWrite: false }]) {
      const { seen } = await drawn(await card(material));
      expect(seen[1] / whole[1], JSON.stringify(material)).toBeCloseTo(1, 2);
    }
  });

  test('there are no hidden ones either', async () => {
    const { hidden } = await drawn(await card({ map: half, alphaTest: 0.5 }, { hidden: 'faint' }));
    expect(hidden).toEqual([0, 0]);
    const wall = new Mesh(new PlaneGeometry(9, 9), blank());
    wall.position.z = 0.2;
    const behind = await drawn(await card({}, { hidden: 'faint' }), wall);
    expect(Math.min(...behind.hidden)).toBeGreaterThan(0);
  });
});

test('instances that are hidden by a scale of 0 leave nothing', async () => {
  const { geometry, material } = await boxOf();
  const draws = async (scale: number) => {
    const many = new InstancedMesh(geometry, material, 2);
    many.setMatrixAt(0, new Matrix4().makeTranslation(0.3, 0, 0));
    many.setMatrixAt(1, new Matrix4().makeScale(scale, scale, scale));
    many.add(new HatchingOutlines(many, { ...EVEN, outlineWidth: 3 }));
    return (await draw(many)).ink;
  };
  const alone = new Mesh(geometry, material);
  alone.position.x = 0.3;
  alone.add(new HatchingOutlines(alone, { ...EVEN, outlineWidth: 3 }));
  expect(await draws(0)).toBeCloseTo((await draw(alone)).ink, 6);
});

test('what is tested pixel by pixel is said to be drawn without', async () => {
  const mesh = await boxOf();
  expect((await draw(mesh)).reasons).toEqual([]);
  Object.assign(mesh.material, { stencilWrite: true, stencilFunc: EqualStencilFunc });
  expect((await draw(mesh)).reasons).toEqual([expect.stringContaining('had no stencil')]);
  Object.assign(mesh.material, { stencilWrite: false, depthFunc: GreaterDepth });
  expect((await draw(mesh)).reasons).toEqual([expect.stringContaining('another depth test')]);
});
