import { DataTexture, Float32BufferAttribute, Mesh, MeshBasicMaterial, PlaneGeometry, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

const SIDE = 40;
/** 40 mm show 2.1 units: the middle third is behind a nearer pane of 0.8 units, the rest beside it. */
const BEHIND = [17, 17, 6, 6] as const;
const BESIDE = [2, 2, 6, 36] as const;

const draw = async (...meshes: Mesh[]) => {
  const { svg, leftOut } = await drawSVG(sceneOf(...meshes), cameraAt(0, 0, 1, true), {
    ...{ sheet: [SIDE, SIDE], margin: 0, leastWidth: 0, order: 'drawn' },
  });
  expect(leftOut.filter(({ reason }) => !reason.includes('no HatchingMaterial'))).toEqual([]);
  const paths = pathsOf(svg);
  return { behind: coverageOf(paths, BEHIND, 200), beside: coverageOf(paths, BESIDE, 200), paths };
};

/** The length of the lines of a pen in the middle of what a pane covers, millimetres. */
function inkIn(svg: string): number {
  const [from, to, step] = [14, 26, 0.02];
  let length = 0;
  for (const points of pathsOf(svg).flatMap(ringsOf)) {
    for (let o = 2; o < points.length; o += 2) {
      const [x, y] = [points[o - 2], points[o - 1]];
      const [dx, dy] = [points[o] - x, points[o + 1] - y];
      const steps = Math.ceil(Math.hypot(dx, dy) / step);
      for (let k = 0; k < steps; k++) {
        const isInside = [x + (dx * k) / steps, y + (dy * k) / steps].every((at) => at > from && at < to);
        if (isInside) length += Math.hypot(dx, dy) / steps;
      }
    }
  }
  return length;
}

/** A pane in front of the others that prints nothing itself. */
function pane(material: ConstructorParameters<typeof MeshBasicMaterial>[0]): Mesh {
  const mesh = new Mesh(new PlaneGeometry(0.8, 0.8), new MeshBasicMaterial(material));
  mesh.position.z = 0.5;
  return mesh;
}

describe('see-through surfaces', () => {
  test.each([
    [{ transparent: true, opacity: 0.5 }, 0.5],
    [{ transparent: true, opacity: 0.25 }, 0.25],
    [{ alphaHash: true, opacity: 0.5 }, 0.5],
    // Opaque, whatever their opacity.
    [{ opacity: 0.5 }, 1],
  ] as const)('%s print so much of their tone', async (material: HatchingMaterialParameters, share) => {
    const { beside } = await draw(await planeOfTone(0.4, material));
    expect(Math.abs(beside - 0.4 * share)).toBeLessThan(0.015);
  });

  test.each([
    [{ transparent: true, opacity: 0.5 }, 0.5],
    [{ transparent: true, opacity: 0.8 }, 0.2],
    [{ transparent: true, opacity: 1 }, 0],
    [{ opacity: 0.5 }, 0],
  ] as const)('%s leave so much of what is behind them', async (material, left) => {
    const { behind, beside } = await draw(await planeOfTone(0.4), pane(material));
    expect(Math.abs(beside - 0.4)).toBeLessThan(0.015);
    expect(Math.abs(behind - 0.4 * left)).toBeLessThan(0.015);
  });

  test('a pane with a picture leaves as much as one without, where the picture is', async () => {
    const data = Uint8Array.of(255, 255, 255, 255, 255, 255, 255, 0);
    const map = Object.assign(new DataTexture(data, 2, 1), { needsUpdate: true });
    const { behind } = await draw(await planeOfTone(0.4), pane({ transparent: true, opacity: 0.25, map }));
    // Half of it is cut out.
    expect(Math.abs(behind - (0.4 * (0.75 + 1)) / 2)).toBeLessThan(0.03);
  });

  test('a pane whose vertices are seen through leaves as much as they do', async () => {
    const withAlphas = (...alphas: number[]): Mesh => {
      const glass = pane({ transparent: true, opacity: 0.5, vertexColors: true });
      const colors = alphas.flatMap((alpha) => [1, 1, 1, alpha]);
      glass.geometry.setAttribute('color', new Float32BufferAttribute(colors, 4));
      return glass;
    };
    const { behind } = await draw(await planeOfTone(0.4), withAlphas(0.5, 0.5, 0.5, 0.5));
    expect(Math.abs(behind - 0.4 * 0.75)).toBeLessThan(0.015);
    const scene = sceneOf(await planeOfTone(0.4), withAlphas(1, 0, 1, 0));
    const { leftOut } = await drawSVG(scene, cameraAt(0, 0, 1, true), { sheet: [SIDE, SIDE] });
    expect(leftOut.map(({ reason }) => reason)).toContainEqual(expect.stringContaining('drawn with one opacity'));
  });

  test('two panes leave what both leave, and one without paper all', async () => {
    const second = pane({ transparent: true, opacity: 0.5 });
    second.position.z = 0.7;
    const { behind } = await draw(await planeOfTone(0.6), pane({ transparent: true, opacity: 0.5 }), second);
    expect(Math.abs(behind - 0.15)).toBeLessThan(0.015);
    const film = await planeOfTone(0, { transparent: true, opacity: 0.5, paperOpacity: 0 });
    film.position.z = 0.5;
    expect(Math.abs((await draw(await planeOfTone(0.6), film)).behind - 0.6)).toBeLessThan(0.015);
  });

  test('with what is behind them they print as much as on the canvas, where inks are added', async () => {
    const front = await planeOfTone(0.6, { transparent: true, opacity: 0.5, direction: 'y' });
    front.position.z = 0.5;
    const { paths } = await draw(await planeOfTone(0.6, { direction: 'x' }), front);
    // Printed over one another they would cover 0.51.
    expect(Math.abs(coverageOf(paths, [2, 2, 36, 36], 300) - 0.6)).toBeLessThan(0.025);
  });

  const byPen = async (options: DrawSVGOptions, ...panes: Mesh[]) =>
    drawSVG(sceneOf(await planeOfTone(0.4), ...panes), cameraAt(0, 0, 1, true), {
      ...{ kind: 'pen', sheet: [SIDE, SIDE], margin: 0, shortest: 0, ...options },
    });

  test.each(['even', 'canvas'] as const)('a pen draws fewer lines behind them, each whole: lines %s', async (lines) => {
    const [all, opaque, clear] = await Promise.all(
      [[], [pane({})], [pane({ transparent: true, opacity: 0.6 })]].map((panes) => byPen({ lines }, ...panes)),
    );
    expect(inkIn(opaque.svg)).toBe(0);
    expect(Math.abs(inkIn(clear.svg) / inkIn(all.svg) - 0.4)).toBeLessThan(0.1);
    // Each line that goes on behind the pane is one, and each that does not is two: dashes would be some ten more a line.
    expect(clear.paths).toBeLessThanOrEqual(opaque.paths);
  });

  test('a pen draws outlines behind them whole, unless next to nothing is left of them', async () => {
    const drawnBehind = async (opacity: number) => {
      const ball = await hatchedMesh(new SphereGeometry(0.3, 48, 24), { material: { ink: 'white' }, outlines: {} });
      const { layers } = await drawSVG(sceneOf(ball, pane({ transparent: true, opacity })), cameraAt(0, 0, 1, true), {
        ...{ kind: 'pen', sheet: [SIDE, SIDE], margin: 0, shadows: false },
      });
      const outlines = layers.find(({ name }) => name === 'outlines');
      return outlines ? [outlines.paths, Math.round(outlines.drawn)] : [0, 0];
    };
    const whole = [1, Math.round((2 * Math.PI * 0.3 * SIDE) / 2.1)];
    expect(await drawnBehind(0.3)).toEqual(whole);
    expect(await drawnBehind(0.7)).toEqual(whole);
    expect(await drawnBehind(0.9)).toEqual([0, 0]);
  });
});
