import { type Chain, ChainBuilder } from './Chain.js';
import { type Engraver, type FamilyName, LEAST_PEN_TONE } from './Engraver.js';
import { between, flatNormalOf, type LineSurface, placeFrom, STRIDE, type SurfacePlace, VIEW } from './LineSurface.js';
import { type LevelSegments, levelSegments, NO_RANK } from './levelSegments.js';
import type { Projection } from './Projection.js';
import type { DetailReader } from './paint/DetailReader.js';
import type { Paint, Painter } from './paint/Painter.js';
import type { Shadowing, Toner, Tones } from './Toner.js';
import { type Walk, walkSegments } from './walkSegments.js';

/** What the lines of a surface are traced with. */
export interface Tracing {
  surface: LineSurface;
  /** Null where the surface has no details. */
  details: DetailReader | null;
  /** Null where neither textures nor colours of vertices count. */
  painter: Painter | null;
  engraver: Engraver;
  toner: Toner;
  projection: Projection;
  /** Per triangle 1 where its front is seen, −1 where its back is, 0 where nothing is drawn of it. */
  sides: Int8Array;
  /** The width of a pen, pixels; null where widths are the tone. */
  pen: number | null;
}

/** A tone below this has no lines. */
const LEAST_TONE = 1e-4;
/** The rank of the line through the origin, a multiple of all powers of two. */
const EVERY_RANK = 1000;
/** The edge of a shadow is found in so many halvings. */
const HALVINGS = 10;

/** Which side of each triangle of a surface is drawn on the picture. Yields its progress. */
export function* seenSides(surface: LineSurface, projection: Projection): Generator<number, Int8Array, void> {
  const { triangles, vertices, drawsFront, drawsBack } = surface;
  const sides = new Int8Array(triangles.length / 3);
  for (let t = 0; t < sides.length; t++) {
    if (t % 2048 === 2047) yield t / sides.length;
    const corners = [0, 1, 2].map((k) => {
      const o = STRIDE * triangles[3 * t + k] + VIEW;
      const [x, y, z] = [vertices[o], vertices[o + 1], vertices[o + 2]];
      return { at: projection.project(x, y, z), isBefore: -z < projection.camera.near };
    });
    if (corners.some(({ isBefore }) => isBefore)) continue;
    const [a, b, c] = corners.map(({ at }) => at);
    // The picture runs down, so the front is clockwise there.
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area < 0 && drawsFront) sides[t] = 1;
    else if (area > 0 && drawsBack) sides[t] = -1;
  }
  return sides;
}

/** Traces the lines of one family. Yields its progress. */
export function* traceFamily(tracing: Tracing, family: FamilyName): Generator<number, Chain[], void> {
  const { surface, engraver } = tracing;
  const { values, ranks } = yield* readVertices(tracing, family);
  const segments = yield* levelSegments(surface, values, ranks, engraver.hasSeams);
  const chains: Chain[] = [];
  const tracer = new LineTracer(tracing, family, segments);
  let done = 0;
  for (const walk of walkSegments(segments.starts, segments.ends, segments.lines.length)) {
    const chain = tracer.follow(walk);
    if (chain) chains.push(chain);
    done += walk.segments.length;
    yield done / segments.starts.length;
  }
  return chains;
}

/** Textures are taken together over so much of the picture, or lines would become crumbs. Pixels. */
const FOOTPRINT = 2;
/** On a surface with textures a line is measured so often. Pixels. */
const PAINT_STEP = 2;

/** The place on a triangle that has these numbers. */
function placeOn(tracing: Tracing, numbers: ArrayLike<number>, triangle: number): SurfacePlace {
  const { surface, details, painter, sides, projection } = tracing;
  const place = placeFrom(numbers, flatNormalOf(surface, triangle), sides[triangle]);
  if (!details) return place;
  const parent = surface.parents[triangle];
  const read = details.read(parent, place.world);
  place.posed = details.posedMaps();
  if (painter) {
    painter.goTo(parent, details.edgesOf(parent));
    place.paint = painter.paintAt(read, FOOTPRINT * projection.unitsPerPixel(-place.view[2]));
    const { relief } = place.paint;
    if (relief) place.toneNormal = painter.bent(place.toneNormal, relief, details.cornersOf(parent));
  }
  return place;
}

/** The paints between which that of a place may lie. */
function paintsAt(
  { surface, details, painter }: Tracing,
  triangle: number,
  { world }: SurfacePlace,
): readonly (Paint | null)[] {
  if (!details || !painter) return NO_PAINT;
  return painter.boundsAt(details.read(surface.parents[triangle], world));
}

const NO_PAINT = [null];
/** What may be anywhere on a surface whose normals are bent. */
const DARKEST: Tones = { tone: 1, unshadowed: 0.5, shadows: 0 };

/** The function at every vertex, and how fine the lines of every triangle are. */
function* readVertices(
  tracing: Tracing,
  family: FamilyName,
): Generator<number, { values: Float64Array; ranks: Int16Array }, void> {
  const { surface, engraver, toner, sides, pen } = tracing;
  const { vertices, triangles, placeOf } = surface;
  const values = new Float64Array(placeOf.length);
  const octaves = new Float64Array(placeOf.length);
  const tones = new Float64Array(placeOf.length).fill(-1);
  const ranks = new Int16Array(sides.length).fill(NO_RANK);
  const shadowings: readonly Shadowing[] = toner.hasShadows ? ['none', 'all'] : ['none'];
  const leastTone = pen === null ? LEAST_TONE : LEAST_PEN_TONE;
  for (let t = 0; t < sides.length; t++) {
    if (t % 1024 === 1023) yield t / sides.length;
    if (sides[t] === 0) continue;
    let [finest, darkest] = [Infinity, 0];
    for (let k = 0; k < 3; k++) {
      const v = triangles[3 * t + k];
      if (tones[v] < 0) {
        const place = placeOn(tracing, between(vertices, v, v, 0), t);
        values[v] = engraver.valueAt(family, place);
        octaves[v] = Infinity;
        for (const paint of paintsAt(tracing, t, place)) {
          place.paint = paint;
          for (const shadowing of shadowings) {
            const read = tracing.painter?.hasRelief ? DARKEST : toner.read(place, shadowing);
            const measure = engraver.measure(family, place, read);
            tones[v] = Math.max(tones[v], measure.tone);
            octaves[v] = Math.min(octaves[v], pen === null ? measure.octave : engraver.penOctave(measure, pen));
          }
        }
      }
      finest = Math.min(finest, octaves[v]);
      darkest = Math.max(darkest, tones[v]);
    }
    if (darkest > leastTone) ranks[t] = Math.ceil(finest) - 1;
  }
  return { values, ranks };
}

/** Follows lines over triangles and measures them. */
class LineTracer {
  private readonly unit: number;

  constructor(
    private readonly tracing: Tracing,
    private readonly family: FamilyName,
    private readonly segments: LevelSegments,
  ) {
    this.unit = 2 ** segments.finest;
  }

  /** The chain of a walk; undefined if there is nothing to draw of it. */
  follow({ start, segments: list, isClosed }: Walk): Chain | undefined {
    const { triangles, starts, ends } = this.segments;
    const builder = new ChainBuilder();
    const pen = new LinePen(this, builder, this.lineAt(start));
    let node = start;
    let before = -1;
    for (const segment of list) {
      const triangle = triangles[segment];
      if (before < 0) pen.to(node, triangle);
      else if (this.isSameEdge(node, before, triangle)) pen.turn(node, triangle);
      // Where the normals on two sides of an edge differ, the width has a step.
      else pen.to(node, triangle);
      node = starts[segment] === node ? ends[segment] : starts[segment];
      pen.to(node, triangle);
      before = triangle;
    }
    return builder.hasLine ? builder.finish(isClosed) : undefined;
  }

  /** The value of the line through a node, the power of two in it and which of the lines of that power it is. */
  private lineAt(node: number): Line {
    let number = this.segments.lines[node];
    const value = number * this.unit;
    if (number === 0) return { value, rank: EVERY_RANK, index: 0 };
    let rank = this.segments.finest;
    while (number % 2 === 0) {
      number /= 2;
      rank++;
    }
    return { value, rank, index: (Math.abs(number) - 1) / 2 };
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

  /** The numbers of a node as a triangle has them. */
  numbersAt(node: number, triangle: number): Float64Array {
    const [a, b] = this.edgeIn(node, triangle);
    return between(this.tracing.surface.vertices, a, b, this.segments.shares[node]);
  }

  /** What the line is at numbers of a triangle. */
  measure(numbers: ArrayLike<number>, triangle: number, line: Line): Measured {
    const { toner, engraver, pen } = this.tracing;
    const place = placeOn(this.tracing, numbers, triangle);
    const tones = toner.read(place, toner.hasShadows ? 'traced' : 'none');
    const measure = engraver.measure(this.family, place, tones);
    const isHole = place.paint !== null && place.paint.standing < 0;
    const half = pen === null ? engraver.halfWidth(measure, line.value, line.rank) : pen / 2;
    if (isHole) return { place, tones, isHole, half, margin: -1 };
    const margin = pen === null ? half : engraver.penMargin(measure, line.rank, line.index, pen);
    return { place, tones, isHole, half, margin };
  }

  write(builder: ChainBuilder, { place, half, margin }: Measured, triangle: number): void {
    const { projection, surface } = this.tracing;
    builder.push(projection.project(...place.view), place.world, half, margin, surface.parents[triangle]);
  }

  /** In how many parts a line must be measured from one place of a triangle to another. */
  partsBetween(start: Float64Array, end: Float64Array): number {
    const { painter, projection } = this.tracing;
    if (!painter) return 1;
    const [a, b] = [start, end].map((n) => projection.project(n[VIEW], n[VIEW + 1], n[VIEW + 2]));
    return Math.max(1, Math.ceil(Math.hypot(a[0] - b[0], a[1] - b[1]) / PAINT_STEP));
  }

  parentOf(triangle: number): number {
    return this.tracing.surface.parents[triangle];
  }
}

interface Line {
  value: number;
  rank: number;
  index: number;
}

interface Measured {
  place: SurfacePlace;
  tones: Tones;
  /** Whether nothing of the surface is there. */
  isHole: boolean;
  half: number;
  margin: number;
}

/** Draws one line into a chain, from node to node. */
class LinePen {
  private last: { numbers: Float64Array; measured: Measured } | undefined;

  constructor(
    private readonly tracer: LineTracer,
    private readonly builder: ChainBuilder,
    private readonly line: Line,
  ) {}

  /** Goes on to a node over a triangle. */
  to(node: number, triangle: number): void {
    const { tracer, last } = this;
    const numbers = tracer.numbersAt(node, triangle);
    const parts = last ? tracer.partsBetween(last.numbers, numbers) : 1;
    for (let i = 1; i < parts; i++) this.advance(blended(last!.numbers, numbers, i / parts), triangle);
    this.advance(numbers, triangle);
  }

  private advance(numbers: Float64Array, triangle: number): void {
    const { tracer, builder, line, last } = this;
    const measured = tracer.measure(numbers, triangle, line);
    if (last && !isAlike(last.measured, measured)) this.crossEdge(last, numbers, triangle);
    tracer.write(builder, measured, triangle);
    this.last = { numbers, measured };
  }

  /** Goes on over the triangle beside. On flat triangles widths differ a little from one to the next: it is the mean of both. */
  turn(node: number, triangle: number): void {
    const numbers = this.tracer.numbersAt(node, triangle);
    const measured = this.tracer.measure(numbers, triangle, this.line);
    this.builder.share(measured.half, measured.margin, this.tracer.parentOf(triangle));
    this.last = { numbers, measured };
  }

  /** Writes two points at the edge of a shadow or of a hole, with what is on either side. */
  private crossEdge(
    { numbers: start, measured }: { numbers: Float64Array; measured: Measured },
    end: Float64Array,
    triangle: number,
  ): void {
    const { tracer, builder, line } = this;
    const at = (share: number) => tracer.measure(blended(start, end, share), triangle, line);
    let [low, high] = [0, 1];
    for (let i = 0; i < HALVINGS; i++) {
      const middle = 0.5 * (low + high);
      if (isAlike(at(middle), measured)) low = middle;
      else high = middle;
    }
    tracer.write(builder, at(low), triangle);
    tracer.write(builder, at(high), triangle);
  }
}

/** Whether two places lie in the same shadows, and both on the surface or both in its holes. */
const isAlike = (one: Measured, other: Measured): boolean =>
  one.tones.shadows === other.tones.shadows && one.isHole === other.isHole;

const blended = (start: Float64Array, end: Float64Array, share: number): Float64Array =>
  start.map((number, k) => number + share * (end[k] - number));
