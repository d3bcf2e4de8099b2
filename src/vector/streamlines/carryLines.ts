import { vectorAt } from '../../look/vectors.js';
import type { DrawnScene } from '../DrawnScene.js';
import type { Projection } from '../Projection.js';
import type { EvenSurface } from './EvenSurface.js';
import { STEP } from './LineGrower.js';
import { type LinePoints, UNNUMBERED } from './LinePoints.js';
import type { Sheet } from './Sheet.js';
import type { SurfaceLines } from './SurfaceLines.js';

/** What lines are carried to and from: the surfaces of one group on a sheet. */
export interface CarriedTo {
  scene: DrawnScene;
  projection: Projection;
  sheet: Sheet;
  surfaces: readonly EvenSurface[];
  owners: Int32Array;
}

/** A part of a line of the frame before that is seen, in steps along it. Millimetres on the sheet. */
export interface CarriedRun {
  x: number[];
  y: number[];
  lot: number;
  id: number;
  /** The number of points of the whole line. */
  whole: number;
}

/** Points per step. */
const CHUNK = 1024;
/** A point is seen if what is seen there lies no farther away than so many widths of the pen. */
const SEEN_WITHIN = 1;

/** The places of lines on their surfaces. Yields now and then. */
export function* surfaceLinesOf(
  points: LinePoints,
  { group, set }: Pick<SurfaceLines, 'group' | 'set'>,
  { scene, sheet, surfaces, owners }: CarriedTo,
): Generator<number, SurfaceLines, void> {
  const triangles = new Int32Array(points.count);
  const weights = new Float64Array(2 * points.count);
  for (let i = 0; i < points.count; i++) {
    if (i % CHUNK === 0) yield 1;
    const triangle = sheet.triangleAt(points.x[i], points.y[i]);
    triangles[i] = triangle;
    if (triangle < 0) continue;
    const [x, y] = [points.x[i] / sheet.scale, points.y[i] / sheet.scale];
    const [, b, c] = surfaces[owners[triangle]].weightsAt(x, y, triangle);
    weights[2 * i] = b;
    weights[2 * i + 1] = c;
  }
  const { starts, lots, ids } = points;
  return { group, set, count: scene.sides.length, triangles, weights, starts, lots, ids };
}

/** The parts of lines of the frame before that are seen in this one. None if the scene has other triangles. Yields now and then. */
export function* carriedRuns(lines: SurfaceLines, to: CarriedTo, pen: number): Generator<number, CarriedRun[], void> {
  if (lines.count !== to.scene.sides.length) return [];
  const runs: CarriedRun[] = [];
  for (let line = 0; line + 1 < lines.starts.length; line++) {
    let id = lines.ids[line];
    let run: CarriedRun | null = null;
    for (let i = lines.starts[line]; i < lines.starts[line + 1]; i++) {
      if (i % CHUNK === 0) yield 0;
      const place = placeOn(lines, i, to, pen);
      if (place && run) goTo(run, place, STEP * pen);
      else if (place) {
        const whole = lines.starts[line + 1] - lines.starts[line];
        run = { x: [place[0]], y: [place[1]], lot: lines.lots[line], id, whole };
        runs.push(run);
        // Another part of a line is a line of its own.
        id = UNNUMBERED;
      } else run = null;
    }
  }
  return runs;
}

/** Where a point lies on the sheet; null if it is not seen. */
function placeOn(
  { triangles, weights }: SurfaceLines,
  i: number,
  { scene, projection, sheet, surfaces, owners }: CarriedTo,
  pen: number,
): readonly [number, number] | null {
  const triangle = triangles[i];
  if (triangle < 0 || owners[triangle] < 0) return null;
  const [b, c] = [weights[2 * i], weights[2 * i + 1]];
  const [p, q, r] = [0, 3, 6].map((k) => vectorAt(scene.corners, 9 * triangle + k));
  const world = [0, 1, 2].map((k) => (1 - b - c) * p[k] + b * q[k] + c * r[k]) as [number, number, number];
  const view = projection.toView(world);
  if (-view[2] < projection.camera.near) return null;
  const [px, py] = projection.project(...view);
  const [x, y] = [px * sheet.scale, py * sheet.scale];
  const seen = sheet.triangleAt(x, y);
  if (seen < 0 || owners[seen] !== owners[triangle]) return null;
  const { world: there } = surfaces[owners[seen]].placeAt(px, py, seen);
  const away = Math.hypot(there[0] - world[0], there[1] - world[1], there[2] - world[2]);
  return (away * sheet.scale) / projection.unitsPerPixel(-view[2]) > SEEN_WITHIN * pen ? null : [x, y];
}

/** Goes on to a place in whole steps. */
function goTo({ x, y }: CarriedRun, [toX, toY]: readonly [number, number], step: number): void {
  for (;;) {
    const [fromX, fromY] = [x[x.length - 1], y[y.length - 1]];
    const length = Math.hypot(toX - fromX, toY - fromY);
    if (length < step) return;
    x.push(fromX + (step / length) * (toX - fromX));
    y.push(fromY + (step / length) * (toY - fromY));
  }
}
