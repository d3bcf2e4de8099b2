import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  IcosahedronGeometry,
  PlaneGeometry,
  SphereGeometry,
} from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import type { HatchingOutlineParameters } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { loneStrip, strips } from '../../../gpu/strips.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** Outlines of one weight. */
const ALIKE = { weights: { innerContours: 1, creases: 1, lit: 1, shade: 1 }, lostEdges: 0, accents: 0 };
const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};
const PIXEL = 25.4 / 96;

describe('accents', () => {
  /** A ball in front of the straight border of a sheet; returns the width of its left contour at four heights. */
  async function ballBeforeBorder(outlines: HatchingOutlineParameters): Promise<number[]> {
    const ball = await hatchedMesh(new SphereGeometry(0.6, 192, 128), {
      outlines: { ...ALIKE, outlineWidth: 4, ...outlines },
      material: BLANK,
    });
    const sheet = await hatchedMesh(new PlaneGeometry(4, 4), { outlines: false, material: BLANK });
    // The sheet's upper border is at the height of the ball's middle, far behind it.
    sheet.position.set(0, -2, -1);
    const { svg } = await drawSVG(sceneOf(ball, sheet), cameraAt(0, 0, 1, true), { sheet: [105, 105], margin: 0 });
    // The picture is 2.1 high, at 50 mm per unit. The ball's left side is at x = 22.5.
    return [0, 4, 8, 16].map((below) => coverageOf(pathsOf(svg), [17, 52.5 + below, 15, 0.2]) * 15);
  }

  test('make a contour heavier where another outline ends behind it, and nowhere else', async () => {
    const plain = await ballBeforeBorder({});
    const accented = await ballBeforeBorder({ accents: 0.5 });
    // At the border, within half a step, at least three quarters of the accent are left.
    expect(accented[0] / plain[0]).toBeGreaterThan(1.35);
    expect(accented[0] / plain[0]).toBeLessThan(1.5);
    expect(accented[1]).toBeLessThan(accented[0]);
    expect(accented[1]).toBeGreaterThan(1.05 * plain[1]);
    // 8 widths of 4 pixels are 8.5 mm.
    expect(accented[3]).toBeCloseTo(plain[3], 3);
    // There the contour is cut at a slant.
    expect(plain[3]).toBeCloseTo((4 * PIXEL * 30) / Math.sqrt(30 ** 2 - 16 ** 2), 1);
  });
});

test('outlines run on beyond corners by the overshoot, and end there', async () => {
  const draw = async (overshoot: number) => {
    const mesh = await hatchedMesh(new BoxGeometry(1.2, 1.2, 1.2), {
      outlines: { ...ALIKE, overshoot },
      material: BLANK,
    });
    return drawSVG(sceneOf(mesh), cameraAt(2.2, 1.7, 2.9), { kind: 'pen', dpi: 25.4 });
  };
  const [plain, beyond] = [await draw(0), await draw(5)];
  expect(beyond.leftOut).toEqual([]);
  // Three edges go on in others, so that the pen stays down.
  expect(plain.paths).toBe(6);
  expect(beyond.paths).toBe(9);
  // A pixel is a millimetre. Nine edges overshoot at both ends, except where a face of the cube is in the way.
  const more = beyond.drawn - plain.drawn;
  expect(more).toBeGreaterThan(0.7 * 18 * 5);
  expect(more).toBeLessThan(1.01 * 18 * 5);
});

test('suggestive contours are drawn where they are asked for', async () => {
  const draw = async (suggestiveContours: number) => {
    // Waves at a slant, so that none hides another.
    const waves = new PlaneGeometry(2, 2, 128, 32);
    const { position } = waves.attributes;
    for (let v = 0; v < position.count; v++) position.setZ(v, 0.06 * Math.sin(9 * position.getX(v)));
    waves.computeVertexNormals();
    const mesh = await hatchedMesh(waves, {
      outlines: { ...ALIKE, weights: { ...ALIKE.weights, borders: 0, suggestiveContours } },
      material: BLANK,
    });
    return drawSVG(sceneOf(mesh), cameraAt(1, 0, 1.4), { kind: 'pen' });
  };
  expect((await draw(0)).paths).toBe(0);
  const { leftOut, paths, svg } = await draw(0.8);
  expect(leftOut).toEqual([]);
  // One line per wave, from top to bottom, where the curvature is 0.
  expect(paths).toBeGreaterThanOrEqual(2);
  expect(paths).toBeLessThanOrEqual(4);
  for (const data of pathsOf(svg, 'outlines')) {
    const [points] = ringsOf(data);
    const ys = points.filter((_, i) => i % 2 === 1);
    expect(Math.max(...ys) - Math.min(...ys)).toBeGreaterThan(100);
  }
});

test('a contour of coarse triangles is hidden by what stands close before it', async () => {
  // Its triangles are deep, so its contour is lifted far towards the eye.
  const coarse = mergeVertices(new IcosahedronGeometry(0.9, 2).deleteAttribute('normal').deleteAttribute('uv'));
  const ball = await hatchedMesh(coarse, { outlines: { ...ALIKE, outlineWidth: 6 }, material: BLANK });
  const sheet = await hatchedMesh(new PlaneGeometry(4, 2), { outlines: false, material: BLANK });
  sheet.position.set(0, -1, 0.2);
  const camera = cameraAt(0, 0, 1, true);
  const { svg } = await drawSVG(sceneOf(ball, sheet), camera, { sheet: [105, 105], margin: 0 });
  const paths = pathsOf(svg, 'outlines');
  // The upper border of the sheet lies in the middle.
  expect(coverageOf(paths, [0, 0, 105, 52])).toBeGreaterThan(0.005);
  expect(coverageOf(paths, [0, 53, 105, 52])).toBe(0);
});

describe('a Möbius strip', async () => {
  const RADIUS = 0.75;
  const HALF = 0.2;
  const STEPS = 192;
  const ACROSS = 4;
  const around = (turn: number, across: number) => {
    const r = RADIUS + across * Math.cos(turn / 2);
    return [r * Math.cos(turn), r * Math.sin(turn), across * Math.sin(turn / 2)] as const;
  };
  /** The last row joins the first upside down. */
  const strip = (): BufferGeometry => {
    const positions: number[] = [];
    const index: number[] = [];
    for (let i = 0; i < STEPS; i++) {
      for (let k = 0; k <= ACROSS; k++)
        positions.push(...around((2 * Math.PI * i) / STEPS, HALF * ((2 * k) / ACROSS - 1)));
    }
    const at = (i: number, k: number): number => (i < STEPS ? i * (ACROSS + 1) + k : ACROSS - k);
    for (let i = 0; i < STEPS; i++) {
      for (let k = 0; k < ACROSS; k++)
        index.push(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
    const geometry = new BufferGeometry().setIndex(index);
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
    geometry.computeVertexNormals();
    return geometry;
  };

  test('has one border, a path that goes round twice and is cut only where it passes behind itself', async () => {
    const mesh = await hatchedMesh(strip(), {
      outlines: { ...ALIKE, weights: { ...ALIKE.weights, creases: 0, contours: 0 }, outlineWidth: 1 },
      material: BLANK,
    });
    (mesh.material as HatchingMaterial).side = DoubleSide;
    const sheet = { kind: 'pen', sheet: [105, 105], margin: 0 } as const;
    const { drawn, paths } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), sheet);
    expect(paths).toBe(1);
    let length = 0;
    for (let i = 0; i < 2 * STEPS; i++) {
      const [x, y] = around((2 * Math.PI * i) / STEPS, HALF);
      const [nextX, nextY] = around((2 * Math.PI * (i + 1)) / STEPS, HALF);
      length += 50 * Math.hypot(nextX - x, nextY - y);
    }
    // A tenth of a millimetre is hidden there.
    expect(Math.abs(drawn / length - 1)).toBeLessThan(0.005);
  });
});

describe('outlines that crowd', () => {
  const draw = async (source: BufferGeometry, kind: 'print' | 'pen') => {
    const mesh = await hatchedMesh(source, { outlines: ALIKE, material: BLANK });
    return drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), { sheet: [105, 105], margin: 0, kind });
  };
  // The picture is 2.1 wide, at 50 mm per unit: left, top, width and height of the crowd, and of the leaf that stands alone.
  const CROWD = [10, 10, 70, 85] as const;
  const LONE = [92, 10, 10, 85] as const;

  test('are bounded in their ink, and one alone keeps its width', async () => {
    const paths = pathsOf((await draw(strips(60), 'print')).svg);
    const alone = pathsOf((await draw(loneStrip(60), 'print')).svg);
    // Borders are 0.63 mm apart, and would be 0.48 mm wide.
    expect(coverageOf(paths, CROWD)).toBeLessThan(0.35);
    expect(coverageOf(paths, CROWD)).toBeGreaterThan(0.1);
    expect(coverageOf(paths, LONE)).toBeCloseTo(coverageOf(alone, LONE), 3);
  });

  test('are left out by a pen that is wider than they may be', async () => {
    const [beside, alone] = [await draw(strips(60), 'pen'), await draw(loneStrip(60), 'pen')];
    expect(alone.paths).toBeGreaterThan(0);
    // Of 240 borders a few are left at the rim of the crowd.
    expect(beside.paths).toBeLessThan(alone.paths + 6);
  });
});
