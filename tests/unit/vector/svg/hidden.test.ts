import { BoxGeometry, type BufferGeometry, Mesh, MeshBasicMaterial, PlaneGeometry, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingOutlineParameters } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};
const PEN = { kind: 'pen', penWidth: 0.2, sheet: [200, 200], margin: 5, lines: 'canvas' } as const;

const sceneWith = async (source: BufferGeometry, outlines: HatchingOutlineParameters) =>
  sceneOf(await hatchedMesh(source, { outlines, material: BLANK }));

/** The total length of lines, millimetres. */
const lengthOf = (paths: string[]): number =>
  paths
    .flatMap((data) => ringsOf(data).map((xy) => ({ xy, isClosed: data.endsWith('z') })))
    .reduce((sum, { xy, isClosed }) => {
      let length = 0;
      for (let i = 2; i < xy.length; i += 2) length += Math.hypot(xy[i] - xy[i - 2], xy[i + 1] - xy[i - 1]);
      return sum + length + (isClosed ? Math.hypot(xy[0] - xy[xy.length - 2], xy[1] - xy[xy.length - 1]) : 0);
    }, 0);

/** Places along a line, 0.1 mm apart, each with the direction. */
function samplesOf(xy: readonly number[]): [x: number, y: number, dx: number, dy: number][] {
  const samples: [number, number, number, number][] = [];
  for (let i = 2; i < xy.length; i += 2) {
    const [dx, dy] = [xy[i] - xy[i - 2], xy[i + 1] - xy[i - 1]];
    const length = Math.hypot(dx, dy);
    for (let at = 0; at < length; at += 0.1) {
      const share = at / length;
      samples.push([xy[i - 2] + share * dx, xy[i - 1] + share * dy, dx / length, dy / length]);
    }
  }
  return samples;
}

describe('hidden outlines', () => {
  test('are not drawn unless they are asked for', async () => {
    const { svg } = await drawSVG(await sceneWith(new BoxGeometry(1.2, 1.2, 1.2), {}), cameraAt(2.2, 1.7, 2.9), PEN);
    expect(svg).not.toContain('hidden');
  });

  test('of a cube are its three hidden edges, faint and whole', async () => {
    const scene = await sceneWith(new BoxGeometry(1.2, 1.2, 1.2), { hidden: 'faint', weights: { creases: 1 } });
    const { svg } = await drawSVG(scene, cameraAt(2.2, 1.7, 2.9), PEN);
    const hidden = pathsOf(svg, 'hidden');
    expect(hidden.length).toBe(3);
    // They meet in one corner.
    const ends = hidden.flatMap((data) => ringsOf(data).flatMap((xy) => [xy.slice(0, 2), xy.slice(-2)]));
    const meeting = ends.filter(
      (end) => ends.filter((one) => Math.hypot(one[0] - end[0], one[1] - end[1]) < 0.1).length === 3,
    );
    expect(meeting.length).toBe(3);
    // Visible outlines are the same with and without hidden ones.
    const seen = pathsOf(svg, 'outlines');
    const without = pathsOf(
      (await drawSVG(scene, cameraAt(2.2, 1.7, 2.9), { ...PEN, hidden: 'none' })).svg,
      'outlines',
    );
    expect([...seen].sort()).toEqual([...without].sort());
  });

  test('are dashed from end to end, 3.5 widths of an outline drawn and two left blank', async () => {
    const scene = await sceneWith(new BoxGeometry(1.2, 1.2, 1.2), {
      hidden: 'faint',
      weights: { creases: 1 },
      outlineWidth: 2,
    });
    // Ends below two outlines stay.
    const pen = { ...PEN, maxPasses: 3 };
    const whole = pathsOf((await drawSVG(scene, cameraAt(2.2, 1.7, 2.9), pen)).svg, 'hidden');
    const dashed = pathsOf((await drawSVG(scene, cameraAt(2.2, 1.7, 2.9), { ...pen, hidden: 'dashed' })).svg, 'hidden');
    expect(dashed.length).toBeGreaterThan(30);
    expect(lengthOf(dashed) / lengthOf(whole)).toBeGreaterThan(3.5 / 5.5);
    expect(lengthOf(dashed) / lengthOf(whole)).toBeLessThan(3.5 / 5.5 + 0.05);
    const cornersOf = (paths: string[]) =>
      paths.flatMap((data) => ringsOf(data).flatMap((xy) => [xy.slice(0, 2), xy.slice(-2)]));
    for (const [x, y] of cornersOf(whole))
      expect(Math.min(...cornersOf(dashed).map(([u, v]) => Math.hypot(u - x, v - y)))).toBeLessThan(0.05);
  });

  test('are faint in print by their opacity', async () => {
    const scene = await sceneWith(new BoxGeometry(1.2, 1.2, 1.2), { hidden: 'faint' });
    const { svg } = await drawSVG(scene, cameraAt(2.2, 1.7, 2.9));
    expect(svg).toMatch(/inkscape:label="2 hidden" fill="#000000" opacity="0.4"/);
    expect(svg.match(/opacity/g)?.length).toBe(1);
  });

  test('of a sphere behind a plate are what the plate hides: with what is seen they are the whole circle', async () => {
    const scene = await sceneWith(new SphereGeometry(0.7, 96, 64), { hidden: 'faint' });
    const camera = cameraAt(0, 0, 1);
    const free = lengthOf(pathsOf((await drawSVG(scene, camera, PEN)).svg, 'outlines'));
    const plate = new Mesh(new PlaneGeometry(1, 4), new MeshBasicMaterial());
    plate.position.set(-0.7, 0, 1.5);
    scene.add(plate);
    const { svg } = await drawSVG(scene, camera, PEN);
    const [seen, hidden] = [lengthOf(pathsOf(svg, 'outlines')), lengthOf(pathsOf(svg, 'hidden'))];
    expect(hidden).toBeGreaterThan(0.2 * free);
    expect(seen).toBeGreaterThan(0.2 * free);
    expect(Math.abs(seen + hidden - free)).toBeLessThan(0.01 * free);
  });

  test('a wrong value is refused in one sentence', async () => {
    const drawing = drawSVG(await sceneWith(new BoxGeometry(), {}), cameraAt(2, 2, 3), {
      hidden: 'dotted' as 'dashed',
    });
    await expect(drawing).rejects.toThrow("drawSVG: hidden is dotted, but must be 'none' or 'dashed' or 'faint'.");
  });
});

describe('a pen draws edges of parts that lie in one place once', () => {
  const outlines = { hidden: 'dashed', weights: { creases: 1, borders: 1 }, outlineWidth: 2 } as const;
  const cube = async (x = 0) => {
    const mesh = await hatchedMesh(new BoxGeometry(0.8, 0.8, 0.8), { outlines, material: BLANK });
    mesh.position.x = x;
    return mesh;
  };
  const draw = async (...meshes: Mesh[]) => (await drawSVG(sceneOf(...meshes), cameraAt(2.2, 1.7, 2.9), PEN)).svg;

  test('also where one is hidden', async () => {
    const once = await draw(await cube());
    const twice = await draw(await cube(), await cube());
    for (const layer of ['outlines', 'hidden']) {
      const expected = lengthOf(pathsOf(once, layer));
      expect(Math.abs(lengthOf(pathsOf(twice, layer)) / expected - 1)).toBeLessThan(0.02);
    }
  });

  test('and nothing dashed lies on a visible line', async () => {
    const svg = await draw(await cube(-0.4), await cube(0.4));
    const places = (layer: string) => pathsOf(svg, layer).flatMap((data) => ringsOf(data).flatMap(samplesOf));
    const seen = places('outlines');
    const dashed = places('hidden');
    expect(dashed.length).toBeGreaterThan(50);
    const onSeen = dashed.filter(([x, y, dx, dy]) =>
      seen.some((one) => Math.hypot(one[0] - x, one[1] - y) < 0.1 && Math.abs(one[2] * dx + one[3] * dy) > 0.99),
    );
    expect(onSeen.length).toBeLessThan(0.02 * dashed.length);
  });
});
