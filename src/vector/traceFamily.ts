import { asPhase } from '../mesh/phases.js';
import type { Chain } from './Chain.js';
import type { FamilyName } from './Engraver.js';
import { evenSpacing } from './evenSpacing.js';
import { LinePen } from './LinePen.js';
import { cornersOf, type LineSurface, onPicture, STRIDE, VIEW } from './LineSurface.js';
import { LineTracer, type TracingPen } from './LineTracer.js';
import { levelSegments, walkSegments } from './levelSegments.js';
import type { Line } from './lineMarks.js';
import type { Projection } from './Projection.js';
import { RowPen } from './RowPen.js';
import { type FamilyVertices, ranksOfTriangles, type Tracing } from './readVertices.js';
import type { VertexTones } from './ToneReader.js';

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
  const penFor = (line: Line): TracingPen => new (engraver.hasRows ? RowPen : LinePen)(tracer, line);
  let done = 0;
  const progress = (): number => 0.55 + (0.45 * done) / segments.starts.length;
  for (const walk of walkSegments(segments.starts, segments.ends, segments.lines.length)) {
    if (walk !== null) {
      const before = progress();
      done += walk.segments.length;
      const found = yield* asPhase(tracer.follow(walk, penFor), before, progress());
      for (const chain of found) chains.push(chain);
    }
    yield progress();
  }
  return chains;
}

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
