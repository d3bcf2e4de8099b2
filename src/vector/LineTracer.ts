import type { Vec3 } from '../look/vectors.js';
import type { Chain, ChainBuilder } from './Chain.js';
import type { EngravedPlace, FamilyName } from './Engraver.js';
import { between, cornersOf, onPicture, STRIDE, type SurfacePlace } from './LineSurface.js';
import type { LevelSegments, Walk } from './levelSegments.js';
import { type FamilyMeasure, handStrokes, type Line, plottedMark, printedMark, sameLine } from './lineMarks.js';
import type { Tracing } from './readVertices.js';
import { isSameCell, type RowStroke, type RowsInShadow } from './shading/handStrokes.js';
import type { Shadowing, Tones } from './ToneReader.js';

/** The rank of the line through the origin, a multiple of all powers of two. */
const EVERY_RANK = 1000;

/** Distance between samples of strokes and textures, pixels; and the most samples over one triangle. */
const STROKE_STEP = 2;
const MOST_STEPS = 256;

/** How far beyond its ends, as seen from its row, the middle of a stroke is looked for, as a share of its length. */
const BEYOND = 1;

/** A place, with the numbers that it was read from. */
interface ReadPlace {
  numbers: ArrayLike<number>;
  engraved: EngravedPlace;
}

/** The appearance of a line at a place. */
export interface Measured {
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
  /** The strokes of a hand, whose row the line is, and the direction on the picture to which their offsets are. */
  strokes?: readonly RowStroke[];
  uphill?: readonly [number, number];
}

/** The appearance of a line, with the numbers of its place. */
export interface MeasuredPlace {
  numbers: Float64Array;
  measured: Measured;
}

/** Draws a line into chains, from node to node. */
export interface TracingPen {
  /** Continues to a node over a triangle. */
  to(node: number, triangle: number): void;
  /** Continues over the next triangle, whose widths at a node may differ slightly from those of the triangle before. */
  turn(node: number, triangle: number): void;
  /** The chains that have ink. isClosed: whether the line has come back to its start. */
  finish(isClosed: boolean): Chain[];
}

/** Follows lines over triangles and measures them. */
export class LineTracer {
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

  /**
   * The chains of a walk. Yields its progress.
   *
   * @param penFor takes up the pen that draws a line
   */
  *follow(
    { start, segments: list, isClosed }: Walk,
    penFor: (line: Line) => TracingPen,
  ): Generator<number, Chain[], void> {
    const { triangles, starts, ends } = this.segments;
    const pen = penFor(this.lineAt(start));
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
    return pen.finish(isClosed);
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
    const at = { numbers, engraved: this.tracing.engraver.at(place) };
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

  private measureIn(shadowing: Shadowing, { numbers, engraved }: ReadPlace, triangle: number, line: Line): Measured {
    const { place } = engraved;
    const { pen, projection, isDrawnIn, engraver, toneReader } = this.tracing;
    const isAlong = shadowing === 'traced' && engraver.hasRows && !isDrawnIn && !toneReader.isGround;
    const tones = this.tonesAt(place, isAlong ? 'none' : shadowing);
    const at = projection.project(...place.view);
    const nothing: Measured = { at, place, tones, half: 0, margin: -1, isBlank: false, isHole: false };
    if (isDrawnIn && !isDrawnIn(tones.turned)) return nothing;
    const measure = this.familyAt(engraved, tones, triangle);
    const { strokes, hand } = measure;
    if (hand) {
      const row = sameLine(hand, line);
      const inShadow = isAlong ? this.inShadow(engraved, triangle) : null;
      const found = handStrokes(measure, row, inShadow, BEYOND).flatMap((stroke) => {
        const aside = this.asideOf(numbers, triangle, stroke.shift, hand.uphill);
        return this.seenInMiddle(stroke, aside, triangle, isAlong, shadowing, row) ?? [];
      });
      return { ...nothing, margin: found.length > 0 ? 1 : -1, strokes: found, uphill: hand.uphill };
    }
    const { half, margin, shift } = pen === null ? printedMark(measure, line) : plottedMark(measure, line, pen);
    if (!strokes) return { ...nothing, half, margin };
    return { ...nothing, half, margin, shift: [shift * strokes.uphill[0], shift * strokes.uphill[1]] };
  }

  private familyAt(engraved: EngravedPlace, tones: Tones, triangle: number): FamilyMeasure {
    const measure = this.tracing.engraver.measure(this.family, engraved, tones);
    // The change per pixel of lines as they are drawn, so that they cover the right share.
    measure.perPixel = this.slopes[triangle] || measure.perPixel;
    return measure;
  }

  /**
   * A stroke of a row as the place in its middle sees it, which lies aside of the row and has a tone of its own; undefined if the stroke
   * is not there.
   */
  private seenInMiddle(
    stroke: RowStroke,
    numbers: ArrayLike<number>,
    triangle: number,
    isAlong: boolean,
    shadowing: Shadowing,
    row: number,
  ): RowStroke | undefined {
    const { places, engraver } = this.tracing;
    const engraved = engraver.at(places.read(numbers, triangle));
    const tones = this.tonesAt(engraved.place, isAlong ? 'none' : shadowing);
    const inShadow = isAlong ? this.inShadow(engraved, triangle) : null;
    const measure = this.familyAt(engraved, tones, triangle);
    return handStrokes(measure, row, inShadow).find((one) => isSameCell(one, stroke));
  }

  /** The family of a place in all shadows, and where along its rows they fall. */
  private inShadow(engraved: EngravedPlace, triangle: number): RowsInShadow {
    const { toneReader } = this.tracing;
    const { tone } = this.familyAt(engraved, this.tonesAt(engraved.place, 'all'), triangle);
    return { tone, takenAt: (step) => toneReader.takenAt(engraved.place, step) };
  }

  /** The numbers at a distance from a place on the picture, pixels, as if the triangle went on. */
  private asideOf(
    numbers: ArrayLike<number>,
    triangle: number,
    distance: number,
    way: readonly [number, number],
  ): Float64Array {
    const { surface, projection } = this.tracing;
    const { vertices } = surface;
    const corners = cornersOf(surface, triangle);
    const [[ax, ay], [bx, by], [cx, cy]] = corners.map((vertex) => onPicture(surface, vertex, projection));
    const [ux, uy, wx, wy] = [bx - ax, by - ay, cx - ax, cy - ay];
    const perArea = distance / (ux * wy - uy * wx || Infinity);
    const s = (way[0] * wy - way[1] * wx) * perArea;
    const t = (way[1] * ux - way[0] * uy) * perArea;
    const [a, b, c] = corners.map((vertex) => STRIDE * vertex);
    return Float64Array.from(
      numbers,
      (number, k) => number + s * (vertices[b + k] - vertices[a + k]) + t * (vertices[c + k] - vertices[a + k]),
    );
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

  /** Half of the width at which a stroke of a hand is drawn, pixels. */
  halfOf({ half }: RowStroke): number {
    const { pen } = this.tracing;
    return pen === null ? half : pen / 2;
  }

  parentOf(triangle: number): number {
    return this.tracing.surface.parents[triangle];
  }
}

/** Whether two places without textures certainly have the same tone. */
const isSame = (a: SurfacePlace, b: SurfacePlace): boolean =>
  isEqual(a.world, b.world) && isEqual(a.toneNormal, b.toneNormal) && a.occlusion === b.occlusion;

const isEqual = (a: Vec3, b: Vec3): boolean => a[0] === b[0] && a[1] === b[1] && a[2] === b[2];

/** The distance of two places on the picture, pixels. */
export const lengthBetween = ({ at: [x, y] }: Measured, { at: [toX, toY] }: Measured): number =>
  Math.hypot(toX - x, toY - y);
