/** Draws models for one pen as the command stages them, with lines placed evenly and with those of the canvas, and measures both. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Camera, Scene } from 'three';
import { drawSVG } from 'three-hatching/svg';
import { NodeSurroundings } from '../../src/command/draw/NodeSurroundings.js';
import { settingsFor, setUpScene } from '../../src/command/draw/setUpScene.js';
import { parseDrawing } from '../../src/command/parseDrawing.js';
import { runToEnd } from '../../src/mesh/phases.js';
import { Bvh } from '../../src/vector/Bvh.js';
import { placePicture } from '../../src/vector/drawLines.js';
import { LineDrawer } from '../../src/vector/LineDrawer.js';
import { EvenSurface } from '../../src/vector/streamlines/EvenSurface.js';
import { canBeEven, ownersOf } from '../../src/vector/streamlines/evenLines.js';
import { Sheet } from '../../src/vector/streamlines/Sheet.js';
import { type DrawSVGOptions, planOf } from '../../src/vector/svg/DrawSVGOptions.js';
import { readScene } from '../../src/vector/svg/readScene.js';
import { buildModel } from '../../src/viewer/drawing/buildModel.js';
import { readModel } from '../../src/viewer/files/readModel.js';
import { type PlotFigures, plotFigures, type WantedTones } from './plotFigures.js';

/** A model as a file. */
export interface PlotSource {
  name: string;
  file: string;
  content: Uint8Array;
  preset: string;
}

/** The figures of a drawing, and the processor time it took, seconds. */
export interface PlotRow extends PlotFigures {
  model: string;
  lines: 'even' | 'canvas';
  seconds: number;
}

const PEN = 0.3;
/** Width of a cell of tone in samples of the sheet. */
const CELL = 8;
/** The layers of hatching. */
const LAYERS = ['lines', 'crossing', 'shadows'];

/** @param output folder for the drawings */
export async function measurePlot({ name, file, content, preset }: PlotSource, output: string): Promise<PlotRow[]> {
  const { scene, camera, sheet } = await staged(file, content, preset);
  mkdirSync(output, { recursive: true });
  const rows: PlotRow[] = [];
  for (const lines of ['even', 'canvas'] as const) {
    const options: DrawSVGOptions = { kind: 'pen', penWidth: PEN, sheet, margin: 10, lines };
    const start = process.cpuUsage();
    const { svg } = await drawSVG(scene, camera, options);
    const { user, system } = process.cpuUsage(start);
    writeFileSync(join(output, `${name}-${lines}.svg`), svg);
    const drawn = layersOf(svg);
    const isHatching = ([name]: readonly [string, unknown]): boolean => LAYERS.includes(name);
    const hatching = new Map([...drawn].filter(isHatching));
    const others = [...drawn].filter((layer) => !isHatching(layer)).flatMap(([, paths]) => paths);
    const figures = plotFigures(hatching, others, PEN, sheet, wantedTones(scene, camera, options));
    rows.push({ model: name, lines, ...figures, seconds: (user + system) / 1e6 });
  }
  return rows;
}

/** The scene of a model as the command sets it up, without a ground. */
async function staged(file: string, content: Uint8Array, preset: string) {
  const request = parseDrawing(['a', '--out', 'b', '--sheet', 'A5', '--preset', preset, '--kind', 'pen']);
  if (request.action !== 'draw') throw new Error('measurePlot: the arguments ask for help.');
  const { options } = request;
  const surroundings = new NodeSurroundings('.');
  const read = await readModel(
    [{ name: file, content: new Blob([content as Uint8Array<ArrayBuffer>]) }],
    () => {},
    surroundings,
    { switched: [] },
  );
  const { signal } = new AbortController();
  const { model } = await buildModel(read, () => {}, signal);
  const drawnWith = settingsFor(options, undefined, model.stands ?? read.upAxis);
  Object.assign(drawnWith.settings, { ground: 'none' });
  const { scene, placed, placeLights, sheet } = await setUpScene(model, drawnWith, options, [0], {
    signal,
    report: () => {},
  });
  placeLights();
  return { scene, camera: placed.camera, sheet };
}

/** The paths of a file by the names of their layers, without inks. */
function layersOf(svg: string): Map<string, number[][]> {
  const layers = new Map<string, number[][]>();
  for (const [, label, body] of svg.matchAll(/inkscape:label="\d+ ([^"]*)"[^>]*>([\s\S]*?)<\/g>/g)) {
    const name = label.split(' ')[0];
    const paths = [...body.matchAll(/<path d="([^"]*)"/g)].map(([, data]) => pointsOf(data));
    layers.set(name, [...(layers.get(name) ?? []), ...paths]);
  }
  return layers;
}

/** The points of path data, which moves to its first point and goes on from each to the next. */
function pointsOf(data: string): number[] {
  const points: number[] = [];
  for (const [text] of data.matchAll(/-?\d*\.?\d+/g))
    points.push(Number(text) + (points.length < 2 ? 0 : points[points.length - 2]));
  return data.endsWith('z') ? [...points, points[0], points[1]] : points;
}

/** The tones that the surfaces with even lines ask for. */
function wantedTones(scene: Scene, camera: Camera, options: DrawSVGOptions): WantedTones {
  const { drawn } = runToEnd(readScene(scene, camera, true));
  const { projection, placement } = placePicture(drawn, planOf(options));
  const { scale, left, top } = placement;
  const surfaces = drawn.surfaces.filter(canBeEven);
  const owners = ownersOf(drawn, surfaces);
  const sheet = runToEnd(Sheet.of(drawn, owners, projection, { scale, pen: PEN }));
  const bvh = runToEnd(Bvh.build(drawn.corners, drawn.sides, drawn.cutouts));
  const { translucency } = new LineDrawer(drawn, null, projection, bvh);
  const seen = { scene: drawn, projection, bvh, translucency };
  const read = surfaces.map((surface) => new EvenSurface(surface, seen, sheet.facing));
  const [columns, rows] = [sheet.columns, sheet.rows].map((count) => Math.floor(count / CELL));
  const size = CELL * sheet.size;
  const tones = new Float32Array(columns * rows).fill(Number.NaN);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const [x, y] = [(column + 0.5) * size, (row + 0.5) * size];
      const triangle = sheet.triangleAt(x, y);
      if (triangle < 0) continue;
      const surface = read[owners[triangle]];
      tones[row * columns + column] = surface.tonesAt(
        surface.placeAt(x / scale, y / scale, triangle),
        triangle,
        'traced',
      ).tone;
    }
  }
  return { tones, columns, rows, size, left, top };
}
