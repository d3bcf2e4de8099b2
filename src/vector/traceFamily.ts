import type { Vec3 } from '../look/vectors.js';
import { asPhase } from '../mesh/phases.js';
import { type Chain, ChainBuilder } from './Chain.js';
import type { EngravedPlace, FamilyName } from './Engraver.js';
import { evenSpacing } from './evenSpacing.js';
import { between, cornersOf, type LineSurface, onPicture, STRIDE, type SurfacePlace, VIEW } from './LineSurface.js';
import { type LevelSegments, levelSegments, type Walk, walkSegments } from './levelSegments.js';
import { type Line, plottedMark, printedMark } from './lineMarks.js';
import type { Projection } from './Projection.js';
import { type FamilyVertices, ranksOfTriangles, type Tracing } from './readVertices.js';
import { hash01 } from './shading/hand.js';
import type { Shadowing, Tones, VertexTones } from './ToneReader.js';

/** The rank of the line through the origin, a multiple of all powers of two. */
const EVERY_RANK = 1000;
/** Distance between samples for edges of shadows, and the precision of an edge, times the change at it. Pixels. */
const SHADOW_STEP = 3;
const EDGE = 0.02;
/** The greatest change of a shadow between two points of a line that is not an edge. */
const SHADOW_CHANGE = 0.05;

/** Distance between samples of strokes and textures, pixels; and the most samples over one triangle. */
const STROKE_STEP = 2;
const MOST_STEPS = 256;

/** The visible side of each triangle of a surface. Yields its progress. */
export function* seenSides(surface: LineSurface, projection: Projection): Generator<number, Int8Array, void> {
  const { triangles, vertices, drawsFront, drawsBack } = surface;
  const { near } = projection.camera;
  const sides = new Int8Array(triangles.length / 3);
  for (let t = 0; t < sides.length; t++) {
    if (t % 2048 === 2047) yield t / sides.length;
    const corners = cornersOf(surface, t);
    if (corners.some((vertex) => -vertices[STRIDE * vertex + VIEW + 2] < near)) continue;
    const [[ax, ay], [bx, by], [cx, cy]] = corners.map((vertex) => onPicture(surface, vertex, projection));
    // Picture coordinates run down, so front faces are clockwise.
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (area < 0 && drawsFront) sides[t] = 1;
    else if (area > 0 && drawsBack) sides[t] = -1;
  }
  return sides;
}

/** Traces the lines of one family from its values at vertices. tones: of vertices, if known. Yields its progress. */
export function* traceFamily(
  tracing: Tracing,
  family: FamilyName,
  vertices: FamilyVertices,
  tones: VertexTones,
): Generator<number, Chain[], void> {
  const { surface, engraver } = tracing;
  const { values } = vertices;
  const ranks = yield* asPhase(ranksOfTriangles(tracing, vertices), 0, 0.02);
  const from = tracing.pen === null ? 0.02 : 0.4;
  const aside = yield* asPhase(evenSpacing(tracing, family, ranks, tones), 0.02, from);
  const segments = yield* asPhase(levelSegments(surface, values, ranks, engraver.hasSeams, aside), from, 0.5);
  const slopes = yield* asPhase(tracedSlopes(surface, values, segments.triangles, tracing.projection), 0.5, 0.55);
  const chains: Chain[] = [];
  const tracer = new LineTracer(tracing, family, segments, slopes);
  let done = 0;
  const progress = (): number => 0.55 + (0.45 * done) / segments.starts.length;
  for (const walk of walkSegments(segments.starts, segments.ends, segments.lines.length)) {
    if (walk !== null) {
      const before = progress();
      done += walk.segments.length;
      const chain = yield* asPhase(tracer.follow(walk), before, progress());
      if (chain) chains.push(chain);
    }
    yield progress();
  }
  return chains;
}

/** Follows lines over triangles and measures them. */
class LineTracer {
  private readonly unit: number;
  /** The last place, with its tones. */
  private readonly known: { [shadowing in Shadowing]?: { place: SurfacePlace; tones: Tones } } = {};

  constructor(
    private readonly tracing: Tracing,
    private readonly family: FamilyName,
    private readonly segments: LevelSegments,
    private readonly slopes: Float32Array,
  ) {
    this.unit = 2 ** segments.finest;
  }

  /** The chain of a walk; undefined if nothing of it is drawn. Yields its progress. */
  *follow({ start, segments: list, isClosed }: Walk): Generator<number, Chain | undefined, void> {
    const { triangles, starts, ends } = this.segments;
    const builder = new ChainBuilder();
    const line = this.lineAt(start);
    const pen = new LinePen(this, builder, line);
    let node = start;
    let before = -1;
    for (const [i, segment] of list.entries()) {
      if (i % 16 === 15) yield i / list.length;
      const triangle = triangles[segment];
      if (before < 0) pen.to(node, triangle);
      else if (this.isSameEdge(node, before, triangle)) pen.turn(node, triangle);
      // If the normals on two sides of an edge differ, the width has a step there.
      else pen.to(node, triangle);
      node = starts[segment] === node ? ends[segment] : starts[segment];
      pen.to(node, triangle);
      before = triangle;
    }
    return builder.hasLine ? builder.finish(isClosed, hash01(line.value)) : undefined;
  }

  /** The value of the line through a node, and the power of two in it. */
  private lineAt(node: number): Line {
    let number = this.segments.lines[node];
    const value = number * this.unit;
    if (number === 0) return { value, rank: EVERY_RANK };
    let rank = this.segments.finest;
    while (number % 2 === 0) {
      number /= 2;
      rank++;
    }
    return { value, rank };
  }

  /** The vertices of a triangle at the ends of the edge that a node lies on. */
  private edgeIn(node: number, triangle: number): readonly [number, number] {
    const { triangles, placeOf } = this.tracing.surface;
    const { from, to } = this.segments;
    let [a, b] = [-1, -1];
    for (let k = 0; k < 3; k++) {
      const vertex = triangles[3 * triangle + k];
      if (placeOf[vertex] === from[node]) a = vertex;
      else if (placeOf[vertex] === to[node]) b = vertex;
    }
    return [a, b];
  }

  private isSameEdge(node: number, one: number, other: number): boolean {
    const [a, b] = this.edgeIn(node, one);
    const [c, d] = this.edgeIn(node, other);
    return a === c && b === d;
  }

  /** The numbers at a node, interpolated in a triangle. */
  numbersAt(node: number, triangle: number): Float64Array {
    const [a, b] = this.edgeIn(node, triangle);
    return between(this.tracing.surface.vertices, a, b, this.segments.shares[node]);
  }

  /** The appearance of the line at a place of a triangle. */
  measure(numbers: ArrayLike<number>, triangle: number, line: Line): Measured {
    const { places, toneReader, isDrawnIn } = this.tracing;
    const place = places.read(numbers, triangle);
    const at = this.tracing.engraver.at(place);
    if (place.paint !== null && place.paint.alphaMargin < 0) {
      // In a hole there is no line.
      return { ...this.measureIn('none', at, triangle, line), margin: -1, isHole: true };
    }
    if (toneReader.hasSoftShadows && !isDrawnIn) {
      // Rays are skipped if there is no line even in the darkest shadow.
      const darkest = this.measureIn(toneReader.darkest, at, triangle, line);
      if (darkest.margin <= 0) return { ...darkest, isBlank: true };
    }
    return this.measureIn(toneReader.hasShadows ? 'traced' : 'none', at, triangle, line);
  }

  private measureIn(shadowing: Shadowing, engraved: EngravedPlace, triangle: number, line: Line): Measured {
    const { place } = engraved;
    const { engraver, pen, projection, isDrawnIn } = this.tracing;
    const tones = this.tonesAt(place, shadowing);
    const at = projection.project(...place.view);
    const nothing: Measured = { at, place, tones, half: 0, margin: -1, isBlank: false, isHole: false };
    if (isDrawnIn && !isDrawnIn(tones.turned)) return nothing;
    const measure = engraver.measure(this.family, engraved, tones);
    // The change per pixel of lines as they are drawn, so that they cover the right share.
    measure.perPixel = this.slopes[triangle] || measure.perPixel;
    const { half, margin, shift } = pen === null ? printedMark(measure, line) : plottedMark(measure, line, pen);
    const { strokes } = measure;
    if (!strokes) return { ...nothing, half, margin };
    return { ...nothing, half, margin, shift: [shift * strokes.uphill[0], shift * strokes.uphill[1]] };
  }

  /** The tones at a place. A place on an edge, which both of its triangles ask for, is computed once. */
  private tonesAt(place: SurfacePlace, shadowing: Shadowing): Tones {
    const { toneReader, places } = this.tracing;
    if (places.hasPaint) return toneReader.read(place, shadowing);
    const known = this.known[shadowing];
    if (known && isSame(known.place, place)) return known.tones;
    const tones = toneReader.read(place, shadowing);
    this.known[shadowing] = { place, tones };
    return tones;
  }

  /** Whether there may be edges of shadows or of holes. */
  get hasEdges(): boolean {
    return this.tracing.toneReader.hasShadows || this.tracing.places.hasPaint;
  }

  /** The difference between the shadows at two places; 0 if it does not matter, and 1 where lines turn or a hole begins. */
  shadowChange(one: Measured, other: Measured): number {
    if (one.isHole !== other.isHole) return 1;
    if (one.isBlank || other.isBlank || one.isHole) return 0;
    if (this.tracing.isDrawnIn && one.tones.turned !== other.tones.turned) return 1;
    return Math.abs(one.tones.shadows - other.tones.shadows);
  }

  /** Number of steps of a line between two places over a triangle: one, unless textures, strokes or wedges change within. */
  stepsTo(from: Measured, to: Measured): number {
    const { engraver, places } = this.tracing;
    if (engraver.technique === 'engraving' && !places.hasPaint) return 1;
    return Math.min(Math.max(Math.ceil(lengthBetween(from, to) / STROKE_STEP), 1), MOST_STEPS);
  }

  write(builder: ChainBuilder, { at, place, half, margin, shift }: Measured, triangle: number): void {
    builder.push(at, place.world, half, margin, this.tracing.surface.parents[triangle], place.field, shift);
  }

  parentOf(triangle: number): number {
    return this.tracing.surface.parents[triangle];
  }
}

/** Whether two places without textures certainly have the same tone. */
const isSame = (a: SurfacePlace, b: SurfacePlace): boolean =>
  isEqual(a.world, b.world) && isEqual(a.toneNormal, b.toneNormal) && a.occlusion === b.occlusion;

const isEqual = (a: Vec3, b: Vec3): boolean => a[0] === b[0] && a[1] === b[1] && a[2] === b[2];

interface Measured {
  /** On the picture. */
  at: readonly [number, number];
  place: SurfacePlace;
  tones: Tones;
  /** Whether the surface has a hole there. */
  isHole: boolean;
  half: number;
  margin: number;
  /** Whether there is no line, in shadow or not. */
  isBlank: boolean;
  /** Offset of the middle, pixels of the picture; undefined for none. */
  shift?: readonly [number, number];
}

/** The appearance of a line, with the numbers of its place. */
interface MeasuredPlace {
  numbers: Float64Array;
  measured: Measured;
}

/** Draws a line into a chain, from node to node. */
class LinePen {
  private last: MeasuredPlace | undefined;

  constructor(
    private readonly tracer: LineTracer,
    private readonly builder: ChainBuilder,
    private readonly line: Line,
  ) {}

  /** Continues to a node over a triangle. */
  to(node: number, triangle: number): void {
    const { tracer, line, last } = this;
    const numbers = tracer.numbersAt(node, triangle);
    const measured = tracer.measure(numbers, triangle, line);
    const steps = last ? tracer.stepsTo(last.measured, measured) : 1;
    for (let i = 1; last && i < steps; i++) {
      const between = last.numbers.map((number, k) => number + (i / steps) * (numbers[k] - number));
      this.write({ numbers: between, measured: tracer.measure(between, triangle, line) }, triangle);
    }
    this.write({ numbers, measured }, triangle);
  }

  private write(place: MeasuredPlace, triangle: number): void {
    const { tracer, builder, last } = this;
    if (last && tracer.hasEdges) this.lookBetween(last, place, triangle);
    tracer.write(builder, place.measured, triangle);
    this.last = place;
  }

  /** Continues over the next triangle. On flat triangles widths differ slightly, and the mean of both is used. */
  turn(node: number, triangle: number): void {
    const numbers = this.tracer.numbersAt(node, triangle);
    const measured = this.tracer.measure(numbers, triangle, this.line);
    this.builder.share(measured.half, measured.margin, this.tracer.parentOf(triangle));
    this.last = { numbers, measured };
  }

  /** Searches for shadow edges between two places, and adds points where shadows change: two at one place for a hard edge. */
  private lookBetween(start: MeasuredPlace, end: MeasuredPlace, triangle: number): void {
    const change = this.tracer.shadowChange(start.measured, end.measured);
    if (change === 0 && start.measured.isBlank && end.measured.isBlank) return;
    const length = lengthBetween(start.measured, end.measured);
    if (change <= SHADOW_CHANGE ? length <= SHADOW_STEP : Math.min(change, 1) * length <= EDGE) return;
    const { tracer, builder, line } = this;
    const numbers = start.numbers.map((number, k) => 0.5 * (number + end.numbers[k]));
    const measured = tracer.measure(numbers, triangle, line);
    const middle = { numbers, measured };
    this.lookBetween(start, middle, triangle);
    const isApart =
      tracer.shadowChange(start.measured, measured) + tracer.shadowChange(measured, end.measured) > SHADOW_CHANGE;
    if (change > SHADOW_CHANGE || isApart) tracer.write(builder, measured, triangle);
    this.lookBetween(middle, end, triangle);
  }
}

/** The distance of two places on the picture, pixels. */
const lengthBetween = ({ at: [x, y] }: Measured, { at: [toX, toY] }: Measured): number => Math.hypot(toX - x, toY - y);

/**
 * The change of a function per pixel on each triangle, along which lines are traced straight and evenly. 0 for triangles without area on
 * the picture.
 *
 * @param values of the function at the vertices
 * @param traced the triangles with lines, with repetitions
 */
function* tracedSlopes(
  surface: LineSurface,
  values: Float64Array,
  traced: ArrayLike<number>,
  projection: Projection,
): Generator<number, Float32Array, void> {
  const slopes = new Float32Array(surface.parents.length);
  for (let i = 0; i < traced.length; i++) {
    if (i % 2048 === 2047) yield i / traced.length;
    const t = traced[i];
    if (slopes[t] !== 0) continue;
    const [a, b, c] = cornersOf(surface, t);
    const [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map((vertex) => onPicture(surface, vertex, projection));
    const [ux, uy, wx, wy] = [bx - ax, by - ay, cx - ax, cy - ay];
    const area = ux * wy - uy * wx;
    if (area === 0) continue;
    const [du, dw] = [values[b] - values[a], values[c] - values[a]];
    slopes[t] = Math.hypot(du * wy - dw * uy, dw * ux - du * wx) / Math.abs(area);
  }
  return slopes;
}
