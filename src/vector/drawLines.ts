import { asPhase } from '../mesh/phases.js';
import type { Task } from '../worker/TaskSet.js';
import { Bvh } from './Bvh.js';
import type { DrawingPlan, DrawnScene } from './DrawnScene.js';
import { drawDots } from './drawDots.js';
import { LAYERS, LineDrawer } from './LineDrawer.js';
import { Projection } from './Projection.js';
import { finishDots } from './paths/finishDots.js';
import { finishPaths, type PathCounts, type Placement } from './paths/finishPaths.js';
import { type SVGLayer, writeSVG } from './paths/writeSVG.js';

/** The phases of a drawing, in order. */
const PHASES = ['building', 'outlines', 'surfaces', 'backgrounds', 'dots', 'finishing'] as const;
type DrawingPhase = (typeof PHASES)[number];

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

/** A drawing with its statistics. */
export interface LineDrawing extends PathCounts {
  svg: string;
  /** Traced pieces of lines, before hidden ones were removed. */
  segments: number;
}

const MILLIMETRES_PER_INCH = 25.4;

/** Draws a scene as lines. Yields its progress from 0 to 1. */
export function* drawLines(scene: DrawnScene, plan: DrawingPlan): Generator<number, LineDrawing, void> {
  const { projection, placement } = placePicture(scene, plan);
  const phases = drawingPhases(scene);
  const bvh = yield* asPhase(Bvh.build(scene.corners, scene.sides, scene.cutouts), ...phases.building);
  const pen = plan.pen === null ? null : plan.pen / placement.scale;
  const least = pen === null ? plan.leastWidth / placement.scale : 0;
  const drawer = new LineDrawer(scene, pen, projection, bvh, least, 1 / placement.scale);
  yield* asPhase(drawer.drawOutlines(), ...phases.outlines);
  yield* asPhase(drawer.drawSurfaces(), ...phases.surfaces);
  yield* asPhase(drawer.drawBackgrounds(), ...phases.backgrounds);
  const stippled = yield* asPhase(drawDots(scene, projection, bvh, drawer.translucency, drawer.above), ...phases.dots);
  const layers = LAYERS.flatMap((name) => drawer.layers.filter((layer) => layer.name === name));
  const [from, to] = phases.finishing;
  const middle = scene.stippled.length > 0 ? 0.5 * (from + to) : to;
  const { written, counts } = yield* asPhase(finishPaths(layers, plan, projection, placement), from, middle);
  const named = layers.map(({ name, ink, opacity }, i): SVGLayer => {
    const isAlone = layers.filter((layer) => layer.name === name).length === 1;
    return { name: isAlone ? name : `${name} ${ink}`, ink, opacity, paths: written[i] };
  });
  for (const { ink, dots } of stippled) {
    const finished = yield* asPhase(finishDots(dots, plan, placement), middle, to);
    const name = stippled.length === 1 ? 'stipple' : `stipple ${ink}`;
    named.push({ name, ink, opacity: 1, paths: finished.written });
    for (const name of Object.keys(counts) as (keyof PathCounts)[]) counts[name] += finished.counts[name];
  }
  const { left: x, top: y, scale } = placement;
  const [width, height] = [scale * projection.width, scale * projection.height];
  const picture = plan.picture === null ? null : { url: plan.picture, x, y, width, height };
  return { svg: writeSVG({ ...plan, picture }, named), segments: drawer.segments, ...counts };
}

/** Fits the picture of the camera into the middle of the sheet, within the margin. */
function placePicture({ camera }: DrawnScene, plan: DrawingPlan): { projection: Projection; placement: Placement } {
  // The middle of a stroke keeps this distance from the edge, so that all of it lies on the sheet.
  const margin = Math.max(plan.margin, (plan.pen ?? 0) / 2);
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
