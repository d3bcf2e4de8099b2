import { mix } from '../look/vectors.js';
import { asPhase } from '../mesh/phases.js';
import type { Task } from '../worker/TaskSet.js';
import { Bvh } from './Bvh.js';
import type { DrawingPlan, DrawnScene } from './DrawnScene.js';
import { drawDots } from './drawDots.js';
import { LineDrawer, type PenWidths } from './LineDrawer.js';
import { Projection } from './Projection.js';
import { finishDots } from './paths/finishDots.js';
import { finishPaths, joinedInk, type PathCounts, type Placement, type WrittenPath } from './paths/finishPaths.js';
import { limitPasses, type Penned } from './plot/limitPasses.js';
import { noteLines } from './plot/noteLines.js';
import { type FileLayer, fileLayers } from './plot/penLayers.js';
import { LAYERS, type PenPart, penWidth, thickestPen } from './plot/pens.js';
import { plotTimes } from './plot/plotTime.js';
import { filesOfPens, plotterFile, plotterLayers } from './plot/plotterLayers.js';
import { writeDxf } from './plot/writeDxf.js';
import type { SurfaceLines } from './streamlines/SurfaceLines.js';

/** The phases of a drawing, in order. */
const PHASES = ['building', 'outlines', 'surfaces', 'backgrounds', 'dots', 'finishing'] as const;
type DrawingPhase = (typeof PHASES)[number];

/** The share of finishing that is taken by the limit of passes. */
const LIMITED = 0.3;

/** The number of triangles above which they take more time than lines. */
const MANY = 300_000;

/** Start and end of each phase, as shares of the whole, by its estimated duration, so that progress rises evenly. */
function drawingPhases(scene: DrawnScene): Record<DrawingPhase, readonly [from: number, to: number]> {
  const triangles = scene.sides.length;
  const many = triangles / (triangles + MANY);
  const lasts = (things: readonly unknown[], share: number): number => (things.length > 0 ? share : 0);
  const weights: Record<DrawingPhase, number> = {
    building: 0.04 + 0.16 * many,
    outlines: lasts(scene.outlines, 0.22),
    surfaces: lasts(scene.surfaces, 0.6),
    backgrounds: lasts(scene.backgrounds, 0.03),
    dots: lasts(scene.stippled, 0.6),
    finishing: 0.14 - 0.1 * many,
  };
  const sum = PHASES.reduce((total, phase) => total + weights[phase], 0);
  let end = 0;
  const spans = PHASES.map((phase) => {
    const start = end;
    end += weights[phase] / sum;
    return [phase, [start, Math.min(end, 1)]] as const;
  });
  return Object.fromEntries(spans) as Record<DrawingPhase, readonly [number, number]>;
}

/** A layer of a drawing. Lengths in millimetres. */
export interface DrawnLayer extends PathCounts {
  /** As in the file, without its number. */
  name: string;
  /** Such as `#1c1a17`. */
  ink: string;
  /** The width of the pen; null where paths are filled. */
  pen: number | null;
  /** The estimated time of plotting, seconds; null where paths are filled. */
  plotSeconds: number | null;
  /** The time from the beginning of the layer at which each path is drawn, seconds; null where paths are filled. */
  pathSeconds: Float64Array | null;
}

/** A drawing with its statistics. */
export interface LineDrawing extends PathCounts {
  svg: string;
  /** A file for each pen, if asked for. */
  files: readonly { name: string; svg: string }[];
  /** The drawing in DXF, if asked for. */
  dxf: string | null;
  layers: readonly DrawnLayer[];
  /** The estimated time of plotting, seconds, without changes of pens; null where paths are filled. */
  plotSeconds: number | null;
  /** Traced pieces of lines, before hidden ones were removed. */
  segments: number;
  /** The even lines on their surfaces, which the next frame takes over; null for a picture of its own. */
  surfaceLines: readonly SurfaceLines[] | null;
}

const MILLIMETRES_PER_INCH = 25.4;

/** Draws a scene as lines. Yields its progress from 0 to 1. */
export function* drawLines(scene: DrawnScene, plan: DrawingPlan): Generator<number, LineDrawing, void> {
  const { projection, placement } = placePicture(scene, plan);
  const phases = drawingPhases(scene);
  const bvh = yield* asPhase(Bvh.build(scene.corners, scene.sides, scene.cutouts), ...phases.building);
  const { pens } = plan;
  const { scale } = placement;
  const widths = pens && ((part: PenPart, ink: string) => penWidth(pens, part, ink) / scale);
  const least = pens === null ? plan.leastWidth / scale : 0;
  const drawer = new LineDrawer(scene, widths, projection, bvh, least, 1 / scale);
  yield* asPhase(drawer.drawOutlines(), ...phases.outlines);
  const carrying = plan.before && { before: plan.before, kept: [] };
  yield* asPhase(drawer.drawSurfaces(plan.lines === 'even', carrying), ...phases.surfaces);
  yield* asPhase(drawer.drawBackgrounds(), ...phases.backgrounds);
  const dots = yield* asPhase(drawDots(scene, projection, bvh, drawer.translucency, drawer.above), ...phases.dots);
  const lines = LAYERS.flatMap((name) => drawer.layers.filter((layer) => layer.name === name));
  const [from, to] = phases.finishing;
  const limiting = limited({ lines, dots }, widths, plan, projection, scale);
  const left = yield* asPhase(limiting, from, mix(from, to, LIMITED));
  const finishing = finishLayers(fileLayers(left.lines, left.dots, pens), plan, projection, placement);
  const finished = yield* asPhase(finishing, mix(from, to, LIMITED), to);
  return {
    ...written(finished, plan, projection, placement),
    segments: drawer.segments,
    surfaceLines: carrying?.kept ?? null,
  };
}

/** Lines and dots as often over one another as paper holds. widths: of pens, null for a print. */
function* limited(
  { lines, dots }: Penned,
  widths: PenWidths | null,
  { maxPasses, shortest }: DrawingPlan,
  { width, height }: Projection,
  scale: number,
): Generator<number, Penned, void> {
  if (widths === null) return { lines, dots };
  const joined = lines.map((layer) => ({ ...layer, paths: joinedInk(layer.paths, scale) }));
  const limit = { passes: maxPasses, widthOf: widths, shortest: shortest / scale, width, height };
  return yield* limitPasses({ lines: joined, dots }, limit);
}

/** A layer with its paths as they are written. */
interface FinishedLayer {
  layer: FileLayer;
  written: readonly WrittenPath[];
  counts: PathCounts;
}

function* finishLayers(
  layers: readonly FileLayer[],
  { shortest, order }: DrawingPlan,
  projection: Projection,
  placement: Placement,
): Generator<number, FinishedLayer[], void> {
  const finished: FinishedLayer[] = [];
  for (const [i, layer] of layers.entries()) {
    const finish = { pen: layer.pen, shortest, order, placement };
    const finishing = layer.dots ? finishDots(layer.dots, finish) : finishPaths(layer.paths, finish, projection);
    const { written, counts } = yield* asPhase(finishing, i / layers.length, (i + 1) / layers.length);
    if (written.length > 0) finished.push({ layer, written, counts });
  }
  return finished;
}

const NOTHING: PathCounts = { paths: 0, points: 0, travelBefore: 0, travelAfter: 0, drawn: 0 };

function written(
  finished: readonly FinishedLayer[],
  plan: DrawingPlan,
  projection: Projection,
  { left: x, top: y, scale }: Placement,
): Omit<LineDrawing, 'segments' | 'surfaceLines'> {
  const { pens, plotter } = plan;
  const [width, height] = [scale * projection.width, scale * projection.height];
  const picture = plan.picture === null ? null : { url: plan.picture, x, y, width, height };
  const counts = { ...NOTHING };
  const layers = finished.map(({ layer: { name, ink, pen, speed }, written, counts }): DrawnLayer => {
    const pathSeconds = pen === null ? null : plotTimes(written, plotter, speed);
    return { name, ink, pen, ...counts, pathSeconds, plotSeconds: pathSeconds && (pathSeconds.at(-1) ?? 0) };
  });
  for (const layer of layers)
    for (const name of Object.keys(counts) as (keyof PathCounts)[]) counts[name] += layer[name];
  const svgLayers = plotterLayers(finished, pens);
  const sheet = { ...plan, picture, note: plan.note === null ? [] : noteLines(plan.note, layers) };
  return {
    svg: plotterFile(svgLayers, pens, sheet),
    files: plan.isSplit ? filesOfPens(svgLayers, sheet) : [],
    dxf: plan.hasDxf ? writeDxf(plan.height, finished) : null,
    layers,
    plotSeconds: pens && layers.reduce((sum, layer) => sum + layer.plotSeconds!, 0),
    ...counts,
  };
}

/** Fits the picture of the camera into the middle of the sheet, within the margin. */
export function placePicture(
  { camera }: DrawnScene,
  plan: DrawingPlan,
): { projection: Projection; placement: Placement } {
  // The middle of a stroke keeps this distance from the edge, so that all of it lies on the sheet.
  const margin = Math.max(plan.margin, plan.pens ? thickestPen(plan.pens) / 2 : 0);
  const aspect = camera.projection[5] / camera.projection[0];
  const height = Math.min(plan.height - 2 * margin, (plan.width - 2 * margin) / aspect);
  const width = height * aspect;
  const scale = MILLIMETRES_PER_INCH / plan.dpi;
  return {
    projection: new Projection(camera, width / scale, height / scale),
    placement: { scale, left: (plan.width - width) / 2, top: (plan.height - height) / 2 },
  };
}

const drawing: Task<{ scene: DrawnScene; plan: DrawingPlan }, LineDrawing> = {
  run: ({ scene, plan }) => drawLines(scene, plan),
};

/** The tasks of the worker that draws lines. */
export const lineTasks = { drawLines: drawing };
