import { BoxGeometry } from 'three';
import { expect, test } from 'vitest';
import { readPlot } from '../../../../src/playground/export/PlotSheet.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../../vector/hatchedScene.js';

test('the paths of a plot are read in order with the inks and widths of their pens, and each has its time', async () => {
  const scene = sceneOf(await hatchedMesh(new BoxGeometry(), { material: { ink: '#102030' } }));
  const penWidth = { outlines: 0.5, lines: 0.25 };
  const drawing = await drawSVG(scene, cameraAt(0.4, 0.5, 1), {
    kind: 'pen',
    penWidth,
    sheet: [60, 40],
    shadows: false,
  });
  const { width, height, paths } = readPlot(drawing.svg);
  expect([width, height]).toEqual([60, 40]);
  expect(paths).toHaveLength(drawing.paths);
  let at = 0;
  for (const { ink, pen, paths: count, pathSeconds, plotSeconds } of drawing.layers) {
    for (const path of paths.slice(at, at + count)) expect([path.ink, path.width]).toEqual([ink, pen]);
    at += count;
    expect(pathSeconds).toHaveLength(count);
    expect(pathSeconds!.every((seconds, i) => seconds > (pathSeconds![i - 1] ?? 0))).toBe(true);
    expect(pathSeconds!.at(-1)).toBe(plotSeconds);
  }
  expect(new Set(paths.map((path) => path.width))).toEqual(new Set([0.5, 0.25]));
  expect(paths.every(({ data }) => data.startsWith('M'))).toBe(true);
});
