import { asPhase } from '../../mesh/phases.js';
import { SEEN_BACK, SEEN_FRONT } from '../Bvh.js';
import type { DrawnScene, EngravedSurface } from '../DrawnScene.js';
import type { Projection } from '../Projection.js';
import { type CarriedRun, carriedRuns, surfaceLinesOf } from './carryLines.js';
import { EvenSurface, type SeenScene } from './EvenSurface.js';
import { evenOut } from './evenOut.js';
import { LineFields } from './LineFields.js';
import { STEP } from './LineGrower.js';
import { LineLaws } from './LineLaws.js';
import type { LinePoints } from './LinePoints.js';
import { LAYS, type Lay, layerOf } from './layTones.js';
import { LineEnds } from './lineEnds.js';
import { placeLines } from './placeLines.js';
import { Sheet } from './Sheet.js';
import type { SurfaceLines } from './SurfaceLines.js';
import { type LineStrokes, strokesAlong } from './strokesAlong.js';
import { ToneGains } from './ToneGains.js';

/** Rounds of placing; all but the last teach how much ink the tone needs. */
const ROUNDS = 3;

/** Smaller pictures have no lines, in widths of the pen. */
const SMALLEST = 4;

/** Whether the lines of a surface can be placed on the sheet: it hides what is behind it, or is a ground, which is placed alone. */
export const canBeEven = ({ engraved, hides, look }: EngravedSurface): boolean =>
  engraved.hand === null && (hides || look.ground !== null);

/** A line of a pen on the picture. */
export interface EvenLine {
  layer: Lay['layer'];
  surface: EngravedSurface;
  /** Two numbers a point, pixels of the picture. */
  points: number[];
  /** Three numbers a point, world space; null for a line in one go. */
  world: Float64Array | null;
  /** Null for a line in one go. */
  strokes: LineStrokes | null;
}

/** The scene, and how it is drawn. */
interface EvenDrawing extends SeenScene {
  /** The width of the pen, millimetres; and millimetres per pixel. */
  pen: number;
  scale: number;
  /** Null for a picture of its own. */
  carrying: Carrying | null;
  /** The place of the surfaces in the order of drawing. */
  group: number;
}

/** Lines that are carried from frame to frame: those of the frame before, none for the first one, and those of this one. */
export interface Carrying {
  before: readonly SurfaceLines[];
  kept: SurfaceLines[];
}

/** The number of the surface of each triangle of a scene; −1 for none. */
export function ownersOf(scene: DrawnScene, surfaces: readonly EngravedSurface[]): Int32Array {
  const owners = new Int32Array(scene.sides.length).fill(-1);
  for (const [i, { surface }] of surfaces.entries()) for (const triangle of surface.parents) owners[triangle] = i;
  return owners;
}

/** The sides of the triangles of a scene that are seen; those of the surfaces are, also where they hide nothing. */
function seenSidesOf(scene: DrawnScene, surfaces: readonly EngravedSurface[]): Uint8Array {
  const sides = scene.sides.slice();
  for (const { hides, surface } of surfaces) {
    if (hides) continue;
    const seen = (surface.drawsFront ? SEEN_FRONT : 0) | (surface.drawsBack ? SEEN_BACK : 0);
    for (const triangle of surface.parents) sides[triangle] |= seen;
  }
  return sides;
}

/** Places lines of a pen on surfaces as far apart as the tone asks for; in the blocks of woodcuts, if all surfaces are such, as close as they fill them. Yields its progress. */
export function* evenLines(
  surfaces: readonly EngravedSurface[],
  { pen, scale, carrying, group, ...seen }: EvenDrawing,
): Generator<number, EvenLine[], void> {
  const { scene, projection, bvh } = seen;
  if (!(Math.min(projection.width, projection.height) * scale >= SMALLEST * pen)) return [];
  const owners = ownersOf(scene, surfaces);
  const sheet = yield* asPhase(
    Sheet.of({ ...scene, sides: seenSidesOf(scene, surfaces) }, owners, projection, { scale, pen }),
    0,
    0.1,
  );
  const read = surfaces.map((drawn) => new EvenSurface(drawn, seen, sheet.facing));
  const fields = yield* asPhase(LineFields.of(sheet, read, owners), 0.1, 0.4);
  const isBlock = surfaces[0].engraved.technique === 'woodcut';
  const ends = new LineEnds(sheet, bvh, projection);
  const lines: EvenLine[] = [];
  for (const [set, lay] of LAYS.entries()) {
    if (!fields.hasLines(set)) continue;
    const [from, to] = [set, set + 1].map((k) => 0.4 + (0.6 * k) / LAYS.length);
    const on = { scene, projection, sheet, surfaces: read, owners };
    const before = carrying?.before.find((lines) => lines.group === group && lines.set === set);
    const carried = before ? yield* asPhase(carriedRuns(before, on, pen), from, from) : [];
    const points = yield* asPhase(
      linesOf(new LineLaws(fields, set, pen, new ToneGains(fields, pen), isBlock), carried),
      from,
      to,
    );
    if (carrying) carrying.kept.push(yield* asPhase(surfaceLinesOf(points, { group, set }, on), to, to));
    for (let line = 0; line < points.lines; line++) {
      yield to;
      const middle = (points.starts[line] + points.starts[line + 1]) >> 1;
      const [x, y] = [points.x[middle], points.y[middle]];
      const owner = owners[sheet.triangleAt(x, y)];
      const place = read[owner].placeAt(x / scale, y / scale, sheet.triangleAt(x, y));
      const layer = layerOf(lay, read[owner].engraver(fields.engraverAt(x, y)).at(place).cut);
      const strokes = strokesAlong(points, line, { fields, set, surface: read[owner] });
      const found = wholeLine(points, line, strokes, ends, STEP * pen);
      const world = strokes ? worldOf(found, read[owner], sheet) : null;
      for (const numbers of [found, strokes?.shifts ?? []])
        for (let o = 0; o < numbers.length; o++) numbers[o] /= scale;
      keepOnPicture(found, projection);
      lines.push({ layer, surface: surfaces[owner], points: found, world, strokes });
    }
  }
  return lines;
}

/** Takes what lies beyond the edge of the picture back to it: the ends of a line along the line. */
function keepOnPicture(points: number[], { width, height }: Projection): void {
  const last = points.length - 2;
  for (let o = 2; o < last; o += 2) {
    points[o] = Math.min(Math.max(points[o], 0), width);
    points[o + 1] = Math.min(Math.max(points[o + 1], 0), height);
  }
  for (const [end, next] of [
    [0, 2],
    [last, last - 2],
  ]) {
    const [x, y] = [points[end], points[end + 1]];
    const [dx, dy] = [points[next] - x, points[next + 1] - y];
    const onto = (value: number, step: number, most: number): number =>
      step === 0 ? 0 : value < 0 ? -value / step : value > most ? (most - value) / step : 0;
    const share = Math.min(Math.max(onto(x, dx, width), onto(y, dy, height), 0), 1);
    points[end] += share * dx;
    points[end + 1] += share * dy;
  }
}

/** The points of a line to where its surface ends, to which its strokes are extended. */
function wholeLine(
  { x, y, ux, uy, starts }: LinePoints,
  line: number,
  strokes: LineStrokes | null,
  ends: LineEnds,
  step: number,
): number[] {
  const [first, last] = [starts[line], starts[line + 1] - 1];
  const points: number[] = [];
  const before = ends.beyond(x[first], y[first], -ux[first], -uy[first], step);
  const after = ends.beyond(x[last], y[last], ux[last], uy[last], step);
  if (before > 0) {
    points.push(x[first] - before * ux[first], y[first] - before * uy[first]);
    strokes?.margins.unshift(strokes.margins[0]);
    strokes?.shifts.unshift(strokes.shifts[0], strokes.shifts[1]);
  }
  for (let i = first; i <= last; i++) {
    // Ends that lie beyond their surface are taken back to it.
    const way = i === first ? -Math.min(before, 0) : i === last ? Math.min(after, 0) : 0;
    points.push(x[i] + way * ux[i], y[i] + way * uy[i]);
  }
  if (after > 0) {
    points.push(x[last] + after * ux[last], y[last] + after * uy[last]);
    strokes?.margins.push(strokes.margins[strokes.margins.length - 1]);
    strokes?.shifts.push(...strokes.shifts.slice(-2));
  }
  return points;
}

/** Where the points of a line lie in space: those at its very ends on the last triangle that is seen. */
function worldOf(points: readonly number[], surface: EvenSurface, sheet: Sheet): Float64Array {
  const world = new Float64Array(1.5 * points.length);
  let triangle = sheet.triangleAt(points[2], points[3]);
  for (let i = 0; 2 * i < points.length; i++) {
    const [x, y] = [points[2 * i], points[2 * i + 1]];
    const seen = sheet.triangleAt(x, y);
    if (seen >= 0 && surface.owns(seen)) triangle = seen;
    world.set(surface.placeAt(x / sheet.scale, y / sheet.scale, triangle).world, 3 * i);
  }
  return world;
}

function* linesOf(laws: LineLaws, carried: readonly CarriedRun[]): Generator<number, LinePoints, void> {
  for (let round = 1; round < ROUNDS; round++)
    laws.gains.learn(laws.set, yield* asPhase(placeLines(laws), (0.5 * (round - 1)) / ROUNDS, (0.5 * round) / ROUNDS));
  const placed = yield* asPhase(placeLines(laws, carried), 0.35, 0.5);
  return yield* asPhase(evenOut(laws, placed), 0.5, 1);
}
